#ifndef DPCONTACT_SOLVER_PATH_MODEL_MESH_H
#define DPCONTACT_SOLVER_PATH_MODEL_MESH_H

#include "meshing/mesh_quality.h"
#include "solver/path/solve.h"

#include <deal.II/grid/tria.h>

namespace dpcontact
{
  /// Makes the mesh that the options ask for: in units of the contact radius, or in m with
  /// Units::si.
  /// @param mesh_radius contact radius that the mesh is fitted to, m.
  /// @param sphere_radius m; it counts with Surface::sphere alone.
  /// @return figures of the mesh in units of the contact radius.
  /// @throws InputError naming domain-radius where a sphere's far boundary lies beyond its radius.
  template <int dim>
  MeshQuality make_model_mesh(const SolverOptions        &options,
                              double                      mesh_radius,
                              double                      sphere_radius,
                              dealii::Triangulation<dim> &mesh);
} // namespace dpcontact

#endif
