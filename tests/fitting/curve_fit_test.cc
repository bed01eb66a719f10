#include "fitting/conventions.h"
#include "fitting/curve_fit.h"
#include "meshing/errors.h"
#include "tests/support/curves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>

using namespace dpcontact;
using namespace dpcontact::test_curves;

namespace
{
  /// A smooth softening curve that no power law fits, like a strongly plastic contact: elastic at
  /// first, δ_max = 60 δ_y, δ_res = 25 δ_y.
  double loading_law(const double x) { return std::pow(x, 1.5) * std::pow(1 + x / 4, -0.12); }

  double unloading_law(const double x)
  {
    constexpr double range = 35;
    const double     s     = x / range;
    return loading_law(60) * std::pow(s, 1.5) * std::pow((1 + 3.) / (1 + 3 * s), 0.25);
  }

  Curve softening_curve(const unsigned int n, const double grading)
  {
    return sample(loading_law, unloading_law, 60, 25, n, grading);
  }
} // namespace

// Hertz: F^(2/3) is linear in δ, so neither sampling nor interpolation leaves a trace.
TEST(CurveFit, HertzGivesOneAndThreeHalves)
{
  const PowerLaws laws;
  for (const double grading : {1., 1.6})
    {
      const CurveFit fit =
        fit_curve(laws.curve(25, grading), laws.force_yield, laws.approach_yield);
      EXPECT_TRUE(fit.converged());
      EXPECT_NEAR(fit.loading.fit.law.coefficient, 1, 1e-10);
      EXPECT_NEAR(fit.loading.fit.law.exponent, 1.5, 1e-10);
      EXPECT_NEAR(fit.unloading.fit.law.coefficient, 1, 1e-10);
      EXPECT_NEAR(fit.unloading.fit.law.exponent, 1.5, 1e-10);
      EXPECT_NEAR(fit.unloading_free.law.origin, 0, 1e-8);
      EXPECT_NEAR(fit.unloading_free.law.exponent, 1.5, 1e-8);
      EXPECT_TRUE(fit.unloading_free.report.converged);
      EXPECT_NEAR(fit.loading.coefficient_change, 0, 1e-10);
      EXPECT_NEAR(fit.unloading.exponent_change, 0, 1e-10);
      EXPECT_NEAR(fit.residual_approach_fitted, 0, 1e-10 * fit.approach_max);
      EXPECT_NEAR(fit.published.a, std::pow(2, -1.5), 1e-10);
      EXPECT_NEAR(fit.published.m, std::pow(2, -1.5), 1e-10);
      EXPECT_EQ(fit.published.approach_yield, laws.approach_yield / 2);
      EXPECT_EQ(fit.residual_approach, 0);
      EXPECT_TRUE(fit.loading.power_law_is_best());
      EXPECT_TRUE(fit.unloading.power_law_is_best());
    }
}

// Power laws with other exponents: F^(2/3) is curved, above all near zero force where its relative
// error is largest and its weight least. Measured at 160 uniform points: 2e-8 in a, 6e-7 in m, and
// 6e-6 in the free origin, which a few points near zero decide.
TEST(CurveFit, PlasticUnloadingWithKnownResidualApproach)
{
  const PowerLaws laws{25.5, 4.1e-6, 1.17, 1.4, 1.32, 63.7, 27.3};
  const CurveFit  fit = fit_curve(laws.curve(160), laws.force_yield, laws.approach_yield);
  EXPECT_TRUE(fit.converged());
  EXPECT_DOUBLE_EQ(fit.residual_approach, 27.3 * 4.1e-6);
  EXPECT_NEAR(fit.unloading.fit.law.origin, 27.3, 1e-12);
  EXPECT_NEAR(fit.loading.fit.law.coefficient, 1.17, 2e-7);
  EXPECT_NEAR(fit.loading.fit.law.exponent, 1.4, 1e-7);
  EXPECT_NEAR(fit.unloading.fit.law.coefficient, laws.m(), 5e-6);
  EXPECT_NEAR(fit.unloading.fit.law.exponent, 1.32, 1e-7);
  EXPECT_NEAR(fit.unloading_free.law.origin, 27.3, 5e-5);
  EXPECT_NEAR(fit.unloading_free.law.exponent, 1.32, 5e-6);
  // The law holds at the peak, so eq (18) gives the curve's own δ_res back.
  EXPECT_NEAR(fit.residual_approach_fitted, fit.residual_approach, 1e-7 * fit.approach_max);
  EXPECT_NEAR(fit.force_max,
              fit.force_yield * fit.unloading.fit.law(fit.approach_max / fit.approach_yield),
              1e-5 * fit.force_max);
}

