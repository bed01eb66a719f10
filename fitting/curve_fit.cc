#include "fitting/curve_fit.h"

#include "fitting/conventions.h"
#include "meshing/errors.h"
#include "meshing/number_text.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace dpcontact
{
  namespace
  {
    /// A branch in units of the yield point.
    struct ScaledBranch
    {
      std::vector<double> force;  ///< F/F_y
      std::vector<double> offset; ///< (δ − origin)/δ_y
      double              origin; ///< 0 or δ_res/δ_y
    };

    ScaledBranch
    scale(const ResampledBranch &branch, const double force_yield, const double approach_yield)
    {
      ScaledBranch scaled;
      scaled.origin = branch.origin / approach_yield;
      for (std::size_t i = 0; i < branch.x.size(); ++i)
        {
          scaled.offset.push_back(branch.x[i] / approach_yield);
          scaled.force.push_back(branch.force[i] / force_yield);
        }
      return scaled;
    }

    BranchFit fit_branch(const ScaledBranch &branch, const FitOptions &options)
    {
      // Points i ≥ window_start · n, counted from 1; rounding must not decide on the first.
      const double              first = std::ceil(options.window_start * options.n_points - 1e-9);
      const auto                skip  = static_cast<std::ptrdiff_t>(std::max(0., first - 1));
      const std::vector<double> x(branch.offset.begin() + skip, branch.offset.end());
      const std::vector<double> y(branch.force.begin() + skip, branch.force.end());

      // Fitted over δ − origin, which keeps the digits that a large origin would cost.
      BranchFit result;
      result.fit =
        fit_power_law(branch.offset, branch.force, 0, Origin::fixed, options.least_squares);
      result.window             = fit_power_law(x, y, 0, Origin::fixed, options.least_squares);
      result.coefficient_change = result.window.law.coefficient / result.fit.law.coefficient - 1;
      result.exponent_change    = result.window.law.exponent / result.fit.law.exponent - 1;
      result.alternatives   = fit_alternatives(branch.offset, branch.force, options.least_squares);
      result.fit.law.origin = result.window.law.origin = branch.origin;
      return result;
    }

    double published_error(const PowerLawFit &fit)
    {
      return published_standard_error(fit.law.coefficient,
                                      fit.law.exponent,
                                      fit.covariance[0][0],
                                      fit.covariance[0][1],
                                      fit.covariance[1][1]);
    }
  } // namespace

  void FitOptions::check() const
  {
    if (n_points < 10)
      throw InputError("fit: n_points is " + std::to_string(n_points) + "; at least 10 are needed");
    if (!(window_start >= 0 && window_start <= 0.5))
      throw InputError("fit: window_start is " + number_text(window_start) +
                       "; it must lie between 0 and 0.5");
    least_squares.check();
  }

  bool BranchFit::power_law_is_best() const
  {
    return std::all_of(alternatives.begin(), alternatives.end(), [&](const AlternativeFit &other) {
      return fit.report.rmse < other.report.rmse;
    });
  }

  double residual_approach(const double approach_max,
                           const double approach_yield,
                           const double force_max,
                           const double force_yield,
                           const double m,
                           const double n)
  {
    return approach_max - approach_yield * std::pow(force_max / (m * force_yield), 1 / n);
  }

  CurveFit fit_curve(const Curve      &curve,
                     const double      force_yield,
                     const double      approach_yield,
                     const FitOptions &options)
  {
    options.check();
    for (const double value : {force_yield, approach_yield})
      if (!(std::isfinite(value) && value > 0))
        throw InputError("fit: force and approach at first yield are " + number_text(force_yield) +
                         " N and " + number_text(approach_yield) + " m; both must be positive");

    const ResampledBranch loading          = resample(curve, Branch::loading, options.n_points);
    const ResampledBranch unloading        = resample(curve, Branch::unloading, options.n_points);
    const ScaledBranch    scaled_unloading = scale(unloading, force_yield, approach_yield);

    CurveFit result{};
    result.force_yield       = force_yield;
    result.approach_yield    = approach_yield;
    result.force_max         = loading.force.back();
    result.approach_max      = loading.x.back();
    result.residual_approach = unloading.origin;
    result.loading           = fit_branch(scale(loading, force_yield, approach_yield), options);
    result.unloading         = fit_branch(scaled_unloading, options);
    result.unloading_free    = fit_power_law(
      scaled_unloading.offset, scaled_unloading.force, 0, Origin::free, options.least_squares);
    result.unloading_free.law.origin += scaled_unloading.origin;

    const PowerLaw &up = result.loading.fit.law, &down = result.unloading.fit.law;
    result.residual_approach_fitted = residual_approach(result.approach_max,
                                                        approach_yield,
                                                        result.force_max,
                                                        force_yield,
                                                        down.coefficient,
                                                        down.exponent);
    result.published                = {published_coefficient(up.coefficient, up.exponent),
                                       published_coefficient(down.coefficient, down.exponent),
                                       published_error(result.loading.fit),
                                       published_error(result.unloading.fit),
                                       published_approach_yield(approach_yield)};
    return result;
  }
} // namespace dpcontact
