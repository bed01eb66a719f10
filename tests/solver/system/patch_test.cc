#include "meshing/boundary_ids.h"
#include "meshing/zoned_mesh.h"
#include "solver/system/contact_system.h"
#include "tests/support/floating_point_traps.h"

#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_generator.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <set>

namespace
{
  using namespace dpcontact;
  using dealii::Point;
  using dealii::Tensor;
  using dealii::Triangulation;

  const auto *const traps = tests::FloatingPointTraps::install();

  constexpr double nu = 0.3;

  /// Strains and residuals are sums of up to some hundred terms of size ~ 1 / (smallest cell ~
  /// 0.02).
  constexpr double rounding = 1e-11;

  /// A block next to the origin with irregular cells, refined on one side: hanging nodes too.
  template <int dim>
  void make_distorted_block(Triangulation<dim> &mesh)
  {
    Point<dim> low, high;
    for (unsigned int k = 0; k < dim; ++k)
      high[k] = 1;
    low[dim - 1]  = -1;
    high[dim - 1] = 0;
    dealii::GridGenerator::subdivided_hyper_rectangle(
      mesh, std::vector<unsigned int>(dim, dim == 2 ? 6 : 4), low, high);
    const double tolerance = 1e-8;
    for (const auto &face : mesh.active_face_iterators())
      if (face->at_boundary())
        {
          const auto c  = face->center();
          auto       id = boundary::far;
          if (c[dim - 1] > -tolerance)
            id = boundary::surface;
          for (unsigned int k = 0; k + 1 < dim; ++k)
            if (c[k] < tolerance)
              id = boundary::axis;
          face->set_boundary_id(id);
        }
    // Vertices move by at most a fifth of the cell: all Jacobians stay positive.
    std::mt19937      engine(3);
    const double      cell = dim == 2 ? 1. / 6 : 1. / 4;
    std::vector<bool> on_edge(mesh.n_vertices(), false), moved(mesh.n_vertices(), false);
    for (const auto &face : mesh.active_face_iterators())
      if (face->at_boundary())
        for (const unsigned int v : face->vertex_indices())
          on_edge[face->vertex_index(v)] = true;
    for (const auto &element : mesh.active_cell_iterators())
      for (const unsigned int v : element->vertex_indices())
        if (const auto index = element->vertex_index(v); !on_edge[index] && !moved[index])
          {
            moved[index] = true;
            for (unsigned int k = 0; k < dim; ++k)
              element->vertex(v)[k] +=
                0.4 * cell * (static_cast<double>(engine()) / 4294967295. - 0.5);
          }
    for (const auto &element : mesh.active_cell_iterators())
      if (element->center()[0] < 0.5 && element->center()[dim - 1] > -0.5)
        element->set_refine_flag();
    mesh.execute_coarsening_and_refinement();
  }

  /// Free unknowns that take the values of a displacement field at their nodes.
  template <int dim>
  std::vector<double> interpolate(const Discretisation<dim>                               &space,
                                  const std::function<Tensor<1, dim>(const Point<dim> &)> &field)
  {
    // A number of its own for every unknown shows which node it belongs to.
    std::mt19937                   engine(1);
    std::vector<double>            tags(space.n_free());
    std::map<double, unsigned int> unknown_of;
    for (unsigned int i = 0; i < tags.size(); ++i)
      {
        tags[i] = static_cast<double>(engine()) + static_cast<double>(engine()) / 4294967296.;
        unknown_of[tags[i]] = i;
      }
    const auto                                   nodal = space.distribute(tags);
    std::vector<double>                          u(space.n_free(), std::nan(""));
    const auto                                  &fe = space.dof_handler().get_fe();
    std::vector<dealii::types::global_dof_index> local(fe.n_dofs_per_cell());
    for (const auto &cell : space.dof_handler().active_cell_iterators())
      {
        cell->get_dof_indices(local);
        for (unsigned int i = 0; i < local.size(); ++i)
          if (const auto found = unknown_of.find(nodal[local[i]]); found != unknown_of.end())
            u[found->second] =
              field(dealii::StaticMappingQ1<dim>::mapping.transform_unit_to_real_cell(
                cell, fe.unit_support_point(i)))[fe.system_to_component_index(i).first];
      }
    for (const double value : u)
      EXPECT_FALSE(std::isnan(value)) << "an unknown without a node";
    return u;
  }

