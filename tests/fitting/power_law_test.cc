#include "fitting/power_law.h"
#include "fitting/resample.h"
#include "meshing/errors.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <limits>
#include <vector>

using namespace dpcontact;

namespace
{
  std::vector<double> uniform(const double x_max, const unsigned int n = 200)
  {
    std::vector<double> x;
    for (unsigned int i = 1; i <= n; ++i)
      x.push_back(i * x_max / n);
    return x;
  }

  std::vector<double> values(const PowerLaw &law, const std::vector<double> &x)
  {
    std::vector<double> y;
    for (const double v : x)
      y.push_back(law(v));
    return y;
  }

  /// Something that no power law fits: 1 % of a wave on top of one.
  std::vector<double> wavy(const std::vector<double> &x)
  {
    std::vector<double> y;
    for (const double v : x)
      y.push_back(1.3 * std::pow(v, 1.4) +
                  0.01 * std::pow(x.back(), 1.4) * std::sin(7 * v / x.back()));
    return y;
  }
} // namespace

// Exact data from nearly elastic to Λ = 1e5, in any unit. 1e-10: the coefficient carries ln(x_max)
// times the exponent's rounding.
TEST(PowerLawFit, RecoversExactData)
{
  for (const double x_max : {0.1, 5., 300., 1e4})
    for (const double exponent : {1.2, 1.5, 1.7})
      for (const double coefficient : {1e-6, 0.35, 8., 1e9})
        {
          const PowerLaw            law{coefficient, exponent, 0};
          const std::vector<double> x   = uniform(x_max);
          const PowerLawFit         fit = fit_power_law(x, values(law, x));
          EXPECT_TRUE(fit.report.converged) << describe(fit.report.reason);
          EXPECT_NEAR(fit.law.coefficient, coefficient, 1e-10 * coefficient);
          EXPECT_NEAR(fit.law.exponent, exponent, 1e-10);
          EXPECT_NEAR(fit.report.r_squared, 1, 1e-14);
          EXPECT_LT(fit.report.rmse, 1e-13);
          EXPECT_EQ(fit.report.rank, 2u);
          EXPECT_EQ(fit.report.n_points, 200u);
          EXPECT_EQ(fit.law.origin, 0);
          EXPECT_EQ(fit.standard_error.origin, 0);
        }
}

// The origin is sought from a start that is 3 % of the range off, on either side.
TEST(PowerLawFit, RecoversTheOriginToo)
{
  for (const double shift : {-0.03, 0.03})
    {
      const PowerLaw      law{3.4, 1.32, 27.3};
      std::vector<double> x;
      for (const double v : uniform(36.4))
        x.push_back(27.3 + 36.4 * shift + v);
      const PowerLawFit fit = fit_power_law(x, values(law, x), 27.3 + 36.4 * shift, Origin::free);
      EXPECT_TRUE(fit.report.converged) << describe(fit.report.reason);
      EXPECT_EQ(fit.report.n_parameters, 3u);
      EXPECT_EQ(fit.report.rank, 3u);
      EXPECT_NEAR(fit.law.origin, 27.3, 1e-9);
      EXPECT_NEAR(fit.law.coefficient, 3.4, 1e-9);
      EXPECT_NEAR(fit.law.exponent, 1.32, 1e-9);
    }
}

