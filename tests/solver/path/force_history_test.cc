#include "meshing/errors.h"
#include "solver/closed_form/first_yield.h"
#include "solver/closed_form/hertz.h"
#include "solver/path/force_history.h"
#include "solver/path/solution.h"
#include "solver/path/solve.h"
#include "tests/support/floating_point_traps.h"
#include "tests/support/solver_environment.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace dpcontact;

  const auto *const traps  = tests::FloatingPointTraps::install();
  const auto *const solver = tests::SolverEnvironment::install();

  constexpr double radius = 0.1;

  Material rock(const double strength) { return {10e9, .2, Angle(30), strength}; }

  SolverOptions coarse()
  {
    SolverOptions options;
    options.resolution     = 16;
    options.step_tolerance = 0.01;
    return options;
  }

  TEST(ForceHistory, elastic_legs_lie_on_hertz)
  {
    // Whatever the path: 16 elements across the contact at the peak leave 0.5 % of the approach, at
    // a quarter of the peak's force 10 elements.
    const Material material = rock(1e9);
    const auto     history =
      solve_force_history(material, radius, {40., 10., 30., 100., 25., 0., 60., 0.}, coarse());
    ASSERT_EQ(history.legs.size(), 9u) << "the leg from 30 to 100 N is two, which meet at 40 N";
    EXPECT_NEAR(history.legs[3].back().force, 40, 1e-6);
    const double most = hertz::approach(material, radius, 100);
    for (const auto &leg : history.legs)
      for (const CurvePoint &point : leg)
        EXPECT_NEAR(point.approach, hertz::approach(material, radius, point.force), 7e-3 * most);
  }

  TEST(ForceHistory, plastic_legs_follow_the_branches_of_single_paths)
  {
    const Material      material = rock(5e6);
    const double        most     = 30 * first_yield(material, radius).force;
    const SolverOptions options  = coarse();
    const auto          history  = solve_force_history(
      material, radius, {most / 2, most / 8, .4 * most, most, most / 4, 0.}, options);
    ASSERT_EQ(history.legs.size(), 7u);
    EXPECT_LE(history.step_error, options.step_tolerance);
    for (std::size_t i = 1; i < history.legs.size(); ++i)
      {
        EXPECT_EQ(history.legs[i].front().force, history.legs[i - 1].back().force);
        EXPECT_NEAR(history.legs[i].front().approach,
                    history.legs[i - 1].back().approach,
                    1e-3 * history.legs[4].back().approach);
      }
    const Solution single = solve_contact(material, {radius, most}, options);
    const double   peak   = single.curve.loading.back().approach;
    // The way back and forth in between leaves 0.1 % (dilatant flow on reloading), the step as
    // much.
    EXPECT_NEAR(history.legs[4].back().approach / peak, 1, 4e-3);
    EXPECT_NEAR(history.legs.back().back().approach / single.curve.residual_approach(), 1, 2e-2);
    // Below the old peak reloading goes back along the release: within 1 % of its width.
    const auto &release = history.legs[1], &reload = history.legs[2];
    const auto  at_force = [](const std::vector<CurvePoint> &leg, const double force) {
      for (std::size_t i = 1; i < leg.size(); ++i)
        if ((leg[i - 1].force - force) * (leg[i].force - force) <= 0)
          {
            const double share =
              (std::pow(force, 2. / 3) - std::pow(leg[i - 1].force, 2. / 3)) /
              (std::pow(leg[i].force, 2. / 3) - std::pow(leg[i - 1].force, 2. / 3));
            return leg[i - 1].approach + share * (leg[i].approach - leg[i - 1].approach);
          }
      ADD_FAILURE() << "no such force";
      return 0.;
    };
    for (const double share : {.2, .3, .38})
      EXPECT_NEAR(at_force(reload, share * most), at_force(release, share * most), 1e-2 * peak);
    EXPECT_LT(at_force(reload, .3 * most), at_force(history.legs[0], .3 * most) * 1.5);
    EXPECT_GT(at_force(reload, .3 * most), at_force(history.legs[0], .3 * most))
      << "the dent stays";
  }

  TEST(ForceHistory, refuses_what_is_no_history)
  {
    const Material material = rock(5e6);
    for (const std::vector<double> &forces :
         {std::vector<double>{}, {0.}, {10., 10.}, {10., -1.}, {10., std::nan("")}})
      EXPECT_THROW(solve_force_history(material, radius, forces, coarse()), InputError);
  }
} // namespace
