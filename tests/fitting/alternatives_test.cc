#include "fitting/alternatives.h"
#include "meshing/errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace dpcontact;

namespace
{
  std::vector<double> uniform(const double x_max)
  {
    std::vector<double> x;
    for (unsigned int i = 1; i <= 200; ++i)
      x.push_back(i * x_max / 200);
    return x;
  }

  template <typename Law>
  std::vector<double> values(const Law &law, const std::vector<double> &x)
  {
    std::vector<double> y;
    for (const double v : x)
      y.push_back(law(v));
    return y;
  }
} // namespace

// Each form finds its own exact data again, at δ_max/δ_y of 3 and 300. Tolerances are relative to
// what a coefficient contributes at x_max; 1e-10 is rounding times the condition of a cubic.
TEST(Alternatives, EachFormRecoversItself)
{
  for (const double x_max : {3., 300.})
    {
      const std::vector<double> x = uniform(x_max);
      const auto check = [&](const Form form, const std::vector<double> &c, const auto &weights) {
        AlternativeFit truth;
        truth.form               = form;
        truth.coefficients       = c;
        const AlternativeFit fit = fit_alternative(form, x, values(truth, x));
        EXPECT_TRUE(fit.report.converged) << to_string(form);
        EXPECT_EQ(fit.report.n_parameters, c.size());
        EXPECT_NEAR(fit.report.r_squared, 1, 1e-14) << to_string(form);
        ASSERT_EQ(fit.coefficients.size(), c.size());
        for (std::size_t j = 0; j < c.size(); ++j)
          EXPECT_NEAR(fit.coefficients[j] * weights[j], c[j] * weights[j], 1e-10 * truth(x_max))
            << to_string(form) << ' ' << j;
      };
      const double s = x_max;
      check(Form::exponential, {0.4, 2.5 / s}, std::vector<double>{1, s});
      check(Form::quadratic, {-0.5, 0.3, 2 / s}, std::vector<double>{1, s, s * s});
      check(Form::cubic,
            {0.2, 1.1, 1 / s, -0.2 / (s * s)},
            std::vector<double>{1, s, s * s, s * s * s});
      check(Form::parabola, {1.7}, std::vector<double>{s * s});
    }
}

// y = c x²: c = Σyx²/Σx⁴, standard error √(SSE/(n − 1)/Σx⁴). x = 1, 2, 3, y = 1, 5, 8:
// c = 93/98, SSE = 90 − 93²/98. 1e-9: where the search stops, in standard errors.
TEST(Alternatives, ParabolaByHand)
{
  const AlternativeFit fit = fit_alternative(Form::parabola, {1, 2, 3}, {1, 5, 8});
  const double         sse = 90 - 93. * 93 / 98;
  EXPECT_NEAR(fit.coefficients[0], 93. / 98, 1e-9);
  EXPECT_NEAR(fit.standard_errors[0], std::sqrt(sse / 2 / 98), 1e-9);
  EXPECT_NEAR(fit.report.rmse, std::sqrt(sse / 3) / 8, 1e-9);
  EXPECT_NEAR(fit.report.r_squared, 1 - sse / (90 - 14. * 14 / 3), 1e-9);
}

// On a Hertz curve: nested forms improve in order, and none is exact.
TEST(Alternatives, OrderOnHertz)
{
  const std::vector<double> x = uniform(5);
  const auto fits = fit_alternatives(x, values([](double v) { return std::pow(v, 1.5); }, x));
  ASSERT_EQ(fits.size(), 4u);
  const double exponential = fits[0].report.rmse, quadratic = fits[1].report.rmse,
               cubic = fits[2].report.rmse, parabola = fits[3].report.rmse;
  for (const AlternativeFit &fit : fits)
    EXPECT_TRUE(fit.report.converged) << to_string(fit.form) << ": " << describe(fit.report.reason);
  EXPECT_LT(cubic, quadratic);
  EXPECT_LT(quadratic, parabola);
  EXPECT_LT(quadratic, exponential);
  EXPECT_GT(cubic, 1e-5);
}

TEST(Alternatives, BadPointsAreRefused)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(fit_alternative(Form::cubic, {1, 2, 3, 4}, {1, 2, 3, 4}), InputError);
  EXPECT_THROW(fit_alternative(Form::parabola, {1, 2, 3}, {1, 2}), InputError);
  EXPECT_THROW(fit_alternative(Form::parabola, {1, 2, 3}, {1, nan, 3}), InputError);
  EXPECT_THROW(fit_alternative(Form::parabola, {1, 2, 3}, {1, 2, 0}), InputError);
}
