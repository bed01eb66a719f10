#include "database/rows/uncertainty.h"
#include "tests/support/floating_point_traps.h"
#include "tests/support/rocks.h"
#include "tests/support/solver_environment.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <string>

namespace
{
  using namespace dpcontact;
  using tests::Solved;

  const auto *const traps  = tests::FloatingPointTraps::install();
  const auto *const solver = tests::SolverEnvironment::install();

  using Change = std::function<void(SolverOptions &)>;

  /// Coefficients with all savings against those with each switched off.
  void expect_within_stated_errors(const Material                      &material,
                                   const std::map<std::string, Change> &savings)
  {
    const Scene  scene;
    const Solved all(material, scene);
    const auto   stated = estimate_errors(all.fit, all.solution, material, scene);
    const auto   values = coefficients(all.fit);
    for (const auto &[name, switch_off] : savings)
      {
        SolverOptions options;
        switch_off(options);
        const Solved without(material, scene, options);
        const auto stated_without = estimate_errors(without.fit, without.solution, material, scene);
        const auto values_without = coefficients(without.fit);
        for (unsigned int c = 0; c < 4; ++c)
          EXPECT_NEAR(
            values_without[c], values[c], stated[c].numerical() + stated_without[c].numerical())
            << name << ", coefficient "
            << "abmn"[c];
      }
  }

  TEST(Savings, drucker_prager_lambda_49_each_switched_off_stays_within_the_stated_errors)
  {
    expect_within_stated_errors(
      tests::rock(10, .1, 20, 10),
      {{"condensation", [](SolverOptions &o) { o.condensation = false; }},
       {"predictor", [](SolverOptions &o) { o.predictor = false; }},
       {"extrapolation",
        [](SolverOptions &o) {
          o.extrapolation  = false;
          o.step_tolerance = 5e-3;
        }},
       {"surface halvings", [](SolverOptions &o) { o.surface_halvings = 1; }}});
  }

  TEST(Savings, elastic_scene_without_the_closed_form_stays_within_the_stated_errors)
  {
    expect_within_stated_errors(tests::rock(10, .25, 35, 50),
                                {{"closed form", [](SolverOptions &o) { o.closed_form = false; }}});
  }
} // namespace
