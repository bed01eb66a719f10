#include "meshing/boundary_ids.h"
#include "solver/closed_form/hertz.h"
#include "solver/path/runs.h"
#include "tests/support/contact_problem.h"
#include "tests/support/floating_point_traps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
  using namespace dpcontact;
  using tests::ContactProblem;
  using Control = ContactSystem<2>::Control;

  const auto *const traps = tests::FloatingPointTraps::install();

  constexpr unsigned int resolution = 10;

  /// Largest relative error of F(δ) against Hertz over the upper nine tenths of the load.
  double hertz_error(const double nu, const Element element)
  {
    const Material rock{10e9, nu, Angle(30), 1e15};
    const Scene    scene;
    SolverOptions  options;
    options.resolution      = resolution;
    options.element         = element;
    const double   approach = hertz::approach(rock, scene.radius, scene.force_max);
    HalfSpaceModel model(rock, scene, options, hertz::contact_radius(scene.radius, approach));
    double         error = 0;
    for (const auto &point : run_to_peak(model, 8))
      if (point.force >= 0.1 * scene.force_max)
        error = std::max(
          error, std::abs(point.force / hertz::force(rock, scene.radius, point.approach) - 1));
    return error;
  }

  TEST(Locking, axisymmetric_hertz_contact_nearly_incompressible)
  {
    // A contact edge between two nodes leaves about 0.2 % here, whatever ν is: one bound for all.
    for (const double nu : {0.3, 0.49, 0.499})
      EXPECT_LT(hertz_error(nu, Element::serendipity_reduced), 2.5e-3) << "nu = " << nu;
    // What locking looks like: 0.6 and 2.9 times the force too much.
    EXPECT_GT(hertz_error(0.49, Element::linear_full), 0.3);
    EXPECT_GT(hertz_error(0.499, Element::linear_full), 1.);
  }

  /// Mean pressure, over the shear strength k, under a flat smooth circular punch that is pushed
  /// further and further into a von Mises half-space. The punch is the part r < a of the surface
  /// under a sphere of infinite radius; the rest of the surface carries no boundary id and is free.
  std::vector<double> punch_pressure(const Element element, const unsigned int cells)
  {
    Zones zones;
    zones.resolution    = cells;
    zones.domain_radius = 50;
    dealii::Triangulation<2> mesh;
    make_zoned_mesh(zones, mesh);
    double edge = 0; // the last node inside r = 1
    for (const auto &face : mesh.active_face_iterators())
      if (face->at_boundary() && face->boundary_id() == boundary::surface)
        {
          const double outer = std::max(face->vertex(0)[0], face->vertex(1)[0]);
          if (outer < 1 + 1e-6)
            edge = std::max(edge, outer);
          else
            face->set_boundary_id(99);
        }
    const double              strength = 1e-3, E = 1, nu = 0.3;
    const laws::DruckerPrager mises{E / (2 * (1 + nu)), E / (3 * (1 - 2 * nu)), 0., strength};
    const Discretisation<2>   space(mesh, BoussinesqField<2>(E, nu), element);
    ContactSystem<2>          system(space, {mises}, 1e30, 1e4);
    std::vector<double>       pressures;
    const double              area = M_PI * edge * edge;
    for (int i = 1; i <= 40; ++i)
      {
        const double depth = 40. * strength * edge * i / 40;
        system.set_control(Control::approach, depth, strength * area);
        const auto report = solve_newton(system, NewtonOptions());
        EXPECT_TRUE(report.converged) << report.reason << " at step " << i;
        pressures.push_back(system.force() / area / strength);
        system.commit();
      }
    return pressures;
  }

  // Collapse of a smooth circular punch on a Tresca half-space: 5.69 c (Shield, Proc. R. Soc. A
  // 233, 1955). The Mises cylinder of shear strength k lies inside Tresca's of c = k and round that
  // of c = √3 k/2: its collapse load is between 4.93 k and 5.69 k.
  constexpr double lower_bound = 4.93, upper_bound = 5.69;

  TEST(Locking, axisymmetric_smooth_punch_on_von_mises_half_space_collapses)
  {
    const auto p = punch_pressure(Element::serendipity_reduced, resolution);
    EXPECT_GT(p.back(), lower_bound);
    EXPECT_LT(p.back(), upper_bound);
    // A plateau: a quarter more indentation adds 1.0 % (elastic: 33 %).
    EXPECT_LT(p.back() / p[3 * p.size() / 4 - 1], 1.015);
    EXPECT_GE(p.back(), p[p.size() / 2]);
  }

  TEST(Locking, axisymmetric_smooth_punch_shows_that_linear_elements_lock)
  {
    const auto p = punch_pressure(Element::linear_full, resolution);
    EXPECT_GT(p.back(), 1.3 * upper_bound);
    EXPECT_GT(p.back() / p[3 * p.size() / 4 - 1], 1.08) << "no plateau";
  }

  /// Approach at the peak of a strongly plastic dilatant contact.
  double dilatant_approach(const Element element, const unsigned int cells)
  {
    const double         nu = 0.1, friction_angle = 40, strength = 0.05;
    ContactProblem       problem(nu, friction_angle, strength, cells, 1e5, element);
    LoadPath<2>::Options options;
    options.loading_steps = 16;
    LoadPath<2> path(problem.system, options, {});
    return path.load(0.6 * ContactProblem::hertz_force(nu), 1.).back().approach;
  }

  TEST(Locking, axisymmetric_contact_with_associated_dilatant_flow)
  {
    // φ = 40°. Quadratic elements are within 0.15 % of the finest mesh on both coarse ones; linear
    // ones are 3 to 4.5 % too stiff on both.
    const double reference = dilatant_approach(Element::serendipity_reduced, 27);
    for (const unsigned int cells : {7u, 13u})
      {
        EXPECT_NEAR(dilatant_approach(Element::serendipity_reduced, cells) / reference, 1, 0.003)
          << cells << " cells";
        EXPECT_LT(dilatant_approach(Element::linear_full, cells) / reference, 0.975)
          << cells << " cells";
      }
  }
} // namespace
