#ifndef DPCONTACT_DATABASE_ROWS_RECORD_H
#define DPCONTACT_DATABASE_ROWS_RECORD_H

#include "database/rows/error_parts.h"
#include "fitting/coefficients.h"
#include "solver/output/pressure_profile.h"
#include "solver/problem/case.h"
#include "solver/problem/curve.h"

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace dpcontact
{
  // A row's parts. Numbers are in SI units, approaches mutual unless named otherwise; what is not
  // known is NaN. Columns, units and meanings stand in schema.cc.

  constexpr double unset_number = std::numeric_limits<double>::quiet_NaN();

  /// First yield in closed form (closed_form/first_yield.h).
  struct YieldRow
  {
    double force                     = unset_number;
    double approach                  = unset_number;
    double pressure                  = unset_number;
    double contact_radius            = unset_number;
    double uniaxial_strength         = unset_number; ///< eq (14)
    double depth_over_contact_radius = unset_number;
    double ring_force                = unset_number;
  };

  /// How well a form fits a branch.
  struct FitQuality
  {
    double r2   = unset_number;
    double rmse = unset_number; ///< over the peak force
  };

  /// The fit of one branch, and the paper's rival forms.
  struct BranchFitRow
  {
    FitQuality  power_law;
    double      covariance = unset_number; ///< of coefficient and exponent
    std::string stop;                      ///< why the fit stopped
    FitQuality  exponential, polynomial, parabola;
  };

  /// Unloading with the residual approach as a third parameter.
  struct ThreeParameterRow
  {
    double      m = unset_number, n = unset_number, approach_residual = unset_number;
    double      m_standard_error = unset_number, n_standard_error = unset_number;
    double      approach_residual_standard_error = unset_number;
    double      mn_covariance                    = unset_number;
    double      m_residual_covariance            = unset_number; ///< m
    double      n_residual_covariance            = unset_number; ///< m
    FitQuality  quality;
    std::string stop;
  };

  /// The published convention: δ mutual, δ_y of one sphere.
  struct PublishedRow
  {
    double a = unset_number, m = unset_number, approach_yield = unset_number;
  };

  /// How a, b, m, n were fitted.
  struct FitRow
  {
    Coefficients      standard_error; ///< misfit of the form
    Coefficients      window_change;  ///< relative change in the window [0.1, 1] of the approach
    BranchFitRow      loading, unloading;
    ThreeParameterRow three_parameter;
    PublishedRow      published;
  };

  /// The stated error of a coefficient.
  struct StatedError
  {
    ErrorParts parts;
    double     total = unset_number;
  };

  /// The state at the peak, after release, and over the whole path.
  struct StateRow
  {
    double        approach_residual      = unset_number;
    double        approach_residual_eq18 = unset_number;
    double        approach_peak          = unset_number;
    double        contact_radius_peak    = unset_number;
    double        pressure_peak          = unset_number;
    double        plastic_volume         = unset_number;
    double        dissipated_energy      = unset_number;
    double        plastic_strain_max     = unset_number;
    std::uint64_t apex_points            = 0;
    double        step_error             = unset_number;
  };

  struct CostRow
  {
    std::uint64_t dofs              = 0;
    std::uint64_t steps             = 0;
    std::uint64_t newton_iterations = 0;
    std::uint64_t cut_backs         = 0;
    double        wall_seconds      = unset_number;
    std::uint64_t peak_memory_bytes = 0;
  };

  /// One row of the database: everything known about one case.
  struct Record
  {
    Case                       input;
    YieldRow                   yield;
    double                     load_level = unset_number; ///< Λ = F_max/F_y
    Coefficients               law;                       ///< a, b, m, n of the consistent pair
    FitRow                     fit;
    std::array<StatedError, 4> error; ///< of a, b, m, n
    StateRow                   state;
    CostRow                    cost;

    std::string status;   ///< "converged" or "failed"
    std::string reason;   ///< why it failed; empty otherwise
    std::string warnings; ///< joined by "; "; empty if there are none

    bool converged() const { return status == "converged"; }

    // what is not a column: stored beside the table
    Curve                      curve;
    std::vector<PressurePoint> peak_profile; ///< contact pressure at the peak
  };
} // namespace dpcontact

#endif
