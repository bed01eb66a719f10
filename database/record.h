#ifndef DPCONTACT_DATABASE_RECORD_H
#define DPCONTACT_DATABASE_RECORD_H

#include "solver/curve.h"
#include "solver/solve.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

namespace dpcontact
{
  /// What identifies a row: the material and the scene. SI units, angle in degrees.
  struct RowInputs
  {
    static constexpr double unset = std::numeric_limits<double>::quiet_NaN();

    double E_Pa        = unset;
    double nu          = unset;
    double phi_deg     = unset;
    double sigma_c_Pa  = unset;
    double radius_m    = unset;
    double force_max_N = unset;

    std::string criterion         = "drucker-prager";
    double      flow_stress_ratio = 1;
    double      dilation_deg      = unset;
    double      hardening_Pa      = 0;
    double      tension_cutoff_Pa = unset; ///< NaN: none

    /// What two rows of the same material and scene have in common; ordered, and NaN nowhere.
    using Key = std::tuple<std::string,
                           double,
                           double,
                           double,
                           double,
                           double,
                           double,
                           double,
                           double,
                           double,
                           double>;
    Key key() const
    {
      return {criterion,
              E_Pa,
              nu,
              phi_deg,
              sigma_c_Pa,
              flow_stress_ratio,
              dilation_deg,
              hardening_Pa,
              std::isnan(tension_cutoff_Pa) ? std::numeric_limits<double>::infinity()
                                            : tension_cutoff_Pa,
              radius_m,
              force_max_N};
    }
  };

  /// One row of the database: everything known about one material. Units, meaning and order of the
  /// columns stand in schema.cc. Unset numbers are NaN; approaches are mutual unless named
  /// otherwise.
  struct Record : RowInputs
  {
    // scales of first yield
    double force_yield_N             = unset;
    double approach_yield_m          = unset;
    double pressure_yield_Pa         = unset;
    double contact_radius_yield_m    = unset;
    double yield_strength_Pa         = unset;
    double depth_over_contact_radius = unset;
    double ring_force_N              = unset;
    double load_level                = unset;

    // F/F_y = a (δ/δ_y)^b and F/F_y = m ((δ − δ_res)/δ_y)^n, δ and δ_y both mutual
    double      a = unset, b = unset, m = unset, n = unset;
    double      a_standard_error = unset, b_standard_error = unset;
    double      m_standard_error = unset, n_standard_error = unset;
    double      ab_covariance = unset, mn_covariance = unset;
    double      r2_loading = unset, r2_unloading = unset;
    double      rmse_loading = unset, rmse_unloading = unset;
    double      a_window_change = unset, b_window_change = unset;
    double      m_window_change = unset, n_window_change = unset;
    std::string stop_loading, stop_unloading;

    // estimated error of each coefficient by source (fitting/uncertainty.h)
    double a_error_mesh = unset, a_error_step = unset, a_error_contact = unset,
           a_error_far_field     = unset;
    double a_error_finite_radius = unset, a_error_fit = unset, a_error_total = unset;
    double b_error_mesh = unset, b_error_step = unset, b_error_contact = unset,
           b_error_far_field     = unset;
    double b_error_finite_radius = unset, b_error_fit = unset, b_error_total = unset;
    double m_error_mesh = unset, m_error_step = unset, m_error_contact = unset,
           m_error_far_field     = unset;
    double m_error_finite_radius = unset, m_error_fit = unset, m_error_total = unset;
    double n_error_mesh = unset, n_error_step = unset, n_error_contact = unset,
           n_error_far_field     = unset;
    double n_error_finite_radius = unset, n_error_fit = unset, n_error_total = unset;

    // the published convention: δ mutual, δ_y of one sphere
    double a_published = unset, m_published = unset, approach_yield_published_m = unset;

    // unloading with the residual approach as a third parameter
    double      m_three_parameter = unset, n_three_parameter = unset;
    double      approach_residual_three_parameter_m                = unset;
    double      m_three_parameter_standard_error                   = unset;
    double      n_three_parameter_standard_error                   = unset;
    double      approach_residual_three_parameter_standard_error_m = unset;
    double      mn_three_parameter_covariance                      = unset;
    double      m_residual_three_parameter_covariance_m            = unset;
    double      n_residual_three_parameter_covariance_m            = unset;
    double      r2_three_parameter = unset, rmse_three_parameter = unset;
    std::string stop_three_parameter;

    // other forms than the power law
    double r2_exponential_loading = unset, rmse_exponential_loading = unset;
    double r2_polynomial_loading = unset, rmse_polynomial_loading = unset;
    double r2_parabola_loading = unset, rmse_parabola_loading = unset;
    double r2_exponential_unloading = unset, rmse_exponential_unloading = unset;
    double r2_polynomial_unloading = unset, rmse_polynomial_unloading = unset;
    double r2_parabola_unloading = unset, rmse_parabola_unloading = unset;

    // state at the peak and after release
    double        approach_residual_m      = unset;
    double        approach_residual_eq18_m = unset;
    double        approach_peak_m          = unset;
    double        contact_radius_peak_m    = unset;
    double        pressure_peak_Pa         = unset;
    double        plastic_volume_m3        = unset;
    double        dissipated_energy_J      = unset;
    double        plastic_strain_max       = unset;
    std::uint64_t apex_points              = 0;
    double        step_error               = unset;

    // what it cost
    std::uint64_t dofs              = 0;
    std::uint64_t steps             = 0;
    std::uint64_t newton_iterations = 0;
    std::uint64_t cut_backs         = 0;
    double        wall_seconds      = unset;
    std::uint64_t peak_memory_bytes = 0;

    std::string status;   ///< "converged" or "failed"
    std::string reason;   ///< why it failed; empty otherwise
    std::string warnings; ///< joined by "; "; empty if there are none

    // what is not a column: stored beside the table
    Curve                      curve;
    std::vector<PressurePoint> peak_profile; ///< contact pressure at the peak
  };
} // namespace dpcontact

#endif
