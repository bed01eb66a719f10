#ifndef DPCONTACT_MESHING_SPHERE_CAP_H
#define DPCONTACT_MESHING_SPHERE_CAP_H

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

namespace dpcontact
{
  /// Where the map of the half plane r ≥ 0, y ≤ 0 into a sphere that touches y = 0 from below takes
  /// p.
  ///
  /// In polar coordinates about the contact point, θ measured from the axis downwards, (ρ, θ) goes
  /// to (ρ, θ θ_max(ρ)/(π/2)) with θ_max = arccos(ρ/2R): the surface y = 0 comes to lie on r² + (y
  /// + R)² = R², the axis and all distances from the contact point stay. Any unit of length.
  /// @param sphere_radius R, in the unit of p; |p| < 2R.
  dealii::Point<2> to_sphere(const dealii::Point<2> &p, double sphere_radius);

  /// Maps a mesh of the half plane into the cap of a sphere, vertex by vertex. Edges stay straight
  /// and hanging nodes the midpoints of theirs, so that the mesh neither opens nor overlaps.
  /// @param sphere_radius in the mesh's unit of length, at least the mesh's largest distance from the
  /// contact point, so that the far boundary lies inside the sphere.
  /// @throws InputError naming domain-radius where the mesh reaches further, SolverError where a cell's
  /// Jacobian is not positive.
  void map_to_sphere(double sphere_radius, dealii::Triangulation<2> &mesh);
} // namespace dpcontact

#endif
