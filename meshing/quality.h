#ifndef DPCONTACT_MESHING_QUALITY_H
#define DPCONTACT_MESHING_QUALITY_H

#include "meshing/mesh_quality.h"

#include <deal.II/grid/tria.h>

namespace dpcontact
{
  /// The figures of a mesh.
  /// @param contact_radius in the mesh's own unit
  /// @throws InputError where the contact radius is not positive or reaches past the surface,
  /// SolverError where the mesh has no cells or other cells than quadrilaterals or bricks.
  template <int dim>
  MeshQuality assess(const dealii::Triangulation<dim> &mesh, double contact_radius);
} // namespace dpcontact

#endif