  template <int dim>
  bool follows_far_field(const Discretisation<dim>                &space,
                         const typename Discretisation<dim>::Cell &cell)
  {
    return std::find(cell.unknowns.begin(), cell.unknowns.end(), space.far_unknown()) !=
           cell.unknowns.end();
  }

  /// A linear field that the symmetry allows. dim = 2: (c r, d y + e), dim = 3: skewed too.
  template <int dim>
  Tensor<1, dim> linear_field(const Point<dim> &p, const double c, const double d)
  {
    Tensor<1, dim> u;
    for (unsigned int k = 0; k + 1 < dim; ++k)
      u[k] = c * (1. + k) * p[k];
    u[dim - 1] = d * p[dim - 1] + 0.4;
    if constexpr (dim == 3)
      u[2] += 0.3 * p[0] - 0.2 * p[1];
    return u;
  }

  template <int dim>
  typename Discretisation<dim>::StrainRow linear_strain(const double c, const double d)
  {
    if constexpr (dim == 2)
      return {c, d, c, 0.};
    else
      return {c, 2 * c, d, 0., 0.3, -0.2};
  }

  template <int dim>
  void expect_linear_fields_give_uniform_strain(const Discretisation<dim> &space)
  {
    unsigned int cells = 0;
    for (const auto &[c, d] :
         {std::pair(0.7, 0.), std::pair(0., -1.1), std::pair(0.3, 0.9), std::pair(0., 0.)})
      {
        const auto u = interpolate<dim>(
          space, [c = c, d = d](const Point<dim> &p) { return linear_field<dim>(p, c, d); });
        const auto expected = linear_strain<dim>(c, d);
        for (const auto &cell : space.cells())
          {
            if (follows_far_field(space, cell))
              continue;
            ++cells;
            for (const auto &point : cell.points)
              for (unsigned int s = 0; s < expected.size(); ++s)
                {
                  double strain = 0;
                  for (unsigned int i = 0; i < cell.unknowns.size(); ++i)
                    strain += u[cell.unknowns[i]] * point.strain[i][s];
                  ASSERT_NEAR(strain, expected[s], rounding)
                    << "component " << s << " at " << point.position;
                }
          }
      }
    EXPECT_GT(cells, space.cells().size()) << "most cells must have been looked at";
  }

  /// Residual of a uniform state, at the unknowns that only cells without far field touch; at the
  /// surface's normal displacements only where the state leaves the surface free.
  template <int dim>
  void expect_equilibrium(ContactSystem<dim> &system, const bool surface_is_free)
  {
    const auto            &space = system.discretisation();
    std::set<unsigned int> excluded;
    for (const auto &cell : space.cells())
      if (follows_far_field(space, cell))
        excluded.insert(cell.unknowns.begin(), cell.unknowns.end());
    if (!surface_is_free)
      for (const auto &face : space.surface())
        excluded.insert(face.unknowns.begin(), face.unknowns.end());
    unsigned int checked = 0;
    for (unsigned int i = 0; i < space.n_free(); ++i)
      if (excluded.count(i) == 0)
        {
          ++checked;
          ASSERT_NEAR(system.residual_vector()[i], 0, rounding) << "unknown " << i;
        }
    EXPECT_GT(checked, space.n_free() / 8);
  }

  template <int dim>
  void expect_uniform_stress_is_in_equilibrium(const Discretisation<dim> &space)
  {
    const laws::DruckerPrager law{1 / (2 * (1 + nu)), 1 / (3 * (1 - 2 * nu)), 0.2, 1e9};
    ContactSystem<dim>        system(space, {law}, 1., 1.);
    system.set_control(ContactSystem<dim>::Control::released, 0., 1.);

    // No shear: the planes of symmetry cannot hold it.
    system.unknowns().u = interpolate<dim>(space, [](const Point<dim> &p) {
      Tensor<1, dim> u;
      for (unsigned int k = 0; k < dim; ++k)
        u[k] = (k + 1 == dim ? 0.9 : 0.3) * p[k];
      return u;
    });
    system.residual();
    expect_equilibrium(system, false);

    // No stress on the surface: ε_yy = −ν/(1−ν) (the sum of the in-plane strains).
    system.unknowns().u = interpolate<dim>(space, [](const Point<dim> &p) {
      Tensor<1, dim> u;
      for (unsigned int k = 0; k + 1 < dim; ++k)
        u[k] = 0.3 * p[k];
      u[dim - 1] = -2 * 0.3 * nu / (1 - nu) * p[dim - 1];
      return u;
    });
    system.residual();
    expect_equilibrium(system, true);
  }

