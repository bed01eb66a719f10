#ifndef DPCONTACT_SOLVER_CURVE_H
#define DPCONTACT_SOLVER_CURVE_H

#include <limits>
#include <vector>

namespace dpcontact
{
  /// One converged equilibrium of the contact, in SI units. Unset numbers are NaN.
  struct CurvePoint
  {
    static constexpr double unset = std::numeric_limits<double>::quiet_NaN();

    double approach         = unset; ///< mutual approach of remote points δ, m (twice the per-sphere one)
    double force            = unset; ///< normal force F, N
    double contact_radius   = unset; ///< radius of the contact's edge, m
    double pressure_max     = unset; ///< largest contact pressure, Pa
    double plastic_volume   = unset; ///< volume of one sphere that has yielded so far, m³
    double dissipated_energy = unset; ///< Σ ∫ σₙ₊₁:Δεᵖ dV over both spheres since the start, J
    double plastic_strain_max = unset; ///< largest accumulated plastic strain ∫ √(2/3) |dεᵖ|
    int    newton_iterations = 0;     ///< Newton iterations spent on this point
  };

  /// A loading branch from (0, 0) to the peak, and an unloading branch from the peak to (δ_res, 0).
  ///
  /// Along `loading` approach and force increase strictly; along `unloading` (whose first point is
  /// the peak and whose last is the separation, F = 0) both decrease strictly.
  struct Curve
  {
    std::vector<CurvePoint> loading;
    std::vector<CurvePoint> unloading;

    double residual_approach() const { return unloading.back().approach; }
  };
} // namespace dpcontact

#endif
