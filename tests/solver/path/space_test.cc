#include "solver/closed_form/first_yield.h"
#include "solver/closed_form/hertz.h"
#include "solver/path/runs.h"
#include "tests/support/solver_environment.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace dpcontact;

  const auto *const environment = tests::SolverEnvironment::install();

  const Material rock{10e9, .15, Angle(25), 15e6};

  SolverOptions
  sector(const Element element, const unsigned int resolution, const LinearSolver linear_solver)
  {
    SolverOptions options = SolverOptions::of(Geometry::sector);
    options.sector_angle  = 45; // between oblique planes of symmetry
    options.element       = element;
    options.resolution    = resolution;
    options.linear_solver = linear_solver;
    return options;
  }

  /// What an elastic step and a plastic one after it lead to.
  struct Outcome
  {
    double       elastic_approach, plastic_approach, plastic_volume; ///< m, m³
    double       hertz;                                              ///< elastic approach, m
    unsigned int linear_solves, linear_iterations;
  };

  template <int dim>
  Outcome two_steps(Scene scene, const SolverOptions &options)
  {
    const FirstYield yield   = first_yield(rock, scene);
    const double     elastic = .9 * yield.onset_force();
    scene.force_max          = 1.15 * yield.force;
    const double radius =
      hertz::contact_radius(scene, hertz::approach(rock, scene, scene.force_max));
    ContactModel<dim> model(rock, scene, options, radius);
    const auto        legs = run_history(model, {{elastic, 1}, {scene.force_max, 1}});
    return {legs[0].back().approach,
            legs[1].back().approach,
            legs[1].back().plastic_volume,
            hertz::approach(rock, scene, elastic),
            model.system().linear_solves(),
            model.system().linear_iterations()};
  }

  // On the far-reaching mesh that `solve` uses: aggregates of one node, which leave empty rows in
  // the coarse matrices of the multigrid, come with the default domain and 16 elements across the
  // contact.
  TEST(Space, IterativeSolverAgreesWithDirectAndScales)
  {
    double few = 0;
    for (const unsigned int resolution : {8u, 16u})
      {
        const auto element = Element::linear_mean_dilatation;
        const auto direct  = two_steps<3>({}, sector(element, resolution, LinearSolver::direct));
        const auto iterative =
          two_steps<3>({}, sector(element, resolution, LinearSolver::iterative));
        // Two a Newton iteration, of which the Krylov method's tolerance may ask one more.
        EXPECT_NEAR(iterative.linear_solves, direct.linear_solves, 2);
        EXPECT_NEAR(iterative.elastic_approach / direct.elastic_approach, 1, 1e-8);
        EXPECT_NEAR(iterative.plastic_approach / direct.plastic_approach, 1, 1e-8);
        EXPECT_GT(direct.plastic_volume, 0);
        EXPECT_NEAR(iterative.plastic_volume / direct.plastic_volume, 1, 1e-6);
        EXPECT_EQ(direct.linear_iterations, 0u);
        const double iterations = double(iterative.linear_iterations) / iterative.linear_solves;
        if (few == 0)
          few = iterations;
        EXPECT_LT(iterations, 2 * few);
        EXPECT_LT(iterations, 40);
      }
  }

  /// Quadratic elements, four across the contact, against axisymmetry with ten times as many. The
  /// mesh leaves 0.1 % of the approach in space.
  void expect_axisymmetry(const Scene &scene)
  {
    const auto space =
      two_steps<3>(scene, sector(Element::quadratic_full, 4, LinearSolver::direct));
    const auto plane = two_steps<2>(scene, SolverOptions());
    EXPECT_NEAR(plane.elastic_approach / plane.hertz, 1, 3e-4);
    EXPECT_NEAR(space.elastic_approach / plane.hertz, 1, 1.5e-3);
    EXPECT_NEAR(space.plastic_approach / plane.plastic_approach, 1, 1.5e-3);
  }

  TEST(Space, QuadraticElementsAgreeWithAxisymmetry) { expect_axisymmetry({}); }

  // A small, soft ball on a stiffer one of another strength.
  TEST(Space, UnlikeBodiesAgreeWithAxisymmetry)
  {
    Scene scene;
    scene.radius = .03;
    scene.second = SecondBody{.1, Material{50e9, .3, Angle(35), 30e6}};
    expect_axisymmetry(scene);
  }
} // namespace
