#include "meshing/errors.h"
#include "solver/path/step_extrapolation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace dpcontact;

  constexpr double peak_force = 100., error_scale = 0.05;

  double exact_approach(const double force) { return std::pow(force / peak_force, 2. / 3) + 0.2; }
  double exact_energy(const double force) { return 0.3 * force / peak_force; }

  CurvePoint point(const double force, const double approach_error, const double energy_error)
  {
    CurvePoint p;
    p.force             = force;
    p.approach          = exact_approach(force) + approach_error;
    p.dissipated_energy = exact_energy(force) + energy_error;
    p.contact_radius    = 1e-3 * force;
    return p;
  }

  /// Both branches on n equal steps of the force; their errors are h · (smooth) with h = 1/n, and
  /// linear in the level, so that interpolating them between common levels is exact too.
  Curve with_steps(const unsigned int n, const double error_per_step)
  {
    Curve curve;
    for (unsigned int i = 0; i <= n; ++i)
      {
        const double t = static_cast<double>(i) / n;
        curve.loading.push_back(
          point(peak_force * t, error_per_step * t / n, -2 * error_per_step * t / n));
      }
    for (unsigned int i = 0; i <= n; ++i)
      {
        const double t = 1 - static_cast<double>(i) / n;
        curve.unloading.push_back(
          point(peak_force * t, error_per_step * (0.5 + 0.5 * t) / n, -2 * error_per_step / n));
      }
    return curve;
  }

  TEST(StepExtrapolation, is_exact_where_the_error_is_linear_in_the_step)
  {
    const auto coarse = with_steps(8, error_scale), fine = with_steps(16, error_scale);
    const auto result = extrapolate_steps(coarse, fine, 1);
    ASSERT_EQ(result.loading.size(), fine.loading.size());
    ASSERT_EQ(result.unloading.size(), fine.unloading.size());
    for (const auto *branch : {&result.loading, &result.unloading})
      for (const auto &p : *branch)
        {
          EXPECT_NEAR(p.approach, exact_approach(p.force), 1e-14);
          EXPECT_NEAR(p.dissipated_energy, exact_energy(p.force), 1e-14);
        }
    // What is not extrapolated is the fine path's.
    for (std::size_t i = 0; i < fine.loading.size(); ++i)
      {
        EXPECT_EQ(result.loading[i].force, fine.loading[i].force);
        EXPECT_EQ(result.loading[i].contact_radius, fine.loading[i].contact_radius);
      }
  }

  TEST(StepExtrapolation, leaves_an_error_of_second_order_in_the_step)
  {
    // Errors t (h + h²): extrapolation leaves −h_fine² · 2 t of them.
    const auto curve = [](const unsigned int n) {
      const double h = 1. / n;
      return with_steps(n, 0.05 * (1 + h));
    };
    const auto error = [&](const unsigned int n) {
      const auto result = extrapolate_steps(curve(n), curve(2 * n), 1);
      return std::abs(result.loading.back().approach - exact_approach(peak_force));
    };
    EXPECT_GT(error(8), 1e-5) << "there must be something to measure";
    EXPECT_NEAR(error(8) / error(16), 4, 1e-6);
  }

  TEST(StepExtrapolation, the_difference_is_the_force_at_equal_approach)
  {
    // Straight branches F = S δ and an approach that differs by Δ at the peak: S Δ / F_max there.
    const auto straight = [](const unsigned int n, const double offset) {
      Curve curve;
      for (unsigned int i = 0; i <= n; ++i)
        {
          CurvePoint p;
          p.force             = peak_force * i / n;
          p.approach          = p.force * (1 + offset) / 50;
          p.dissipated_energy = 0;
          curve.loading.push_back(p);
        }
      curve.unloading.assign(curve.loading.rbegin(), curve.loading.rend());
      return curve;
    };
    EXPECT_NEAR(step_difference(straight(4, 0.01), straight(8, 0.)), 0.01, 1e-14);
    EXPECT_EQ(step_difference(straight(4, 0.), straight(8, 0.)), 0.);
  }

  TEST(StepExtrapolation, rejects_paths_that_do_not_share_their_levels)
  {
    const auto fine = with_steps(16, error_scale);
    EXPECT_THROW(extrapolate_steps(with_steps(7, error_scale), fine), SolverError);
    EXPECT_THROW(step_difference(with_steps(7, error_scale), fine), SolverError);

    // As many points, but one level off by 1e-4 of the peak, on either branch.
    auto shifted = with_steps(8, error_scale);
    shifted.loading[3].force += 1e-4 * peak_force;
    EXPECT_THROW(extrapolate_steps(shifted, fine), SolverError);
    shifted = with_steps(8, error_scale);
    shifted.unloading[3].force += 1e-4 * peak_force;
    EXPECT_THROW(extrapolate_steps(shifted, fine), SolverError);
    EXPECT_THROW(step_difference(shifted, fine), SolverError);
  }

  TEST(StepExtrapolation, rejects_a_result_that_is_not_monotone)
  {
    // A coarse path whose approach is off by more than a step at one level only.
    const auto fine   = with_steps(16, error_scale);
    auto       coarse = with_steps(8, error_scale);
    coarse.loading[4].approach -= 0.3;
    EXPECT_THROW(extrapolate_steps(coarse, fine), SolverError);
  }

  /// Loading whose approach is off by the share `error`/n everywhere and by ±`jump` in turn
  /// besides, from the lower half of the branch's points on; released along the same points.
  Curve jumping(const unsigned int n, const double error, const double jump)
  {
    Curve curve;
    for (unsigned int i = 0; i <= n; ++i)
      {
        const double t = static_cast<double>(i) / n;
        CurvePoint   p = point(peak_force * t * t * t, 0, 0);
        p.approach *= 1 + error / n + (2 * i > n && i < n ? (i % 2 == 0 ? jump : -jump) : 0);
        curve.loading.push_back(p);
      }
    curve.unloading = with_steps(n, 0).unloading;
    for (CurvePoint &p : curve.unloading)
      p.approach += curve.loading.back().approach - exact_approach(peak_force);
    return curve;
  }

  TEST(StepExtrapolation, smooth_is_exact_where_the_error_is_a_share_of_the_approach)
  {
    const auto coarse = jumping(32, error_scale, 0), fine = jumping(64, error_scale, 0);
    const auto result = extrapolate_steps_smoothly(coarse, fine, 1);
    for (std::size_t i = 1; i < result.loading.size(); ++i)
      EXPECT_NEAR(result.loading[i].approach / exact_approach(result.loading[i].force), 1, 1e-13);
    for (const CurvePoint &p : result.unloading)
      EXPECT_NEAR(p.approach, exact_approach(p.force), 1e-13);
    // Over the approach the difference of the two is half the coarse one's error.
    EXPECT_GT(smooth_step_difference(coarse, fine), 0.5 * error_scale / 64);
  }

  TEST(StepExtrapolation, smooth_passes_over_jumps_that_are_larger_than_a_step)
  {
    const double jump   = 0.05; // twice that is more than the last step of the coarse path adds
    const auto   coarse = jumping(32, error_scale, jump), fine = jumping(64, error_scale, 0);
    EXPECT_THROW(extrapolate_steps(coarse, fine, 1), StepsTooLarge);
    const auto result = extrapolate_steps_smoothly(coarse, fine, 1);
    for (std::size_t i = 1; i < result.loading.size(); ++i)
      EXPECT_NEAR(
        result.loading[i].approach / exact_approach(result.loading[i].force), 1, jump / 4);
    EXPECT_LT(smooth_step_difference(coarse, fine), step_difference(coarse, fine) / 2);
  }
} // namespace
