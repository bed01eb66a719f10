#ifndef DPCONTACT_SOLVER_HERTZ_H
#define DPCONTACT_SOLVER_HERTZ_H

#include "solver/scene.h"

#include <cmath>

namespace dpcontact::hertz
{
  // Two identical elastic spheres (Johnson, Contact Mechanics, 1985, ch. 4). SI units; the approach
  // is mutual. 1/E* = 2(1−ν²)/E, R* = R/2.

  inline double effective_modulus(const Material &m)
  {
    return m.youngs_modulus / (2 * (1 - m.poisson_ratio * m.poisson_ratio));
  }

  inline double effective_radius(const double radius) { return radius / 2; }

  /// F(δ) = (4/3) E* √R* δ^1.5
  inline double force(const Material &m, const double radius, const double approach)
  {
    return 4. / 3. * effective_modulus(m) * std::sqrt(effective_radius(radius)) *
           std::pow(approach, 1.5);
  }

  /// δ(F)
  inline double approach(const Material &m, const double radius, const double force)
  {
    return std::pow(3 * force / (4 * effective_modulus(m) * std::sqrt(effective_radius(radius))),
                    2. / 3.);
  }

  /// a² = R* δ
  inline double contact_radius(const double radius, const double approach)
  {
    return std::sqrt(effective_radius(radius) * approach);
  }

  /// p₀ = 3F/(2πa²)
  inline double peak_pressure(const double force, const double contact_radius)
  {
    return 3 * force / (2 * M_PI * contact_radius * contact_radius);
  }
} // namespace dpcontact::hertz

#endif
