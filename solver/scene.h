#ifndef DPCONTACT_SOLVER_SCENE_H
#define DPCONTACT_SOLVER_SCENE_H

#include <limits>

namespace dpcontact
{
  /// Isotropic elastic, perfectly plastic Drucker–Prager rock with associated flow.
  struct Material
  {
    double youngs_modulus = std::numeric_limits<double>::quiet_NaN();       ///< E, Pa
    double poisson_ratio  = std::numeric_limits<double>::quiet_NaN();       ///< ν
    double friction_angle = std::numeric_limits<double>::quiet_NaN();       ///< φ, rad
    double compressive_strength = std::numeric_limits<double>::quiet_NaN(); ///< uniaxial σc, Pa

    /// @throws InputError naming the quantity, its value and its range:
    /// E > 0, 0 ≤ ν < 0.5, 0 ≤ φ < 90°, σc > 0, all finite.
    void check() const;
  };

  /// Two identical spheres pressed together without friction.
  struct Scene
  {
    double radius    = 0.1; ///< R of each sphere, m
    double force_max = 100; ///< peak normal force, N

    /// @throws InputError unless both are finite and positive.
    void check() const;
  };
} // namespace dpcontact

#endif