// The same branches sampled by 20, 40 and 160 points, uniform and crowded towards zero, against the
// fit to the analytic values. Interpolation errors fall with the third power of the spacing or
// better; measured at most 1e-5, 7e-7 and 3e-9, printed below. Allowed: about three times that.
TEST(CurveFit, CoefficientsDoNotDependOnTheSampling)
{
  std::vector<double> up, down, load, unload;
  for (unsigned int i = 1; i <= 200; ++i)
    {
      up.push_back(60 * i / 200.);
      load.push_back(loading_law(up.back()));
      down.push_back(35 * i / 200.);
      unload.push_back(unloading_law(down.back()));
    }
  const PowerLaw loading = fit_power_law(up, load).law, unloading = fit_power_law(down, unload).law;
  const auto     error = [](const double value, const double exact) {
    return std::fabs(value / exact - 1);
  };
  const struct
  {
    unsigned int n;
    double       tolerance;
  } cases[] = {{20, 3e-5}, {40, 3e-6}, {160, 1e-8}};
  for (const auto &[n, tolerance] : cases)
    for (const double grading : {1., 1.6})
      {
        const CurveFit fit      = fit_curve(softening_curve(n, grading), 1, 1);
        const double   errors[] = {error(fit.loading.fit.law.coefficient, loading.coefficient),
                                   error(fit.loading.fit.law.exponent, loading.exponent),
                                   error(fit.unloading.fit.law.coefficient, unloading.coefficient),
                                   error(fit.unloading.fit.law.exponent, unloading.exponent)};
        std::cout << n << " points, grading " << grading << ": relative errors of a, b, m, n";
        for (const double e : errors)
          {
            std::cout << ' ' << e;
            EXPECT_LT(e, tolerance) << n << " points, grading " << grading;
          }
        std::cout << '\n';
      }
}

// Fitting with half of δ_y is the published convention: same points, other unit. 1e-8: the fits
// stop within 1e-9 of a standard error, and these are a few per cent of the coefficients at most.
TEST(CurveFit, PublishedConventionIsTheFitWithThePerSphereYieldApproach)
{
  const Curve    curve = softening_curve(40, 1.3);
  const CurveFit fit = fit_curve(curve, 1, 1), halved = fit_curve(curve, 1, 0.5);
  EXPECT_NEAR(fit.published.a, halved.loading.fit.law.coefficient, 1e-8);
  EXPECT_NEAR(fit.published.m, halved.unloading.fit.law.coefficient, 1e-8);
  EXPECT_NEAR(fit.published.a_standard_error, halved.loading.fit.standard_error.coefficient, 1e-8);
  EXPECT_NEAR(
    fit.published.m_standard_error, halved.unloading.fit.standard_error.coefficient, 1e-8);
  EXPECT_GT(fit.published.m_standard_error, 1e-5);
  EXPECT_EQ(fit.published.approach_yield, 0.5);
  EXPECT_NEAR(fit.loading.fit.law.exponent, halved.loading.fit.law.exponent, 1e-8);
}

// The refit uses x_20 … x_200: the same as fitting those points directly.
TEST(CurveFit, WindowRefitsUseTheUpperNineTenths)
{
  const Curve           curve  = softening_curve(40, 1);
  const CurveFit        fit    = fit_curve(curve, 1, 1);
  const ResampledBranch branch = resample(curve, Branch::unloading);
  const PowerLawFit     direct = fit_power_law({branch.x.begin() + 19, branch.x.end()},
                                           {branch.force.begin() + 19, branch.force.end()});
  EXPECT_EQ(fit.unloading.window.report.n_points, 181u);
  EXPECT_EQ(fit.unloading.fit.report.n_points, 200u);
  EXPECT_DOUBLE_EQ(fit.unloading.window.law.coefficient, direct.law.coefficient);
  EXPECT_DOUBLE_EQ(fit.unloading.window.law.exponent, direct.law.exponent);
  EXPECT_DOUBLE_EQ(fit.unloading.coefficient_change,
                   direct.law.coefficient / fit.unloading.fit.law.coefficient - 1);
  EXPECT_DOUBLE_EQ(fit.unloading.exponent_change,
                   direct.law.exponent / fit.unloading.fit.law.exponent - 1);
  EXPECT_GT(std::fabs(fit.unloading.exponent_change), 1e-5);
}

