#ifndef DPCONTACT_FITTING_CURVE_FIT_H
#define DPCONTACT_FITTING_CURVE_FIT_H

#include "fitting/alternatives.h"
#include "fitting/power_law.h"
#include "fitting/resample.h"
#include "solver/problem/curve.h"

#include <vector>

namespace dpcontact
{
  /// How a curve is fitted.
  struct FitOptions
  {
    unsigned int        n_points     = 200; ///< n of the points i x_max/n on each branch
    double              window_start = 0.1; ///< the second fits use x ≥ window_start · x_max
    LeastSquaresOptions least_squares;

    /// @throws InputError naming the option, its value and its range.
    void check() const;
  };

  /// The power law of one branch, in F/F_y over δ/δ_y.
  struct BranchFit
  {
    PowerLawFit fit;    ///< on all points
    PowerLawFit window; ///< on the points of the window only

    /// (window − fit)/fit: how much coefficient and exponent depend on the window.
    double coefficient_change = 0;
    double exponent_change    = 0;

    std::vector<AlternativeFit> alternatives; ///< on the same points as `fit`, over δ/δ_y − origin

    /// Whether the power law's RMSE is below that of every alternative.
    bool power_law_is_best() const;
  };

  /// The coefficients in the published convention (conventions.h), whose δ_y is that of one sphere.
  /// The exponents are the same in both conventions.
  struct PublishedConvention
  {
    double a;                ///< a 2^(−b)
    double m;                ///< m 2^(−n)
    double a_standard_error; ///< from the covariance of a and b
    double m_standard_error; ///< from the covariance of m and n
    double approach_yield;   ///< δ_y per sphere, half of the mutual one, m
  };

  /// Everything that is fitted to one curve. Except in `published` the convention is the consistent
  /// one: δ and δ_y are mutual approaches, so that a, m → 1 and b, n → 1.5 in the elastic limit.
  /// Equation numbers are those of Wang et al. (2018).
  struct CurveFit
  {
    double force_yield;       ///< F_y, N
    double approach_yield;    ///< δ_y, m
    double force_max;         ///< N
    double approach_max;      ///< m
    double residual_approach; ///< δ_res: δ of the unloading branch where F = 0, m

    BranchFit loading;   ///< eq (16): a, b
    BranchFit unloading; ///< eq (17): m, n; its origin is the curve's δ_res/δ_y

    /// Eq (17) with δ_res/δ_y as a third parameter (`law.origin`), on the same points.
    PowerLawFit unloading_free;

    double residual_approach_fitted; ///< eq (18) with the fitted m and n, m

    PublishedConvention published;

    bool converged() const
    {
      return loading.fit.report.converged && unloading.fit.report.converged;
    }
  };

  /// Fits both branches of a curve: resamples them at equidistant points (resample.h) and fits the
  /// power laws to F/F_y over δ/δ_y by unweighted least squares (power_law.h).
  /// @param curve in SI units
  /// @param force_yield F_y, N
  /// @param approach_yield δ_y, mutual, m
  /// @throws InputError for scales that are not positive, options out of range or a bad curve.
  /// A fit that does not converge is no error: it says so in its report.
  CurveFit fit_curve(const Curve      &curve,
                     double            force_yield,
                     double            approach_yield,
                     const FitOptions &options = {});

  /// The approach that is left after release by eq (18), δ_res = δ_max − δ_y (F_max/(m F_y))^(1/n),
  /// in the unit of δ_max and δ_y.
  double residual_approach(double approach_max,
                           double approach_yield,
                           double force_max,
                           double force_yield,
                           double m,
                           double n);
} // namespace dpcontact

#endif
