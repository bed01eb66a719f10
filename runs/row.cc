#include "runs/row.h"

#include "meshing/errors.h"
#include "solver/laws/drucker_prager.h"

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
      static_cast<RowInputs &>(row) = row_inputs(input);
      row.force_yield_N             = yield.force;
      row.approach_yield_m          = yield.approach;
      row.pressure_yield_Pa         = yield.pressure;
      row.contact_radius_yield_m    = yield.contact_radius;
      row.depth_over_contact_radius = yield.depth_over_contact_radius;
      row.ring_force_N              = yield.ring_force;
      row.load_level                = input.scene.force_max / yield.force;
      // eq (14) is the uniaxial strength of the von Mises cylinder of radius k: √3 k
      row.yield_strength_Pa =
        std::sqrt(3.) * laws::drucker_prager_strength(input.material.friction_angle,
                                                      input.material.compressive_strength);
      return row;
    }

    void enter_alternatives(const BranchFit &branch,
                            double Record::*exponential_r2,
                            double Record::*exponential_rmse,
                            double Record::*polynomial_r2,
                            double Record::*polynomial_rmse,
                            double Record::*parabola_r2,
                            double Record::*parabola_rmse,
                            Record         &row)
    {
      for (const AlternativeFit &alternative : branch.alternatives)
        switch (alternative.form)
          {
            case Form::exponential:
              row.*exponential_r2   = alternative.report.r_squared;
              row.*exponential_rmse = alternative.report.rmse;
              break;
            case Form::cubic: // of the polynomials the one that fits best
              row.*polynomial_r2   = alternative.report.r_squared;
              row.*polynomial_rmse = alternative.report.rmse;
              break;
            case Form::parabola:
              row.*parabola_r2   = alternative.report.r_squared;
              row.*parabola_rmse = alternative.report.rmse;
              break;
            case Form::quadratic:
              break;
          }
    }

    void enter_fit(const CurveFit &fit, Record &row)
    {
      const PowerLawFit &loading   = fit.loading.fit;
      const PowerLawFit &unloading = fit.unloading.fit;
      row.a                        = loading.law.coefficient;
      row.b                        = loading.law.exponent;
      row.m                        = unloading.law.coefficient;
      row.n                        = unloading.law.exponent;
      row.a_standard_error         = loading.standard_error.coefficient;
      row.b_standard_error         = loading.standard_error.exponent;
      row.m_standard_error         = unloading.standard_error.coefficient;
      row.n_standard_error         = unloading.standard_error.exponent;
      row.ab_covariance            = loading.covariance[0][1];
      row.mn_covariance            = unloading.covariance[0][1];
      row.r2_loading               = loading.report.r_squared;
      row.r2_unloading             = unloading.report.r_squared;
      row.rmse_loading             = loading.report.rmse;
      row.rmse_unloading           = unloading.report.rmse;
      row.a_window_change          = fit.loading.coefficient_change;
      row.b_window_change          = fit.loading.exponent_change;
      row.m_window_change          = fit.unloading.coefficient_change;
      row.n_window_change          = fit.unloading.exponent_change;
      row.stop_loading             = describe(loading.report.reason);
      row.stop_unloading           = describe(unloading.report.reason);

      row.a_published                = fit.published.a;
      row.m_published                = fit.published.m;
      row.approach_yield_published_m = fit.published.approach_yield;

      // here the origin is in units of δ_y
      const PowerLawFit &free                                = fit.unloading_free;
      const double       scale                               = fit.approach_yield;
      row.m_three_parameter                                  = free.law.coefficient;
      row.n_three_parameter                                  = free.law.exponent;
      row.approach_residual_three_parameter_m                = free.law.origin * scale;
      row.m_three_parameter_standard_error                   = free.standard_error.coefficient;
      row.n_three_parameter_standard_error                   = free.standard_error.exponent;
      row.approach_residual_three_parameter_standard_error_m = free.standard_error.origin * scale;
      row.mn_three_parameter_covariance                      = free.covariance[0][1];
      row.m_residual_three_parameter_covariance_m            = free.covariance[0][2] * scale;
      row.n_residual_three_parameter_covariance_m            = free.covariance[1][2] * scale;
      row.r2_three_parameter                                 = free.report.r_squared;
      row.rmse_three_parameter                               = free.report.rmse;
      row.stop_three_parameter                               = describe(free.report.reason);

      enter_alternatives(fit.loading,
                         &Record::r2_exponential_loading,
                         &Record::rmse_exponential_loading,
                         &Record::r2_polynomial_loading,
                         &Record::rmse_polynomial_loading,
                         &Record::r2_parabola_loading,
                         &Record::rmse_parabola_loading,
                         row);
      enter_alternatives(fit.unloading,
                         &Record::r2_exponential_unloading,
                         &Record::rmse_exponential_unloading,
                         &Record::r2_polynomial_unloading,
                         &Record::rmse_polynomial_unloading,
                         &Record::r2_parabola_unloading,
                         &Record::rmse_parabola_unloading,
                         row);

      row.approach_residual_m      = fit.residual_approach;
      row.approach_residual_eq18_m = fit.residual_approach_fitted;
      row.approach_peak_m          = fit.approach_max;

      // The other parts do not depend on the fit: a refit keeps them.
      const auto         fits    = fit_errors(fit);
      const ErrorColumns columns = error_columns();
      for (std::size_t c = 0; c < 4; ++c)
        {
          row.*columns[c][6] += fits[c] - row.*columns[c][5];
          row.*columns[c][5] = fits[c];
        }

      row.status = fit.converged() ? "converged" : "failed";
      row.reason = fit.converged() ? ""
                                   : "a fit did not converge (loading: " + row.stop_loading +
                                       ", unloading: " + row.stop_unloading + ")";
    }
  } // namespace

  ErrorColumns error_columns()
  {
    using R = Record;
    return {{{&R::a_error_mesh,
              &R::a_error_step,
              &R::a_error_contact,
              &R::a_error_far_field,
              &R::a_error_finite_radius,
              &R::a_error_fit,
              &R::a_error_total},
             {&R::b_error_mesh,
              &R::b_error_step,
              &R::b_error_contact,
              &R::b_error_far_field,
              &R::b_error_finite_radius,
              &R::b_error_fit,
              &R::b_error_total},
             {&R::m_error_mesh,
              &R::m_error_step,
              &R::m_error_contact,
              &R::m_error_far_field,
              &R::m_error_finite_radius,
              &R::m_error_fit,
              &R::m_error_total},
             {&R::n_error_mesh,
              &R::n_error_step,
              &R::n_error_contact,
              &R::n_error_far_field,
              &R::n_error_finite_radius,
              &R::n_error_fit,
              &R::n_error_total}}};
  }

  RowInputs row_inputs(const Case &input)
  {
    RowInputs inputs;
    inputs.E_Pa        = input.material.youngs_modulus;
    inputs.nu          = input.material.poisson_ratio;
    inputs.phi_deg     = input.friction_angle_degrees;
    inputs.sigma_c_Pa  = input.material.compressive_strength;
    inputs.radius_m    = input.scene.radius;
    inputs.force_max_N = input.scene.force_max;

    inputs.criterion         = to_string(input.material.criterion);
    inputs.flow_stress_ratio = input.material.flow_stress_ratio;
    inputs.dilation_deg      = input.dilation_angle_degrees;
    inputs.hardening_Pa      = input.material.hardening;
    if (input.material.tension_cutoff)
      inputs.tension_cutoff_Pa = *input.material.tension_cutoff;
    return inputs;
  }

  Case case_of(const RowInputs &inputs)
  {
    Case result{};
    result.material.youngs_modulus       = inputs.E_Pa;
    result.material.poisson_ratio        = inputs.nu;
    result.material.friction_angle       = radians(inputs.phi_deg);
    result.material.compressive_strength = inputs.sigma_c_Pa;
    result.scene.radius                  = inputs.radius_m;
    result.scene.force_max               = inputs.force_max_N;
    result.friction_angle_degrees        = inputs.phi_deg;
    result.dilation_angle_degrees        = inputs.dilation_deg;
    result.material.criterion            = parse_criterion(inputs.criterion);
    result.material.flow_stress_ratio    = inputs.flow_stress_ratio;
    result.material.hardening            = inputs.hardening_Pa;
    if (inputs.dilation_deg != inputs.phi_deg)
      result.material.dilation_angle = radians(inputs.dilation_deg);
    if (!std::isnan(inputs.tension_cutoff_Pa))
      result.material.tension_cutoff = inputs.tension_cutoff_Pa;
    return result;
  }

  Record row_of(const Case &input, const Solution &solution)
  {
    Record            row     = new_row(input);
    const CurvePoint &peak    = solution.curve.loading.back();
    const CurvePoint &release = solution.curve.unloading.back();
    row.contact_radius_peak_m = peak.contact_radius;
    row.pressure_peak_Pa      = peak.pressure_max;
    row.plastic_volume_m3     = release.plastic_volume;
    row.dissipated_energy_J   = release.dissipated_energy;
    row.plastic_strain_max    = release.plastic_strain_max;
    row.apex_points           = solution.apex_points;
    row.step_error            = solution.step_error;

    row.dofs              = solution.cost.dofs;
    row.steps             = solution.cost.steps;
    row.newton_iterations = solution.cost.newton_iterations;
    row.cut_backs         = solution.cost.cut_backs;
    row.wall_seconds      = solution.cost.wall_seconds;
    row.peak_memory_bytes = solution.cost.peak_memory_bytes;

    for (const std::string &warning : solution.warnings)
      row.warnings += (row.warnings.empty() ? "" : "; ") + warning;

    row.curve                       = solution.curve;
    row.peak_profile                = solution.peak_profile;
    const CoefficientErrors errors  = estimate_errors(fit_row(row), solution, input.material, input.scene);
    const ErrorColumns      columns = error_columns();
    for (std::size_t c = 0; c < errors.size(); ++c)
      {
        const ErrorParts &e        = errors[c];
        const double      parts[7] = {
               e.mesh, e.step, e.contact, e.far_field, e.finite_radius, e.fit, e.total()};
        for (std::size_t p = 0; p < 7; ++p)
          row.*columns[c][p] = parts[p];
      }
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
    const CurveFit fit = fit_curve(row.curve, row.force_yield_N, row.approach_yield_m);
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