  /// Stretched past the cone's tip, every point returns to it: σ = k/(3α) I, in equilibrium.
  template <int dim>
  void expect_a_stretched_patch_stands_at_the_apex(const Discretisation<dim> &space)
  {
    const laws::DruckerPrager law{1 / (2 * (1 + nu)), 1 / (3 * (1 - 2 * nu)), 0.2, 0.01};
    const double              mean    = law.strength / (3 * law.alpha);
    const double              stretch = 2 * mean / (3 * law.bulk_modulus);
    ContactSystem<dim>        system(space, {law}, 1., 1.);
    system.set_control(ContactSystem<dim>::Control::released, 0., 1.);
    system.unknowns().u = interpolate<dim>(
      space, [stretch](const Point<dim> &p) { return stretch * Tensor<1, dim>(p); });
    system.residual();
    std::size_t  index = 0;
    unsigned int inner = 0;
    for (const auto &cell : space.cells())
      for (std::size_t q = 0; q < cell.points.size(); ++q, ++index)
        if (!follows_far_field(space, cell))
          {
            ++inner;
            const auto excess =
              system.points().stresses()[index] - mean * dealii::unit_symmetric_tensor<3>();
            ASSERT_LT(excess.norm(), rounding * mean) << cell.points[q].position;
          }
    expect_equilibrium(system, false);
    const auto integrals = system.commit();
    EXPECT_GE(integrals.apex_points, inner);
    EXPECT_LT(integrals.largest_yield_excess, 1e-12);

    // Back to where it yielded first: elastic, without stress as half of the stretch has stayed;
    // and to no stretch at all, under the pressure that this half takes.
    for (const double share : {0.5, 0.})
      {
        system.unknowns().u = interpolate<dim>(space, [stretch, share](const Point<dim> &p) {
          return share * stretch * Tensor<1, dim>(p);
        });
        system.residual();
        index = 0;
        for (const auto &cell : space.cells())
          for (std::size_t q = 0; q < cell.points.size(); ++q, ++index)
            if (!follows_far_field(space, cell))
              {
                const auto excess = system.points().stresses()[index] -
                                    (2 * share - 1) * mean * dealii::unit_symmetric_tensor<3>();
                ASSERT_LT(excess.norm(), rounding * mean) << cell.points[q].position;
              }
        expect_equilibrium(system, false);
        EXPECT_EQ(system.commit().apex_points, 0u);
      }
  }

  template <int dim>
  void expect_patch_tests(const Triangulation<dim> &mesh, const Element element)
  {
    ASSERT_TRUE(mesh.has_hanging_nodes());
    const Discretisation<dim> space(mesh, BoussinesqField<dim>(1., nu), element);
    expect_linear_fields_give_uniform_strain(space);
    expect_uniform_stress_is_in_equilibrium(space);
    expect_a_stretched_patch_stands_at_the_apex(space);
  }

  class Patch : public ::testing::TestWithParam<Element>
  {};

  TEST_P(Patch, axisymmetric_zoned_mesh)
  {
    Zones zones;
    zones.resolution    = 8;
    zones.domain_radius = 20;
    Triangulation<2> mesh;
    make_zoned_mesh(zones, mesh);
    expect_patch_tests(mesh, GetParam());
  }

  TEST_P(Patch, axisymmetric_distorted_mesh)
  {
    Triangulation<2> mesh;
    make_distorted_block(mesh);
    expect_patch_tests(mesh, GetParam());
  }

  TEST_P(Patch, space_distorted_mesh)
  {
    Triangulation<3> mesh;
    make_distorted_block(mesh);
    expect_patch_tests(mesh, GetParam());
  }

  INSTANTIATE_TEST_SUITE_P(
    elements,
    Patch,
    ::testing::Values(Element::serendipity_reduced, Element::quadratic_full, Element::linear_full),
    [](const auto &element) {
      return element.param == Element::serendipity_reduced ? "serendipity_reduced"
             : element.param == Element::quadratic_full    ? "quadratic_full"
                                                           : "linear_full";
    });
} // namespace
