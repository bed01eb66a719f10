#ifndef DPCONTACT_SOLVER_CLOSED_FORM_YIELD_SURFACE_H
#define DPCONTACT_SOLVER_CLOSED_FORM_YIELD_SURFACE_H

#include "solver/laws/law.h"

#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace dpcontact
{
  /// A stress on a law's virgin yield surface, in the law's unit of stress.
  struct YieldSurfacePoint
  {
    /// rad, from the projection of the σ₁ axis in the deviatoric plane, σ₁ towards σ₂: 0 is
    /// triaxial extension, π/3 triaxial compression.
    double                lode_angle;
    double                pressure;  ///< −I₁/3, compression positive
    double                sqrt_j2;   ///< √J₂
    std::array<double, 3> principal; ///< σ₁, σ₂, σ₃ unsorted, tension positive

    /// I₁, tension positive.
    double i1() const { return -3 * pressure; }

    /// Coordinates in the deviatoric plane, y along the projection of σ₁; their norm is √(2 J₂).
    double pi_x() const { return (principal[1] - principal[2]) / std::sqrt(2.); }
    double pi_y() const { return (2 * principal[0] - principal[1] - principal[2]) / std::sqrt(6.); }
  };

  /// The pressure −I₁/3 < 0 of the hydrostatic tension at which the law yields, in the law's unit
  /// of stress; unset where it never does.
  /// @param scale a strength of the law, from which the search starts
  std::optional<double> tensile_pressure(const laws::Law &law, double scale);

  /// The point of f = 0 on the ray from the hydrostatic axis at this pressure and Lode angle (rad),
  /// found by bracketing in the law's own yield function. It is unset where the axis itself lies
  /// outside, or where no yield is found up to 1e6 times the scale.
  /// @param scale as of tensile_pressure()
  std::optional<YieldSurfacePoint>
  surface_point(const laws::Law &law, double pressure, double lode_angle, double scale);
} // namespace dpcontact

#endif
