#ifndef DPCONTACT_DATABASE_CONTACT_LAW_COLLISION_H
#define DPCONTACT_DATABASE_CONTACT_LAW_COLLISION_H

#include "database/contact_law/contact_law.h"

namespace dpcontact
{
  /// Two spheres that meet head on, without rotation, gravity or damping. SI units.
  struct CollidingSpheres
  {
    double radius_1, radius_2; ///< m
    double density;            ///< of both, kg/m³
    double velocity;           ///< with which they come closer, positive, m/s

    /// m₁m₂/(m₁ + m₂), kg
    double effective_mass() const;
  };

  /// What came of a collision. SI units.
  struct Collision
  {
    double       peak_overlap     = 0; ///< m
    double       peak_force       = 0; ///< N
    double       duration         = 0; ///< from the first touch to the last, s
    double       rebound_velocity = 0; ///< of separation, m/s
    double       restitution      = 0; ///< rebound velocity over the velocity before
    double       residual_overlap = 0; ///< at which the force vanishes on release, m
    unsigned int flags            = 0; ///< ContactFlag bits met on the way
  };

  /// Integrates m_eff δ'' = −F(δ; history) by Runge and Kutta's fourth-order method from touch to
  /// separation. The time of separation is interpolated within the last step.
  /// @param steps how many steps the collision takes, about.
  /// @throws InputError unless the radii are 1 nm to 1000 km, the density 10⁻³ to 10⁶ kg/m³, the
  /// velocity 10⁻⁹ to 10⁵ m/s and steps ≥ 100; SolverError where no rebound comes of it.
  Collision
  collide(const ContactLaw &law, const CollidingSpheres &spheres, unsigned int steps = 20000);
} // namespace dpcontact

#endif
