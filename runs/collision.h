#ifndef DPCONTACT_RUNS_COLLISION_H
#define DPCONTACT_RUNS_COLLISION_H

#include "database/contact_law.h"

namespace dpcontact
{
  /// Two spheres that meet head on, without rotation, gravity or damping. SI units.
  struct CollidingSpheres
  {
    double radius_1, radius_2;
    double density;  ///< of both
    double velocity; ///< of approach, positive

    /// m₁m₂/(m₁ + m₂)
    double effective_mass() const;
  };

  struct Collision
  {
    double       peak_overlap = 0, peak_force = 0;
    double       duration         = 0; ///< from the first touch to the last
    double       rebound_velocity = 0; ///< of separation
    double       restitution      = 0; ///< rebound over approach velocity
    double       residual_overlap = 0;
    unsigned int flags            = 0; ///< ContactFlag bits met on the way
  };

  /// Integrates m_eff δ'' = −F(δ; history) by Runge and Kutta's fourth-order method from touch to
  /// separation, whose time is interpolated.
  /// @param steps about so many over the collision.
  /// @throws InputError unless all four numbers are finite and positive and steps ≥ 100.
  Collision
  collide(const ContactLaw &law, const CollidingSpheres &spheres, unsigned int steps = 20000);
} // namespace dpcontact

#endif
