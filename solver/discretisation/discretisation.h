#ifndef DPCONTACT_SOLVER_DISCRETISATION_DISCRETISATION_H
#define DPCONTACT_SOLVER_DISCRETISATION_DISCRETISATION_H

#include "solver/discretisation/far_field.h"
#include "solver/discretisation/kinematics.h"
#include "solver/parallel/communicator.h"
#include "solver/problem/element.h"

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <vector>

namespace dpcontact
{
  /// Everything of the finite-element system that no material state touches, computed once a mesh.
  ///
  /// One body, or two that are pressed together: the second is the mirror image of the first, on
  /// the mirror image of the mesh, and its coordinates and displacements are those of the image, so
  /// that both bodies lie where the last coordinate is negative. Unknowns and cells of the first
  /// body come first. Over several processes each holds the cells of its own part of the mesh
  /// (subdomain id = rank), of both bodies, and all of the surface.
  ///
  /// Constrained degrees of freedom (hanging nodes, serendipity centres, axis or symmetry planes,
  /// and the far boundary, which follows Boussinesq's field with one amplitude) are eliminated cell
  /// by cell: strains are given directly in the free unknowns, numbered 0 … n_free()−1.
  template <int dim>
  class Discretisation
  {
  public:
    static constexpr unsigned int n_strains = Kinematics<dim>::n_strains;
    using StrainRow                         = std::array<double, n_strains>;

    struct QuadraturePoint
    {
      dealii::Point<dim>     position;
      double                 weight; ///< JxW times the kinematics' measure
      std::vector<StrainRow> strain; ///< of each of the cell's unknowns at unit value
    };

    struct Cell
    {
      unsigned int                 body  = 0;
      unsigned int                 index = 0; ///< active cell index in the mesh
      std::vector<unsigned int>    unknowns;
      std::vector<QuadraturePoint> points;
    };

    /// A quadrature point of the surface: the inward displacement, of both bodies together where
    /// there are two, is −Σ value[i] u[unknowns[i]].
    /// The points are the face's nodes (Gauss–Lobatto): then every pressure has a nodal force of
    /// its own, whereas Gauss points leave patterns of pressure that no node feels, and that drift.
    struct SurfacePoint
    {
      double              radius;
      double              weight; ///< area seen along the axis, on which the pressure acts
      std::vector<double> value;  ///< of the normal displacement at unit unknown
    };

    struct SurfaceFace
    {
      /// Index into cells() of its cell of the first body; that of the second is as far behind the
      /// second body's first one. Invalid where another process has it.
      unsigned int              cell;
      std::vector<unsigned int> unknowns;
      std::vector<SurfacePoint> points;
    };

    /// @param mesh with the ids of boundary_ids.h and, for several processes, with subdomain ids;
    /// must outlive this object.
    /// @param far_fields of the body, or of the two bodies.
    Discretisation(const dealii::Triangulation<dim>        &mesh,
                   const std::vector<BoussinesqField<dim>> &far_fields,
                   Element                                  element,
                   const Communicator                      &communicator = Communicator());
    Discretisation(const dealii::Triangulation<dim> &mesh,
                   const BoussinesqField<dim>       &far_field,
                   Element                           element)
      : Discretisation(mesh, std::vector<BoussinesqField<dim>>{far_field}, element)
    {}

    const Communicator      &communicator() const { return processes; }
    unsigned int             n_bodies() const { return static_cast<unsigned int>(bodies.size()); }
    unsigned int             n_free() const { return n_free_unknowns; }
    const std::vector<Cell> &cells() const { return all_cells; }
    const std::vector<SurfaceFace> &surface() const { return surface_faces; }

    /// Stiffness that the exterior of a body adds to its unknown `far_unknown()`.
    double       exterior_stiffness(unsigned int body = 0) const { return bodies[body].exterior; }
    unsigned int far_unknown(unsigned int body = 0) const { return bodies[body].far_index; }
    /// Boussinesq amplitude (= force) for unit value of `far_unknown()`.
    double far_amplitude(unsigned int body = 0) const { return bodies[body].amplitude; }

    /// All nodal values of a body, constrained ones included, from the free unknowns.
    dealii::Vector<double> distribute(const std::vector<double> &free_values,
                                      unsigned int               body = 0) const;

    /// Where a free unknown stands.
    struct Unknown
    {
      dealii::Point<dim> position;
      unsigned int       component = 0;
      unsigned int       node      = 0; ///< its node's index in the mesh, shared by components
      unsigned int       body      = 0;
      unsigned int       owner     = 0; ///< lowest rank that has a cell of its node
    };
    /// Of every free unknown.
    std::vector<Unknown> unknowns() const;

    const dealii::DoFHandler<dim> &dof_handler() const { return dofs; }
    unsigned int                   points_per_direction() const { return quadrature_points; }

  private:
    /// What of a body differs from the other's.
    struct Body
    {
      dealii::AffineConstraints<double> constraints;
      std::vector<unsigned int>         free_index; ///< of each DoF; invalid where constrained
      unsigned int                      far_index = 0;
      double                            amplitude = 0;
      double                            exterior  = 0;
    };

    bool own(const typename dealii::DoFHandler<dim>::active_cell_iterator &cell) const
    {
      return processes.alone() || cell->subdomain_id() == processes.rank();
    }
    void constrain(const BoussinesqField<dim> &far_field, Element element, Body &body) const;
    void constrain_symmetry(dealii::AffineConstraints<double> &constraints) const;
    void constrain_serendipity(dealii::AffineConstraints<double> &constraints) const;
    void build_cells(unsigned int body, Element element);
    void build_surface();
    void build_exterior(const BoussinesqField<dim> &far_field, Body &body) const;

    /// Unknowns that a cell's or face's nodal values depend on, and the weights.
    struct Expansion
    {
      std::vector<unsigned int> unknowns;
      std::vector<std::vector<std::pair<unsigned int, double>>>
        terms; ///< per nodal value: (position, weight)
    };
    static Expansion expand(const Body                                         &body,
                            const std::vector<dealii::types::global_dof_index> &nodal);

    dealii::FESystem<dim>    fe;
    unsigned int             quadrature_points;
    dealii::DoFHandler<dim>  dofs;
    Communicator             processes;
    std::vector<Body>        bodies;
    std::vector<Cell>        all_cells;
    std::vector<SurfaceFace> surface_faces;
    unsigned int             n_free_unknowns = 0;
  };
} // namespace dpcontact

#endif
