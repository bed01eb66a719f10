#ifndef DPCONTACT_SOLVER_DISCRETIZATION_H
#define DPCONTACT_SOLVER_DISCRETIZATION_H

#include "solver/element.h"
#include "solver/far_field.h"
#include "solver/kinematics.h"

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
  /// Constrained degrees of freedom (hanging nodes, serendipity centres, axis or symmetry planes,
  /// and the far boundary, which follows Boussinesq's field with one amplitude) are eliminated cell
  /// by cell: strains are given directly in the free unknowns, numbered 0 … n_free()−1.
  template <int dim>
  class Discretization
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
      std::vector<unsigned int>    unknowns;
      std::vector<QuadraturePoint> points;
    };

    /// A quadrature point of the surface: the inward displacement is −Σ value[i] u[unknowns[i]].
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
      unsigned int              cell; ///< index of its cell
      std::vector<unsigned int> unknowns;
      std::vector<SurfacePoint> points;
    };

    /// @param mesh with the ids of boundary_ids.h; must outlive this object.
    Discretization(const dealii::Triangulation<dim> &mesh,
                   const BoussinesqField<dim>       &far_field,
                   Element                           element);

    unsigned int                    n_free() const { return n_free_unknowns; }
    const std::vector<Cell>        &cells() const { return all_cells; }
    const std::vector<SurfaceFace> &surface() const { return surface_faces; }

    /// Stiffness that the exterior adds to the unknown `far_unknown()`.
    double       exterior_stiffness() const { return exterior; }
    unsigned int far_unknown() const { return far_index; }
    /// Boussinesq amplitude (= force) for unit value of `far_unknown()`.
    double far_amplitude() const { return amplitude; }

    /// All nodal values, constrained ones included, from the free unknowns.
    dealii::Vector<double> distribute(const std::vector<double> &free_values) const;

    const dealii::DoFHandler<dim> &dof_handler() const { return dofs; }
    unsigned int                   points_per_direction() const { return quadrature_points; }

  private:
    void constrain(const BoussinesqField<dim> &far_field, Element element);
    void build_cells();
    void build_surface();
    void build_exterior(const BoussinesqField<dim> &far_field);

    /// Unknowns that a cell's or face's nodal values depend on, and the weights.
    struct Expansion
    {
      std::vector<unsigned int> unknowns;
      std::vector<std::vector<std::pair<unsigned int, double>>>
        terms; ///< per nodal value: (position, weight)
    };
    Expansion expand(const std::vector<dealii::types::global_dof_index> &nodal) const;

    dealii::FESystem<dim>             fe;
    unsigned int                      quadrature_points;
    dealii::DoFHandler<dim>           dofs;
    dealii::AffineConstraints<double> constraints;
    std::vector<unsigned int>         free_index; ///< of each DoF; invalid where constrained
    std::vector<Cell>                 all_cells;
    std::vector<SurfaceFace>          surface_faces;
    unsigned int                      n_free_unknowns = 0;
    unsigned int                      far_index       = 0;
    double                            amplitude       = 0;
    double                            exterior        = 0;
  };
} // namespace dpcontact

#endif
