#ifndef DPCONTACT_MESHING_GMSH_SESSION_H
#define DPCONTACT_MESHING_GMSH_SESSION_H

#include <deal.II/grid/tria.h>

namespace dpcontact
{
  /// gmsh is a process-wide library: one session at a time, opened and closed by scope.
  class GmshSession
  {
  public:
    /// Starts gmsh, silent, with an empty model.
    GmshSession();
    ~GmshSession();
    GmshSession(const GmshSession &)            = delete;
    GmshSession &operator=(const GmshSession &) = delete;

    /// Meshes the model's surfaces and hands the result to `mesh` with its boundary ids.
    /// @throws SolverError where other cells than quadrilaterals come out.
    void mesh_into(dealii::Triangulation<2> &mesh) const;
  };

  /// Throws SolverError unless every cell is a quadrilateral of positive Jacobian at its corners.
  void check_jacobians(const dealii::Triangulation<2> &mesh);

  /// Throws SolverError unless every cell is a quadrilateral of positive Jacobian at its corners
  /// and every boundary face carries an id of boundary_ids.h that fits where it lies.
  void check_mesh(const dealii::Triangulation<2> &mesh);
} // namespace dpcontact

#endif
