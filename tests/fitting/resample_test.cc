#include "fitting/resample.h"
#include "meshing/errors.h"
#include "tests/support/curves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

using namespace dpcontact;
using namespace dpcontact::test_curves;

namespace
{
  std::string message_of(const Curve &curve, const Branch branch)
  {
    try
      {
        resample(curve, branch);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "no error";
  }

  bool contains(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }

  Curve good_curve() { return PowerLaws{9., 3e-6, 1.1, 1.45, 1.4, 8, 2}.curve(20); }
} // namespace

// F^(2/3) of an elastic contact is linear in δ, and a monotone cubic reproduces a line: rounding
// only.
TEST(Resample, HertzIsExactOnAnySampling)
{
  const PowerLaws laws;
  for (const double grading : {1., 1.7})
    {
      const ResampledBranch branch = resample(laws.curve(7, grading), Branch::loading);
      ASSERT_EQ(branch.x.size(), 200u);
      EXPECT_EQ(branch.origin, 0);
      for (unsigned int i = 1; i <= 200; ++i)
        {
          const double x = i * 5 * laws.approach_yield / 200;
          EXPECT_NEAR(branch.x[i - 1], x, 1e-14 * x);
          const double force = laws.force_yield * std::pow(x / laws.approach_yield, 1.5);
          EXPECT_NEAR(branch.force[i - 1], force, 1e-13 * laws.force_yield * std::pow(5, 1.5));
        }
    }
}

TEST(Resample, UnloadingStartsAtTheResidualApproach)
{
  const Curve           curve  = good_curve();
  const ResampledBranch branch = resample(curve, Branch::unloading, 50);
  EXPECT_EQ(branch.x.size(), 50u);
  EXPECT_EQ(branch.origin, curve.residual_approach());
  EXPECT_DOUBLE_EQ(branch.x.back(), curve.loading.back().approach - curve.residual_approach());
  EXPECT_EQ(branch.force.back(), curve.loading.back().force);
}

TEST(Resample, PassesThroughItsPointsAndStaysMonotone)
{
  // A kinked branch, over which an unlimited cubic would overshoot.
  Curve curve   = good_curve();
  curve.loading = {
    point(0, 0), point(1, 1), point(2, 1.001), point(3, 1.002), point(4, 8), point(5, 8.001)};
  const BranchInterpolant interpolant(curve, Branch::loading);
  for (const CurvePoint &p : curve.loading)
    EXPECT_NEAR(interpolant.force_at(p.approach), p.force, 1e-12);
  double previous = 0;
  for (unsigned int i = 1; i <= 1000; ++i)
    {
      const double force = interpolant.force_at(i * 0.005);
      EXPECT_GE(force, previous);
      previous = force;
    }
}

TEST(Resample, ApproachAtForceInvertsForceAtApproach)
{
  const BranchInterpolant interpolant(good_curve(), Branch::unloading);
  EXPECT_EQ(interpolant.x_at(0), 0);
  EXPECT_EQ(interpolant.x_at(interpolant.force_max()), interpolant.x_max());
  for (const double part : {1e-3, 0.1, 0.5, 0.99})
    {
      const double force = part * interpolant.force_max();
      // 1e-15 of x_max, magnified by dF/dx · x_max/F_max ≈ n.
      EXPECT_NEAR(
        interpolant.force_at(interpolant.x_at(force)), force, 1e-13 * interpolant.force_max());
    }
  EXPECT_THROW(interpolant.x_at(1.01 * interpolant.force_max()), InputError);
  EXPECT_THROW(interpolant.force_at(-1e-9), InputError);
  EXPECT_THROW(interpolant.force_at(std::numeric_limits<double>::quiet_NaN()), InputError);
}

TEST(Resample, BadCurvesAreNamed)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Curve        curve;
  EXPECT_TRUE(contains(message_of(curve, Branch::loading), "0 points are too few"));

  curve = good_curve();
  curve.loading.resize(4);
  EXPECT_TRUE(contains(message_of(curve, Branch::loading), "loading branch: 4 points"));

  curve                  = good_curve();
  curve.loading[3].force = nan;
  EXPECT_TRUE(contains(message_of(curve, Branch::loading), "point 3"));
  EXPECT_TRUE(contains(message_of(curve, Branch::loading), "not finite"));

  curve                  = good_curve();
  curve.loading[5].force = curve.loading[4].force;
  EXPECT_TRUE(contains(message_of(curve, Branch::loading), "increase from point 4"));

  curve                     = good_curve();
  curve.loading[5].approach = curve.loading[7].approach;
  EXPECT_TRUE(contains(message_of(curve, Branch::loading), "increase from point 5"));

  curve                       = good_curve();
  curve.unloading[5].approach = curve.unloading[4].approach * 1.01;
  EXPECT_TRUE(contains(message_of(curve, Branch::unloading), "decrease from point 4"));

  curve = good_curve();
  curve.loading.erase(curve.loading.begin());
  EXPECT_TRUE(contains(message_of(curve, Branch::loading), "must begin at (0, 0)"));

  curve = good_curve();
  curve.unloading.pop_back();
  EXPECT_TRUE(contains(message_of(curve, Branch::unloading), "must end at separation"));

  curve = good_curve();
  curve.unloading.erase(curve.unloading.begin());
  EXPECT_TRUE(contains(message_of(curve, Branch::unloading), "not the end of loading"));

  curve = good_curve();
  curve.unloading.back().approach *= -1;
  EXPECT_TRUE(contains(message_of(curve, Branch::unloading), "residual approach is negative"));

  EXPECT_THROW(resample(good_curve(), Branch::loading, 3), InputError);
}