// Covariance in the units of the data times the normal matrix JᵀJ, summed up here from the unscaled
// derivatives, is s² times the identity. Element (i, j) of the product has the size √(N_jj/N_ii)
// s²; 1e-6: the condition of the unscaled problem times rounding, and parameters within 1e-9 of an
// error.
TEST(PowerLawFit, CovarianceInvertsTheNormalMatrix)
{
  for (const double x_max : {2., 300.})
    for (const Origin policy : {Origin::fixed, Origin::free})
      {
        const std::size_t         p = policy == Origin::free ? 3 : 2;
        const std::vector<double> x = uniform(x_max), y = wavy(x);
        const PowerLawFit         fit = fit_power_law(x, y, 0, policy);
        ASSERT_TRUE(fit.report.converged) << describe(fit.report.reason);
        double N[3][3] = {}, gradient[3] = {}, sse = 0;
        for (std::size_t k = 0; k < x.size(); ++k)
          {
            const double s = x[k] - fit.law.origin, power = std::pow(s, fit.law.exponent);
            ASSERT_GT(s, 0);
            const double J[3] = {power,
                                 fit.law.coefficient * power * std::log(s),
                                 -fit.law.coefficient * fit.law.exponent * power / s};
            const double r    = fit.law.coefficient * power - y[k];
            sse += r * r;
            for (std::size_t i = 0; i < p; ++i)
              {
                gradient[i] += J[i] * r;
                for (std::size_t j = 0; j < p; ++j)
                  N[i][j] += J[i] * J[j];
              }
          }
        const double s2 = sse / static_cast<double>(x.size() - p);
        for (std::size_t i = 0; i < p; ++i)
          {
            // A stationary point: the residual is orthogonal to every derivative.
            EXPECT_LT(std::fabs(gradient[i]), 1e-8 * std::sqrt(N[i][i] * sse));
            for (std::size_t j = 0; j < p; ++j)
              {
                double product = 0;
                for (std::size_t k = 0; k < p; ++k)
                  product += fit.covariance[i][k] * N[k][j];
                EXPECT_NEAR(product / s2, i == j, 1e-6 * std::sqrt(N[j][j] / N[i][i]))
                  << i << ' ' << j << ", x_max " << x_max;
              }
          }
        EXPECT_DOUBLE_EQ(fit.standard_error.coefficient, std::sqrt(fit.covariance[0][0]));
        EXPECT_DOUBLE_EQ(fit.standard_error.exponent, std::sqrt(fit.covariance[1][1]));
        EXPECT_DOUBLE_EQ(fit.standard_error.origin, std::sqrt(fit.covariance[2][2]));
      }
}

// The fit's predictions do not depend on the units: 1e-9 of a standard error, far below 1e-8.
TEST(PowerLawFit, UnitsOfTheDataDoNotMatter)
{
  const std::vector<double> x = uniform(2), y = wavy(x);
  std::vector<double>       x_scaled = x, y_scaled = y;
  for (double &v : x_scaled)
    v *= 1e-6;
  for (double &v : y_scaled)
    v *= 1e5;
  const PowerLawFit fit = fit_power_law(x, y), scaled = fit_power_law(x_scaled, y_scaled);
  EXPECT_NEAR(scaled.law.exponent, fit.law.exponent, 1e-8);
  EXPECT_NEAR(scaled.law(1e-6), 1e5 * fit.law(1), 1e-8 * 1e5 * fit.law(1));
  EXPECT_NEAR(scaled.standard_error.exponent, fit.standard_error.exponent, 1e-8);
  EXPECT_NEAR(scaled.report.rmse, fit.report.rmse, 1e-12);
}

// y = (1, 2, 6), f = (1, 3, 5): SSE = 2, ȳ = 3, SST = 14, R² = 1 − 2/14, RMSE = √(2/3)/6.
TEST(FitReport, QualityByHand)
{
  const FitReport report = fit_report({}, {1, 2, 6}, {1, 3, 5});
  EXPECT_DOUBLE_EQ(report.r_squared, 6. / 7);
  EXPECT_DOUBLE_EQ(report.rmse, std::sqrt(2. / 3) / 6);
  EXPECT_EQ(report.n_points, 3u);
}

TEST(PowerLawFit, BadPointsAreRefused)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(fit_power_law({1, 2}, {1, 2}), InputError);
  EXPECT_THROW(fit_power_law({1, 2, 3}, {1, 2}), InputError);
  EXPECT_THROW(fit_power_law({1, 2, 3}, {1, nan, 3}), InputError);
  EXPECT_THROW(fit_power_law({1, 1, 3}, {1, 2, 3}), InputError);
  EXPECT_THROW(fit_power_law({0, 1, 3}, {1, 2, 3}), InputError);
  EXPECT_THROW(fit_power_law({1, 2, 3}, {0, 0, 0}), InputError);
  EXPECT_THROW(fit_power_law({1, 2, 3}, {1, 2, 3}, 0, Origin::free), InputError);
}

