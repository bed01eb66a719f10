#ifndef DPCONTACT_SOLVER_CURVE_H
#define DPCONTACT_SOLVER_CURVE_H

#include <cmath>
#include <limits>
#include <vector>

namespace dpcontact
{
  /// One converged equilibrium of the contact, in SI units. Unset numbers are NaN.
  struct CurvePoint
  {
    static constexpr double unset = std::numeric_limits<double>::quiet_NaN();

    double approach = unset; ///< mutual approach of remote points δ, m (twice the per-sphere one)
    double force    = unset; ///< normal force F, N
    double contact_radius = unset; ///< radius of the contact's edge, m
    double pressure_max   = unset; ///< largest contact pressure, Pa
    double plastic_volume = unset; ///< yielded so far, of one of two alike spheres or of both, m³
    double dissipated_energy = unset; ///< Σ ∫ σₙ₊₁:Δεᵖ dV over both spheres since the start, J
    double plastic_strain_max = unset; ///< largest accumulated plastic strain ∫ √(2/3) |dεᵖ|
    double mises_stress_max   = unset; ///< largest von Mises stress in either body, Pa
    int    newton_iterations  = 0;     ///< Newton iterations spent on this point
  };

  /// What all converged states of a path are held to. Energies of both spheres in J.
  struct PathChecks
  {
    double residual         = 0; ///< largest dimensionless norm that Newton ended with
    double yield_excess     = 0; ///< largest f over the law's strength
    double penetration      = 0; ///< largest gap violation over the approach
    double work             = 0; ///< of the contact pressure, trapezoidal rule, up to the end
    double largest_work     = 0; ///< on the way
    double elastic_energy   = 0; ///< at the end: residual stresses'
    double dissipation      = 0; ///< Σ ∫ σₙ₊₁:Δεᵖ dV: backward Euler's
    double mean_dissipation = 0; ///< Σ ∫ ½(σₙ + σₙ₊₁):Δεᵖ dV
    double energy_error = 0; ///< largest |work − elastic energy − mean dissipation| on the way

    /// |work − elastic energy − dissipation| at the end over the largest work: first order in the
    /// step.
    double energy_gap() const
    {
      return std::abs(work - elastic_energy - dissipation) / largest_work;
    }
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
