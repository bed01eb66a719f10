#ifndef DPCONTACT_SOLVER_PROBLEM_CURVE_H
#define DPCONTACT_SOLVER_PROBLEM_CURVE_H

#include <cmath>
#include <limits>
#include <variant>
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

  /// What a number of the curve measures. Numbers of one measure are converted between two systems
  /// of units by the same factor.
  enum class CurveMeasure
  {
    approach,
    force,
    length,
    stress,
    volume,
    energy,
    strain, ///< grows with displacements over lengths, whose units may differ
    count
  };

  /// A member of CurvePoint as it is named wherever points of a curve are stored or printed.
  struct CurveQuantity
  {
    using Member = std::variant<double CurvePoint::*, int CurvePoint::*>;

    const char  *name;
    const char  *unit; ///< SI; "1" of numbers without dimension
    const char  *description;
    CurveMeasure measure;
    Member       member;
  };

  /// All members of CurvePoint, in the order in which they are stored and printed. It is the only
  /// list of them: scaling, checkpoints and the columns of files follow it.
  const std::vector<CurveQuantity> &curve_quantities();

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

  /// Factors from the units of a curve to other units, by what its quantities measure.
  struct CurveScale
  {
    double approach, force, length, stress, volume, energy, strain;

    /// The factor of a measure, 1 of a count.
    double of(CurveMeasure measure) const;

    /// Multiplies every quantity of every point by its factor.
    void apply(std::vector<CurvePoint> &points) const;
    void apply(Curve &curve) const;
  };
} // namespace dpcontact

#endif