// x − x²: 1/4 at 1/2, and 2 at the end of [0, 2]. Twice the law differs most at the end.
TEST(LawDifference, ClosedForms)
{
  const PowerLaw line{1, 1, 0}, square{1, 2, 0};
  EXPECT_NEAR(law_difference(line, square, 1, 1), 0.25, 1e-15);
  EXPECT_NEAR(law_difference(square, line, 1, 0.5), 0.5, 1e-15);
  EXPECT_NEAR(law_difference(line, square, 2, 1), 2, 1e-15);
  EXPECT_EQ(law_difference(square, square, 3, 1), 0);
  EXPECT_NEAR(law_difference(square, {2, 2, 0}, 3, 9), 1, 1e-15);
  EXPECT_THROW(law_difference(line, square, 0, 1), InputError);
}

// (x)₊² against (x − 1)₊: x² on [0, 1], and x² − x + 1 beyond. And two parallel lines.
TEST(LawDifference, DifferentOrigins)
{
  EXPECT_NEAR(law_difference({1, 2, 0}, {1, 1, 1}, 2, 1), 3, 1e-12);
  EXPECT_NEAR(law_difference({1, 1, 0}, {1, 1, 0.25}, 3, 1), 0.25, 1e-12);
  // x − 2(x − 1/3)₊ on [0, 1] peaks in a kink at x = 1/3; the samples are refined to 1e-9.
  EXPECT_NEAR(law_difference({1, 1, 0}, {2, 1, 1. / 3}, 1, 1), 1. / 3, 1e-8);
}

// A branch that is a power law from an origin of its own is found as such, in any unit, where that
// origin costs nothing.
TEST(FitThroughPeak, RecoversExactData)
{
  for (const double x_max : {1e-6, 0.1, 300.})
    for (const double exponent : {1.2, 1.5})
      for (const double origin : {-0.1, 0., 0.1})
        {
          const std::vector<double> x = uniform(x_max);
          const PowerLaw            exact{3e4, exponent, origin * x_max};
          const PowerLaw            law = fit_through_peak(x, values(exact, x), 1e9 * x_max);
          EXPECT_NEAR(law.origin / x_max, origin, 1e-8);
          EXPECT_NEAR(law.exponent, exponent, 1e-7);
          EXPECT_NEAR(law.coefficient / 3e4, 1, 1e-5); // x_max to the power of 1e-7 and more
        }
}

// Where none fits, the law goes through the peak, and no other origin or exponent makes the sum
// that is asked for smaller.
TEST(FitThroughPeak, IsTheLeastSumOfForceAndOrigin)
{
  const std::vector<double> x    = uniform(2.);
  const std::vector<double> y    = wavy(x);
  const double              peak = 5;
  const PowerLaw            law  = fit_through_peak(x, y, peak);
  EXPECT_NEAR(law(x.back()), y.back(), 1e-12 * y.back());
  const auto sum = [&](const double origin, const double exponent) {
    double square = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
      {
        const double s = (x[i] - origin) / (x.back() - origin);
        square += std::pow((s > 0 ? std::pow(s, exponent) : 0) - y[i] / y.back(), 2);
      }
    return square / static_cast<double>(x.size()) + std::pow(origin_weight * origin / peak, 2);
  };
  EXPECT_GT(std::abs(law.origin), 1e-4); // it makes use of its freedom
  const double least = sum(law.origin, law.exponent);
  for (const double by_origin : {-1e-3, 0., 1e-3})
    for (const double by_exponent : {-1e-3, 0., 1e-3})
      if (by_origin != 0 || by_exponent != 0)
        {
          EXPECT_GT(sum(law.origin + by_origin, law.exponent + by_exponent), least)
            << by_origin << ' ' << by_exponent;
        }
  // Without freedom for the origin the force is further off.
  const PowerLaw held = fit_power_law(x, y).law;
  EXPECT_LT(
    least, sum(x.back() - std::pow(y.back() / held.coefficient, 1 / held.exponent), held.exponent));
}

