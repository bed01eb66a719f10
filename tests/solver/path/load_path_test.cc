#include "meshing/errors.h"
#include "solver/path/solution.h"
#include "solver/path/solve.h"
#include "tests/support/contact_problem.h"
#include "tests/support/floating_point_traps.h"
#include "tests/support/solver_environment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{
  using namespace dpcontact;
  using tests::ContactProblem;

  const auto *const traps  = tests::FloatingPointTraps::install();
  const auto *const solver = tests::SolverEnvironment::install();

  constexpr double nu = 0.2, friction_angle = 30;
  constexpr double elastic_strength = 1e9, plastic_strength = 0.08; // yields at 1/45 of the peak
  constexpr unsigned int resolution = 8;

  double peak() { return 0.5 * ContactProblem::hertz_force(nu); }

  LoadPath<2>::Options options(const unsigned int loading_steps, const unsigned int unloading_steps)
  {
    LoadPath<2>::Options result;
    result.loading_steps   = loading_steps;
    result.unloading_steps = unloading_steps;
    return result;
  }

  TEST(LoadPath, axisymmetric_elastic_scene_unloads_along_its_loading)
  {
    // Other levels down than up: an elastic state depends on its force alone. The contact closes
    // its gaps to 1e-7 of the approach, Newton is converged to 1e-10 of the force.
    ContactProblem problem(nu, friction_angle, elastic_strength, resolution);
    LoadPath<2>    path(problem.system, options(6, 5), {});
    const auto     loading   = path.load(peak(), 1.);
    const auto     unloading = path.unload();
    const double   most      = loading.back().approach;
    EXPECT_EQ(unloading.front().approach, most);

    ContactProblem direct(nu, friction_angle, elastic_strength, resolution);
    for (std::size_t i = 1; i + 1 < unloading.size(); ++i)
      {
        direct.system.reset();
        LoadPath<2> up(direct.system, options(3, 1), {});
        EXPECT_NEAR(
          up.load(unloading[i].force, 1.).back().approach, unloading[i].approach, 1e-6 * most)
          << "at " << unloading[i].force / peak() << " of the peak";
      }
    EXPECT_EQ(unloading.back().force, 0.);
    EXPECT_NEAR(unloading.back().approach, 0, 1e-9 * most);
    EXPECT_EQ(unloading.back().dissipated_energy, 0.);
    EXPECT_EQ(path.counters().cut_backs, 0u);
  }

  TEST(LoadPath, axisymmetric_plastic_branches_are_strictly_monotone)
  {
    ContactProblem problem(nu, friction_angle, plastic_strength, resolution);
    LoadPath<2>    path(problem.system, options(8, 8), {});
    const auto     loading = path.load(peak(), 1.), unloading = path.unload();
    ASSERT_EQ(loading.size(), 9u);
    ASSERT_EQ(unloading.size(), 9u);
    for (std::size_t i = 1; i < loading.size(); ++i)
      {
        EXPECT_GT(loading[i].force, loading[i - 1].force);
        EXPECT_GT(loading[i].approach, loading[i - 1].approach);
        EXPECT_GE(loading[i].plastic_volume, loading[i - 1].plastic_volume);
        EXPECT_GE(loading[i].dissipated_energy, loading[i - 1].dissipated_energy);
      }
    for (std::size_t i = 1; i < unloading.size(); ++i)
      {
        EXPECT_LT(unloading[i].force, unloading[i - 1].force);
        EXPECT_LT(unloading[i].approach, unloading[i - 1].approach);
      }
    EXPECT_GT(unloading.back().approach, 0.1 * loading.back().approach) << "a dent stays";
  }

  struct Energies
  {
    double work;       ///< ∮ F dδ, by the trapezoidal rule
    double dissipated; ///< Σ σₙ₊₁:Δεᵖ
    double locked_in;  ///< elastic energy of the residual stresses, both spheres
  };

  Energies cycle(const unsigned int steps)
  {
    ContactProblem problem(nu, friction_angle, plastic_strength, resolution);
    LoadPath<2>    path(problem.system, options(steps, steps), {});
    auto           points = path.load(peak(), 1.);
    const auto     back   = path.unload();
    points.insert(points.end(), back.begin() + 1, back.end());
    Energies energies{0, points.back().dissipated_energy, 0};
    for (std::size_t i = 1; i < points.size(); ++i)
      energies.work +=
        (points[i].force + points[i - 1].force) / 2 * (points[i].approach - points[i - 1].approach);
    energies.locked_in = 2 * problem.system.commit().elastic_energy;
    return energies;
  }

  TEST(LoadPath, axisymmetric_plastic_cycle_work_is_dissipated_or_locked_in)
  {
    // Backward Euler weighs the plastic strain of a step with the stress at its end, which leaves a
    // gap of first order in the step: 4.6 % of the work with 5 steps, 1.3 % with 10. Further down
    // the trapezoidal rule and the contact's edge, which moves node by node, scatter it (below 0.1
    // %), so that the order is judged by a bound and by both ends.
    std::vector<double> gaps;
    for (const unsigned int steps : {5u, 10u, 20u, 40u, 80u})
      {
        const auto e = cycle(steps);
        gaps.push_back(std::abs((e.dissipated + e.locked_in) / e.work - 1));
        EXPECT_GT(e.locked_in, 0.1 * e.work) << "residual stresses must count";
        EXPECT_LT(gaps.back(), 0.25 / steps) << steps << " steps";
      }
    EXPECT_LT(gaps[1], 0.6 * gaps[0]);
    EXPECT_LT(gaps.back(), gaps.front() / 16);
  }

  TEST(LoadPath, a_step_out_of_reach_is_an_error_with_its_reason)
  {
    ContactProblem problem(nu, friction_angle, plastic_strength, resolution);
    auto           out_of_reach        = options(1, 1);
    out_of_reach.max_cut_backs         = 0;
    out_of_reach.newton.max_iterations = 2;
    LoadPath<2> path(problem.system, out_of_reach, {});
    try
      {
        path.load(peak(), 1.);
        FAIL() << "two iterations cannot make this step";
      }
    catch (const SolverError &error)
      {
        const std::string message = error.what();
        EXPECT_NE(message.find("loading stopped"), std::string::npos) << message;
        EXPECT_NE(message.find("no convergence in 2 Newton iterations"), std::string::npos)
          << message;
      }
    EXPECT_EQ(path.counters().cut_backs, 1u);
    EXPECT_EQ(path.counters().steps, 0u);
  }

  TEST(LoadPath, a_step_that_fails_is_rolled_back_and_halved)
  {
    // So few iterations that the nominal steps fail: the smaller ones reach the same states up to
    // the load-step error.
    ContactProblem easy(nu, friction_angle, plastic_strength, resolution);
    LoadPath<2>    plain(easy.system, options(6, 3), {});
    const double   expected = plain.load(peak(), 1.).back().approach;

    ContactProblem hard(nu, friction_angle, plastic_strength, resolution);
    auto           few        = options(6, 3);
    few.newton.max_iterations = 6;
    LoadPath<2> path(hard.system, few, {});
    const auto  reached = path.load(peak(), 1.);
    EXPECT_GT(path.counters().cut_backs, 0u);
    EXPECT_EQ(reached.size(), 7u) << "points stay on the nominal levels";
    EXPECT_NEAR(reached.back().force / peak(), 1, 1e-9);
    EXPECT_NEAR(reached.back().approach, expected, 0.05 * expected);
  }

  Solution solve(const Material &material, const Scene &scene, const double step_tolerance = 0.05)
  {
    SolverOptions coarse;
    coarse.resolution     = resolution;
    coarse.step_tolerance = step_tolerance;
    return solve_contact(material, scene, coarse);
  }

  bool warns_of(const Solution &solution, const std::string &what)
  {
    return std::any_of(
      solution.warnings.begin(), solution.warnings.end(), [&](const std::string &warning) {
        return warning.find(what) != std::string::npos;
      });
  }

  TEST(LoadPath, results_outside_small_strain_carry_a_warning)
  {
    const Material hard{10e9, 0.2, Angle(30), 1e15};
    const Scene    small_force{0.1, 100.}, large_force{0.1, 6e5}; // a/R = 0.009 and 0.16
    EXPECT_FALSE(warns_of(solve(hard, small_force), "small strain"));
    const auto wide = solve(hard, large_force);
    EXPECT_TRUE(warns_of(wide, "contact radius over sphere radius"));
    EXPECT_FALSE(warns_of(wide, "plastic strain"));

    // A weak rock: the plastic strain reaches 0.12 while a/R is below 0.1.
    const Material weak{10e9, 0.1, Angle(20), 1e6};
    const auto     strained = solve(weak, {0.1, 2000.}, 0.02);
    EXPECT_TRUE(warns_of(strained, "plastic strain"));
    EXPECT_FALSE(warns_of(strained, "contact radius over sphere radius"));
  }
} // namespace
