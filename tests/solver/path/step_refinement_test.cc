#include "solver/path/step_refinement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{
  using namespace dpcontact;
  using Refinement = StepRefinement<Curve>;

  /// A curve whose approach is F^⅔, and wrong by `error_per_step` over the number of steps.
  Curve with_steps(const unsigned int n, const double error_per_step)
  {
    Curve      curve;
    const auto point = [&](const double force) {
      CurvePoint p;
      p.force             = force;
      p.approach          = std::pow(force, 2. / 3) + force * error_per_step / n;
      p.dissipated_energy = 0;
      return p;
    };
    for (unsigned int i = 0; i <= n; ++i)
      curve.loading.push_back(point(static_cast<double>(i) / n));
    curve.unloading.assign(curve.loading.rbegin(), curve.loading.rend());
    return curve;
  }

  StepRule rule(const double tolerance)
  {
    StepRule result;
    result.first_steps = 8;
    result.last_steps  = 1024; // 512 of them leave 4e-5, as estimated
    result.tolerance   = tolerance;
    return result;
  }

  double true_error(const RefinedSteps<Curve> &refined)
  {
    return std::abs(refined.points.loading.back().approach - 1);
  }

  TEST(StepRefinement, halves_the_steps_until_the_tolerance_holds)
  {
    unsigned int before = 0;
    for (const double tolerance : {1e-2, 1e-3, 1e-4})
      {
        std::vector<unsigned int> runs;
        const auto refined = Refinement(curve_comparison(), rule(tolerance)).refine([&](auto n) {
          runs.push_back(n);
          return Refinement::Run{with_steps(n, 0.2)};
        });
        EXPECT_LE(refined.error, tolerance);
        EXPECT_LT(true_error(refined), refined.error) << "the estimate must not flatter";
        EXPECT_EQ(refined.steps, runs.back());
        EXPECT_GT(refined.steps, before) << "a smaller tolerance asks for more steps";
        for (std::size_t i = 1; i < runs.size(); ++i)
          EXPECT_EQ(runs[i], 2 * runs[i - 1]);
        before = refined.steps;
      }
  }

  TEST(StepRefinement, runs_that_had_to_cut_steps_meet_no_tolerance)
  {
    const auto refined =
      Refinement(curve_comparison(), rule(1e-2)).refine([](const unsigned int n) {
        return Refinement::Run{with_steps(n, 0.2), n <= 32};
      });
    EXPECT_EQ(refined.steps, 128u) << "64 and 128 are the first two without a cut";
  }

  TEST(StepRefinement, an_error_above_the_tolerance_at_the_last_steps_is_refused_or_accepted)
  {
    const auto run = [](const unsigned int n) { return Refinement::Run{with_steps(n, 0.2), true}; };
    StepRule   at_last = rule(1e-6);
    at_last.last_steps = 256;
    EXPECT_THROW(Refinement(curve_comparison(), at_last).refine(run), SolverError);
    at_last.at_last_steps = AtLastSteps::accept;
    const auto refined    = Refinement(curve_comparison(), at_last).refine(run);
    EXPECT_EQ(refined.steps, 256u);
    EXPECT_GT(refined.error, 1e-6);
  }

  TEST(StepRefinement, without_extrapolation_the_finest_run_is_the_result)
  {
    StepRule plain      = rule(1e-3);
    plain.extrapolation = false;
    const auto refined  = Refinement(curve_comparison(), plain).refine([](const unsigned int n) {
      return Refinement::Run{with_steps(n, 0.2)};
    });
    EXPECT_EQ(refined.points.loading.back().approach,
              with_steps(refined.steps, 0.2).loading.back().approach);
    EXPECT_LE(refined.error, 1e-3);
    EXPECT_EQ(refined.coarser_share, 1.);
  }

  TEST(StepRefinement, a_difference_that_jumps_is_extrapolated_by_its_smooth_part)
  {
    StepRule all      = rule(1e-3);
    all.tolerance     = {};
    all.at_last_steps = AtLastSteps::accept;
    all.last_steps    = 64;
    // The edge of the contact jumps in one point of the finest run, by more than a step.
    const auto refined = Refinement(curve_comparison(), all).refine([](const unsigned int n) {
      Curve curve = with_steps(n, 0.2);
      if (n == 64)
        curve.loading[40].approach +=
          0.9 * (curve.loading[41].approach - curve.loading[40].approach);
      return Refinement::Run{curve};
    });
    EXPECT_TRUE(refined.smooth);
    EXPECT_EQ(refined.steps, 64u);
  }
} // namespace
