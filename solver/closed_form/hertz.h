#ifndef DPCONTACT_SOLVER_CLOSED_FORM_HERTZ_H
#define DPCONTACT_SOLVER_CLOSED_FORM_HERTZ_H

#include "solver/problem/scene.h"

#include <cmath>

namespace dpcontact::hertz
{
  // Two elastic spheres (Johnson, Contact Mechanics, 1985, ch. 4). SI units; the approach is
  // mutual. 1/E* = (1−ν₁²)/E₁ + (1−ν₂²)/E₂, R* = R₁R₂/(R₁ + R₂); of identical ones 2(1−ν²)/E and
  // R/2.

  /// E* of two identical bodies.
  inline double effective_modulus(const Material &m)
  {
    return m.youngs_modulus / (2 * (1 - m.poisson_ratio * m.poisson_ratio));
  }

  /// R* of two spheres of this radius.
  inline double effective_radius(const double radius) { return radius / 2; }

  /// E* of the scene's two bodies.
  inline double effective_modulus(const Material &m, const Scene &scene)
  {
    if (!scene.second)
      return effective_modulus(m);
    const auto compliance = [](const Material &body) {
      return (1 - body.poisson_ratio * body.poisson_ratio) / body.youngs_modulus;
    };
    return 1 /
           (compliance(m) + (scene.second->material ? compliance(*scene.second->material) : 0.));
  }

  /// F = (4/3) E* √R* δ^1.5 of the scene's two bodies.
  inline double force(const Material &m, const Scene &scene, const double approach)
  {
    return 4. / 3. * effective_modulus(m, scene) * std::sqrt(scene.effective_radius()) *
           std::pow(approach, 1.5);
  }

  /// The inverse of force(): δ at the force F.
  inline double approach(const Material &m, const Scene &scene, const double force)
  {
    return std::pow(
      3 * force / (4 * effective_modulus(m, scene) * std::sqrt(scene.effective_radius())), 2. / 3.);
  }

  /// The contact radius a = √(R* δ) of the scene's two bodies.
  inline double contact_radius(const Scene &scene, const double approach)
  {
    return std::sqrt(scene.effective_radius() * approach);
  }

  /// F = (4/3) E* √R* δ^1.5 of two identical spheres.
  inline double force(const Material &m, const double radius, const double approach)
  {
    return 4. / 3. * effective_modulus(m) * std::sqrt(effective_radius(radius)) *
           std::pow(approach, 1.5);
  }

  /// The inverse of force() for two identical spheres.
  inline double approach(const Material &m, const double radius, const double force)
  {
    return std::pow(3 * force / (4 * effective_modulus(m) * std::sqrt(effective_radius(radius))),
                    2. / 3.);
  }

  /// The contact radius a = √(R* δ) of two spheres of this radius.
  inline double contact_radius(const double radius, const double approach)
  {
    return std::sqrt(effective_radius(radius) * approach);
  }

  /// The largest pressure of the contact, p₀ = 3F/(2πa²).
  inline double peak_pressure(const double force, const double contact_radius)
  {
    return 3 * force / (2 * M_PI * contact_radius * contact_radius);
  }
} // namespace dpcontact::hertz

#endif
