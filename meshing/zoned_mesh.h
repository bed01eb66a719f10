#ifndef DPCONTACT_MESHING_ZONED_MESH_H
#define DPCONTACT_MESHING_ZONED_MESH_H

#include "meshing/zones.h"

#include <deal.II/grid/tria.h>

namespace dpcontact
{
  /// Fills `mesh` with the axisymmetric half plane r ≥ 0, y ≤ 0 (y = −depth) of the given zones:
  /// gmsh makes the blocks, deal.II halves the cells in the zones. Boundaries carry the ids of
  /// boundary_ids.h.
  /// @throws InputError for zones out of range, SolverError where gmsh's mesh is not what was asked
  /// (other cells than quadrilaterals, an unnamed boundary, a cell of negative Jacobian).
  void make_zoned_mesh(const Zones &zones, dealii::Triangulation<2> &mesh);
} // namespace dpcontact

#endif
