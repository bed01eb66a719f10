#ifndef DPCONTACT_MESHING_GMSH_SESSION_H
#define DPCONTACT_MESHING_GMSH_SESSION_H

#include <deal.II/base/numbers.h>
#include <deal.II/grid/tria.h>

#include <vector>

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

    /// Finishes the geometry of a half plane and gives its lines the ids of boundary_ids.h.
    /// @param axis lines of the axis of symmetry
    /// @param surface lines of the surface
    /// @param far lines of the far boundary
    /// @param faces all surfaces that are to be meshed
    void name_groups(const std::vector<int> &axis,
                     const std::vector<int> &surface,
                     const std::vector<int> &far,
                     const std::vector<int> &faces) const;

    /// Meshes the model's surfaces, or volumes, and hands the result to `mesh` with its boundary
    /// ids.
    /// @throws SolverError where other cells than quadrilaterals, or bricks, come out; FileError
    /// where the directory for temporary files (TMPDIR) is missing or full.
    template <int dim>
    void mesh_into(dealii::Triangulation<dim> &mesh) const;
  };

  /// @throws SolverError unless every cell is a quadrilateral, or brick, of positive Jacobian at its
  /// corners.
  template <int dim>
  void check_jacobians(const dealii::Triangulation<dim> &mesh);

  /// Checks a mesh that has its final shape.
  /// @param angle in space, of the wedge 0 ≤ θ ≤ angle; its planes θ = 0 and θ = angle are
  /// boundary::axis unless it goes all the way round.
  /// @throws SolverError unless every cell is a quadrilateral, or brick, of positive Jacobian at its
  /// corners and every boundary face carries an id of boundary_ids.h that fits where it lies.
  template <int dim>
  void check_mesh(const dealii::Triangulation<dim> &mesh, double angle = dealii::numbers::PI_2);
} // namespace dpcontact

#endif
