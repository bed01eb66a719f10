#ifndef DPCONTACT_SOLVER_LAWS_STRENGTHS_H
#define DPCONTACT_SOLVER_LAWS_STRENGTHS_H

#include <cmath>

namespace dpcontact::laws
{
  // What yield criteria make of φ (rad) and of the uniaxial compressive strength σc, in whose unit
  // strengths are.

  /// α = 2 sinφ/(√3(3 − sinφ)) of the cone through the Mohr–Coulomb pyramid's compression edges
  /// (Wang et al. 2018, model section 2).
  inline double drucker_prager_alpha(const double friction_angle)
  {
    const double sine = std::sin(friction_angle);
    return 2 * sine / (std::sqrt(3.) * (3 - sine));
  }

  /// k = σc(1 − √3 α)/√3 of the same cone.
  inline double drucker_prager_strength(const double friction_angle,
                                        const double compressive_strength)
  {
    // 1 − √3 α = 3 (1 − sinφ)/(3 − sinφ), with 1 − sinφ = 2 sin²(45° − φ/2) so that no digit is
    // lost towards φ = 90°.
    const double half_angle_sine = std::sin((M_PI / 2 - friction_angle) / 2);
    return compressive_strength * std::sqrt(3.) * 2 * half_angle_sine * half_angle_sine /
           (3 - std::sin(friction_angle));
  }

  /// σ_Y = 3(1 − sinφ)/(3 − sinφ) σc (Wang et al. 2018, section 3.4; model section 2): the cylinder
  /// through the cone's section I₁ = 0.
  inline double von_mises_yield_stress(const double friction_angle,
                                       const double compressive_strength)
  {
    return std::sqrt(3.) * drucker_prager_strength(friction_angle, compressive_strength);
  }

  /// C = (1 − sinφ)/(2 cosφ) σc, computed as ½ tan(45° − φ/2) σc, which loses no digit towards 90°.
  inline double mohr_coulomb_cohesion(const double friction_angle,
                                      const double compressive_strength)
  {
    return compressive_strength / 2 * std::tan((M_PI / 2 - friction_angle) / 2);
  }

  /// The tensile pressure C cotφ at which the pyramid ends, in the unit of σc; infinite for φ = 0.
  inline double mohr_coulomb_apex(const double friction_angle, const double compressive_strength)
  {
    return mohr_coulomb_cohesion(friction_angle, compressive_strength) / std::tan(friction_angle);
  }

  /// σc of the cohesion C, the inverse of mohr_coulomb_cohesion().
  inline double mohr_coulomb_compressive_strength(const double friction_angle,
                                                  const double cohesion)
  {
    return 2 * cohesion / std::tan((M_PI / 2 - friction_angle) / 2);
  }
} // namespace dpcontact::laws

#endif
