#ifndef DPCONTACT_SOLVER_DISCRETISATION_UNDEFORMED_GAP_H
#define DPCONTACT_SOLVER_DISCRETISATION_UNDEFORMED_GAP_H

#include <cmath>

namespace dpcontact
{
  /// The undeformed gap h(r) between one sphere and the plane that touches it.
  ///
  /// h = (1 − √(1 − κ²r²))/(κ²R), written without cancellation. With lengths and gaps both in
  /// metres κ = 1/R; with lengths in units of a and gaps in a²/R the R of the formula is 1 and κ =
  /// a/R. κ = 0 is the parabola r²/(2R) of the half-space.
  class UndeformedGap
  {
  public:
    /// @param radius R and @param curvature κ, in the system's units; κ ≥ 0.
    UndeformedGap(const double radius, const double curvature = 0)
      : sphere_radius(radius)
      , kappa(curvature)
    {}

    double radius() const { return sphere_radius; }

    /// @param r distance from the axis; κr ≤ 1.
    double gap(const double r) const
    {
      return r * r / (sphere_radius * (1 + std::sqrt(1 - kappa * kappa * r * r)));
    }

  private:
    double sphere_radius;
    double kappa;
  };
} // namespace dpcontact

#endif
