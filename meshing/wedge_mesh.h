#ifndef DPCONTACT_MESHING_WEDGE_MESH_H
#define DPCONTACT_MESHING_WEDGE_MESH_H

#include "meshing/zones.h"

#include <deal.II/grid/tria.h>

namespace dpcontact
{
  /// Fills `mesh` with the wedge 0 ≤ θ ≤ angle of the half-ball z ≤ 0 about the contact's centre,
  /// the given zones turned about the z axis: the core is a cylinder as deep as wide, shells graded
  /// geometrically lead from there to the sphere of radius `domain_radius`. Boundary ids are those
  /// of boundary_ids.h, the planes of symmetry carrying boundary::axis.
  ///
  /// Sections are o-grids (section_map.h): a kite around the axis and rings that are circles from
  /// 0.9 contact radii on. `resolution` counts the elements across the contact radius along θ = 0;
  /// at the radius 1 elements are 1.1 to 1.6 times as long around as across. gmsh meshes coarse
  /// blocks, deal.II halves cells in the zones, and only then vertices are placed, so that those of
  /// halved cells lie on circles and spheres as well. Hanging vertices are the midpoints of their
  /// straight edges and the means of their faces' corners: the mesh neither opens nor overlaps.
  ///
  /// Unlike the half plane there are at most three halvings, because circles want at least four
  /// cells around a quarter everywhere, and the first reaches 2.5 times `plastic_zone`: bricks 22.5
  /// degrees wide are too stiff where a tenth of the approach is still to come.
  /// @param angle π/4, π/2 or 2π (the whole half-ball, a quarter and its mirror images).
  /// @throws InputError for zones or an angle out of range; `resolution` must be at least 4, `octaves` 0.
  /// SolverError where gmsh's mesh is not what was asked.
  void make_wedge_mesh(const Zones &zones, double angle, dealii::Triangulation<3> &mesh);
} // namespace dpcontact

#endif
