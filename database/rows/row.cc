#include "database/rows/row.h"

#include "database/rows/uncertainty.h"
#include "fitting/curve_fit.h"
#include "solver/closed_form/first_yield.h"
#include "solver/closed_form/plausibility.h"
#include "solver/laws/strengths.h"
#include "solver/path/solution.h"

#include <cmath>
#include <sstream>

namespace dpcontact
{
  namespace
  {
    /// Inputs and what follows from them in closed form.
    Record new_row(const Case &input)
    {
      const FirstYield yield = first_yield(input.material, input.scene);

      Record row;
      row.input                           = input;
      row.yield.force                     = yield.force;
      row.yield.approach                  = yield.approach;
      row.yield.pressure                  = yield.pressure;
      row.yield.contact_radius            = yield.contact_radius;
      row.yield.depth_over_contact_radius = yield.depth_over_contact_radius;
      row.yield.ring_force                = yield.ring_force;
      row.load_level                      = input.scene.force_max / yield.force;
      // eq (14) is the uniaxial strength of the von Mises cylinder of radius k: √3 k
      row.yield.uniaxial_strength =
        std::sqrt(3.) * laws::drucker_prager_strength(input.material.friction_angle.radians(),
                                                      input.material.compressive_strength);
      return row;
    }

    FitQuality quality_of(const FitReport &report) { return {report.r_squared, report.rmse}; }

    BranchFitRow branch_row(const BranchFit &branch)
    {
      BranchFitRow row;
      row.power_law  = quality_of(branch.fit.report);
      row.covariance = branch.fit.covariance[0][1];
      row.stop       = describe(branch.fit.report.reason);
      for (const AlternativeFit &alternative : branch.alternatives)
        switch (alternative.form)
          {
            case Form::exponential:
              row.exponential = quality_of(alternative.report);
              break;
            case Form::cubic: // of the polynomials the one that fits best
              row.polynomial = quality_of(alternative.report);
              break;
            case Form::parabola:
              row.parabola = quality_of(alternative.report);
              break;
            case Form::quadratic:
              break;
          }
      return row;
    }

    /// @param scale δ_y, m: the unit of the fit's origin.
    ThreeParameterRow three_parameter_row(const PowerLawFit &fit, const double scale)
    {
      ThreeParameterRow row;
      row.m                                = fit.law.coefficient;
      row.n                                = fit.law.exponent;
      row.approach_residual                = fit.law.origin * scale;
      row.m_standard_error                 = fit.standard_error.coefficient;
      row.n_standard_error                 = fit.standard_error.exponent;
      row.approach_residual_standard_error = fit.standard_error.origin * scale;
      row.mn_covariance                    = fit.covariance[0][1];
      row.m_residual_covariance            = fit.covariance[0][2] * scale;
      row.n_residual_covariance            = fit.covariance[1][2] * scale;
      row.quality                          = quality_of(fit.report);
      row.stop                             = describe(fit.report.reason);
      return row;
    }

    void enter_fit(const CurveFit &fit, Record &row)
    {
      const PowerLawFit &loading   = fit.loading.fit;
      const PowerLawFit &unloading = fit.unloading.fit;
      row.law                      = Coefficients::from(coefficients(fit));
      row.fit.standard_error       = {loading.standard_error.coefficient,
                                      loading.standard_error.exponent,
                                      unloading.standard_error.coefficient,
                                      unloading.standard_error.exponent};
      row.fit.window_change        = {fit.loading.coefficient_change,
                                      fit.loading.exponent_change,
                                      fit.unloading.coefficient_change,
                                      fit.unloading.exponent_change};
      row.fit.loading              = branch_row(fit.loading);
      row.fit.unloading            = branch_row(fit.unloading);
      row.fit.three_parameter      = three_parameter_row(fit.unloading_free, fit.approach_yield);
      row.fit.published = {fit.published.a, fit.published.m, fit.published.approach_yield};

      row.state.approach_residual      = fit.residual_approach;
      row.state.approach_residual_eq18 = fit.residual_approach_fitted;
      row.state.approach_peak          = fit.approach_max;

      // The other parts do not depend on the fit: a refit keeps them.
      const auto fits = fit_errors(fit);
      for (std::size_t c = 0; c < fits.size(); ++c)
        {
          StatedError &error = row.error[c];
          error.total += fits[c] - error.parts.fit;
          error.parts.fit = fits[c];
        }

      row.status = fit.converged() ? "converged" : "failed";
      row.reason = fit.converged() ? ""
                                   : "a fit did not converge (loading: " + row.fit.loading.stop +
                                       ", unloading: " + row.fit.unloading.stop + ")";
    }
  } // namespace

  Record row_of(const Case &input, const Solution &solution)
  {
    Record            row         = new_row(input);
    const CurvePoint &peak        = solution.curve.loading.back();
    const CurvePoint &release     = solution.curve.unloading.back();
    row.state.contact_radius_peak = peak.contact_radius;
    row.state.pressure_peak       = peak.pressure_max;
    row.state.plastic_volume      = release.plastic_volume;
    row.state.dissipated_energy   = release.dissipated_energy;
    row.state.plastic_strain_max  = release.plastic_strain_max;
    row.state.apex_points         = solution.apex_points;
    row.state.step_error          = solution.step_error;

    row.cost = {solution.cost.dofs,
                solution.cost.steps,
                solution.cost.newton_iterations,
                solution.cost.cut_backs,
                solution.cost.wall_seconds,
                solution.cost.peak_memory_bytes};

    row.warnings = joined(solution.warnings);

    row.curve        = solution.curve;
    row.peak_profile = solution.peak_profile;
    const CoefficientErrors errors =
      estimate_errors(fit_row(row), solution, input.material, input.scene);
    for (std::size_t c = 0; c < errors.size(); ++c)
      row.error[c] = {errors[c], errors[c].total()};
    return row;
  }

  Record failed_row(const Case &input, const std::string &reason)
  {
    Record row = new_row(input);
    row.status = "failed";
    row.reason = one_line(reason);
    return row;
  }

  CurveFit fit_row(Record &row)
  {
    const CurveFit fit = fit_curve(row.curve, row.yield.force, row.yield.approach);
    enter_fit(fit, row);
    return fit;
  }

  std::string one_line(const std::string &text)
  {
    std::istringstream stream(text);
    std::string        result;
    for (std::string word; stream >> word;)
      result += (result.empty() ? "" : " ") + word;
    return result;
  }
} // namespace dpcontact