// A third parameter cannot fit worse than its fixed value does.
TEST(CurveFit, FreeResidualApproachFitsAtLeastAsWell)
{
  const CurveFit fit = fit_curve(softening_curve(60, 1), 1, 1);
  EXPECT_LT(fit.unloading_free.report.rmse, fit.unloading.fit.report.rmse);
  EXPECT_GT(fit.unloading_free.standard_error.origin, 0);
  EXPECT_EQ(fit.unloading_free.report.n_parameters, 3u);
  // The law of either fit takes δ/δ_y: it vanishes below its own origin.
  EXPECT_EQ(fit.unloading_free.law(fit.unloading_free.law.origin), 0);
  EXPECT_EQ(fit.unloading.fit.law(25), 0);
}

// δ_max = 10, δ_y = 2, F_max/F_y = 8, m = 1, n = 3: 10 − 2 · 8^(1/3) = 6. With m = 8: 10 − 2 = 8.
TEST(CurveFit, ResidualApproachOfEquation18)
{
  EXPECT_NEAR(residual_approach(10, 2, 40, 5, 1, 3), 6, 1e-14);
  EXPECT_NEAR(residual_approach(10, 2, 40, 5, 8, 3), 8, 1e-14);
}

// From nearly elastic to the far end of the contact law's range.
TEST(CurveFit, ConvergesOverTheRangeOfLoads)
{
  for (const double ratio : {0.15, 1., 60., 3000.}) // Λ = 0.05 … 7e4
    {
      const PowerLaws laws{2e-3, 1e-7, 1.2, 1.38, 1.25, ratio, 0.55 * ratio};
      const CurveFit  fit = fit_curve(laws.curve(60), laws.force_yield, laws.approach_yield);
      EXPECT_TRUE(fit.converged()) << describe(fit.unloading.fit.report.reason);
      EXPECT_TRUE(fit.unloading_free.report.converged);
      EXPECT_NEAR(fit.loading.fit.law.exponent, 1.38, 1e-4);
      EXPECT_NEAR(fit.unloading.fit.law.exponent, 1.25, 1e-4);
    }
}

TEST(CurveFit, NotConvergingIsReportedAndNotThrown)
{
  FitOptions options;
  options.least_squares.max_iterations = 1;
  const CurveFit fit                   = fit_curve(softening_curve(40, 1), 1, 1, options);
  EXPECT_FALSE(fit.converged());
  EXPECT_EQ(fit.loading.fit.report.reason, StopReason::iteration_limit);
}

TEST(CurveFit, BadInputIsRefused)
{
  const Curve curve = softening_curve(40, 1);
  for (const double bad :
       {0., -1., std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    {
      EXPECT_THROW(fit_curve(curve, bad, 1), InputError);
      EXPECT_THROW(fit_curve(curve, 1, bad), InputError);
    }
  EXPECT_THROW(fit_curve(Curve(), 1, 1), InputError);
  FitOptions options;
  options.n_points = 5;
  EXPECT_THROW(fit_curve(curve, 1, 1, options), InputError);
  options              = {};
  options.window_start = 1;
  EXPECT_THROW(fit_curve(curve, 1, 1, options), InputError);
}

TEST(Conventions, ThePublishedLawGivesTheSameForce)
{
  const double c = 1.3, p = 1.4, approach = 7, approach_yield = 2;
  EXPECT_NEAR(published_coefficient(c, p) *
                std::pow(approach / published_approach_yield(approach_yield), p),
              c * std::pow(approach / approach_yield, p),
              1e-14);
  EXPECT_NEAR(consistent_coefficient(published_coefficient(c, p), p), c, 1e-15);
}

TEST(Conventions, UncertaintiesAreThoseOfTheDerivatives)
{
  const double c = 1.3, p = 1.4, dc = 0.02, dp = 0.01, step = 1e-6;
  const double published      = published_coefficient(c, p);
  const double by_coefficient = (published_coefficient(c + step, p) - published) / step;
  const double by_exponent    = (published_coefficient(c, p + step) - published) / step;
  EXPECT_NEAR(converted_uncertainty(published, dc / c, dp),
              std::hypot(by_coefficient * dc, by_exponent * dp),
              1e-7);
  EXPECT_NEAR(published_standard_error(c, p, dc * dc, 0, dp * dp),
              converted_uncertainty(published, dc / c, dp),
              1e-15);
  // Errors that are fully correlated add up with the signs of their effects.
  EXPECT_NEAR(published_standard_error(c, p, dc * dc, dc * dp, dp * dp),
              std::abs(by_coefficient * dc + by_exponent * dp),
              1e-7);
}
