#include "solver/path/load_path.h"
#include "tests/support/contact_problem.h"
#include "tests/support/floating_point_traps.h"
#include "tests/support/solver_environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{
  using namespace dpcontact;
  using tests::ContactProblem;

  const auto *const traps  = tests::FloatingPointTraps::install();
  const auto *const solver = tests::SolverEnvironment::install();

  constexpr double nu = 0.2, friction_angle = 30;
  constexpr double strength = 0.08; // yields at 1/45 of Hertz's force for a contact radius of 1

  /// Loads and unloads one problem by a few steps.
  std::vector<CurvePoint> run(ContactSystem<2> &system)
  {
    LoadPath<2>::Options options;
    options.loading_steps   = 8;
    options.unloading_steps = 4;
    LoadPath<2> path(system, options, {});
    auto        points    = path.load(0.5 * ContactProblem::hertz_force(nu), 1.);
    const auto  unloading = path.unload();
    points.insert(points.end(), unloading.begin(), unloading.end());
    EXPECT_EQ(path.counters().cut_backs, 0u); // other sub-steps would be another path
    return points;
  }

  TEST(Condensation, plastic_axisymmetric_curve_is_that_of_the_whole_body)
  {
    // Both are the same equations; what differs is rounding, and Newton's tolerance of 1e-10.
    constexpr double tolerance = 1e-8;
    ContactProblem   whole(nu, friction_angle, strength, 16);
    ContactSystem<2> condensed(
      whole.space, whole.system.materials(), 1., 1e5, Condensation::nested_subdomains);
    const auto expected = run(whole.system);
    const auto found    = run(condensed);
    ASSERT_EQ(found.size(), expected.size());
    const double most = 2 * whole.system.unknowns().approach;
    for (std::size_t i = 0; i < found.size(); ++i)
      {
        EXPECT_NEAR(found[i].approach, expected[i].approach, tolerance * most) << i;
        EXPECT_NEAR(found[i].force, expected[i].force, tolerance * expected[8].force) << i;
        EXPECT_NEAR(found[i].dissipated_energy,
                    expected[i].dissipated_energy,
                    tolerance * expected.back().dissipated_energy)
          << i;
        EXPECT_NEAR(found[i].plastic_volume,
                    expected[i].plastic_volume,
                    tolerance * expected.back().plastic_volume)
          << i;
      }
    EXPECT_GT(expected[8].plastic_volume, 0);
    ASSERT_EQ(condensed.unknowns().u.size(), whole.system.unknowns().u.size());
    double largest = 0;
    for (const double value : whole.system.unknowns().u)
      largest = std::max(largest, std::abs(value));
    for (std::size_t i = 0; i < condensed.unknowns().u.size(); ++i)
      EXPECT_NEAR(condensed.unknowns().u[i], whole.system.unknowns().u[i], tolerance * largest);
  }

  TEST(Condensation, a_subdomain_that_is_too_small_says_so_and_grows_until_it_holds)
  {
    ContactProblem   whole(nu, friction_angle, strength, 16);
    ContactSystem<2> system(
      whole.space, whole.system.materials(), 1., 1e5, Condensation::nested_subdomains);
    using Control    = ContactSystem<2>::Control;
    const auto start = system.snapshot();
    const auto solve = [](ContactSystem<2> &of) {
      of.unknowns().approach = 0.5;
      of.set_control(Control::approach, 0.5, ContactProblem::hertz_force(nu));
      const NewtonReport report = solve_newton(of, NewtonOptions{});
      EXPECT_TRUE(report.converged) << report.reason;
    };
    unsigned int growths = 0;
    for (;; ++growths)
      {
        ASSERT_LT(growths, 20u);
        solve(system);
        if (system.complete())
          break;
        system.restore(start);
        system.grow();
      }
    EXPECT_GT(growths, 0u); // one step from nothing reaches beyond the first core
    solve(whole.system);
    EXPECT_NEAR(system.force(), whole.system.force(), 1e-8 * whole.system.force());
  }
} // namespace