TEST(FitThroughPeak, RefusesABranchLongerThanItsApproach)
{
  const std::vector<double> x = uniform(2.);
  EXPECT_THROW(fit_through_peak(x, wavy(x), 1.9), InputError);
  EXPECT_THROW(fit_through_peak(x, wavy(x), std::numeric_limits<double>::infinity()), InputError);
}

// What the weight of the origin does on unloading curves by finite elements: force in shares of the
// peak force, root mean square over a curve, and origin in shares of the peak approach.
TEST(FitThroughPeak, BalancesForceAndOriginOnComputedCurves)
{
  std::ifstream        stream(DPCONTACT_COMPUTED_CURVES);
  const nlohmann::json document = nlohmann::json::parse(stream);
  struct Errors
  {
    double force = 0, largest_force = 0, origin = 0, largest_origin = 0;
    int    count = 0;

    void add(const PowerLaw            &law,
             const std::vector<double> &x,
             const std::vector<double> &y,
             const double               peak_approach)
    {
      double square = 0;
      for (std::size_t i = 0; i < x.size(); ++i)
        square += std::pow((law(x[i]) - y[i]) / y.back(), 2) / static_cast<double>(x.size());
      const double moved = std::abs(law.origin) / peak_approach;
      force += square;
      origin += moved * moved;
      largest_force  = std::max(largest_force, std::sqrt(square));
      largest_origin = std::max(largest_origin, moved);
      ++count;
    }
    double force_rms() const { return std::sqrt(force / count); }
    double origin_rms() const { return std::sqrt(origin / count); }
  };
  Errors chosen, force_alone, heavier, held;
  for (const nlohmann::json &row : document.at("box"))
    {
      Curve      curve;
      const auto read = [&](const char *name, std::vector<CurvePoint> &branch) {
        for (const nlohmann::json &values : row.at(name))
          {
            branch.emplace_back();
            branch.back().approach = values.at(0);
            branch.back().force    = values.at(1);
          }
      };
      read("loading", curve.loading);
      read("unloading", curve.unloading);
      const ResampledBranch branch = resample(curve, Branch::unloading);
      const auto           &x = branch.x, &y = branch.force;
      const double          peak = curve.loading.back().approach;
      chosen.add(fit_through_peak(x, y, peak), x, y, peak);
      force_alone.add(fit_through_peak(x, y, peak, 0), x, y, peak);
      heavier.add(fit_through_peak(x, y, peak, 1), x, y, peak);
      // The law with the curve's own origin, moved to the peak afterwards as eq (18) does.
      PowerLaw own = fit_power_law(x, y).law;
      own.origin   = x.back() - std::pow(y.back() / own.coefficient, 1 / own.exponent);
      held.add(own, x, y, peak);
    }
  // As fitting/power_law.h states them, and a twentieth for another machine's rounding and library.
  EXPECT_NEAR(chosen.force_rms(), 0.0017, 0.0001);
  EXPECT_NEAR(chosen.largest_force, 0.0040, 0.0002);
  EXPECT_NEAR(chosen.origin_rms(), 0.0017, 0.0001);
  EXPECT_NEAR(chosen.largest_origin, 0.0051, 0.0003);
  EXPECT_NEAR(force_alone.force_rms(), 0.0013, 0.0001);
  EXPECT_NEAR(force_alone.origin_rms(), 0.0058, 0.0003);
  EXPECT_NEAR(heavier.force_rms(), 0.0020, 0.0001);
  EXPECT_NEAR(heavier.origin_rms(), 0.0008, 0.0001);
  EXPECT_NEAR(held.force_rms(), 0.0036, 0.0002);
  EXPECT_NEAR(held.largest_force, 0.0097, 0.0005);
  EXPECT_NEAR(held.origin_rms(), 0.0013, 0.0001);
}
