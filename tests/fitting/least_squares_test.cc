#include "fitting/least_squares.h"
#include "meshing/errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

using namespace dpcontact;

namespace
{
  /// Straight line y = p₀ + p₁ x.
  LeastSquaresProblem line(const std::vector<double> &x, const std::vector<double> &y)
  {
    LeastSquaresProblem problem;
    problem.n_residuals = x.size();
    problem.start       = {0, 0};
    for (const double v : y)
      problem.observation_norm += v * v;
    problem.observation_norm = std::sqrt(problem.observation_norm);
    problem.evaluate         = [x, y](const auto &p, auto &r, auto *J) {
      for (std::size_t i = 0; i < x.size(); ++i)
        {
          r[i] = p[0] + p[1] * x[i] - y[i];
          if (J)
            {
              (*J)[2 * i]     = 1;
              (*J)[2 * i + 1] = x[i];
            }
        }
      return true;
    };
    return problem;
  }
} // namespace

// x = 0, 1, 2 and y = 0, 1, 1: slope 1/2, intercept 1/6, SSE = 1/6, one degree of freedom,
// (JᵀJ)⁻¹ = [[5/6, −1/2], [−1/2, 1/2]]. 1e-12: a few roundings.
TEST(LevenbergMarquardt, StraightLineByHand)
{
  const auto fit = levenberg_marquardt(line({0, 1, 2}, {0, 1, 1}));
  EXPECT_TRUE(fit.converged);
  EXPECT_EQ(fit.reason, StopReason::relative_offset);
  EXPECT_EQ(fit.rank, 2u);
  // The offset of 1e-9 is in standard errors, hence 1e-9 for the parameters.
  EXPECT_NEAR(fit.parameters[0], 1. / 6, 1e-9);
  EXPECT_NEAR(fit.parameters[1], 1. / 2, 1e-9);
  EXPECT_NEAR(fit.sum_of_squares, 1. / 6, 1e-12);
  EXPECT_NEAR(fit.covariance[0], 5. / 36, 1e-12);
  EXPECT_NEAR(fit.covariance[1], -1. / 12, 1e-12);
  EXPECT_NEAR(fit.covariance[2], -1. / 12, 1e-12);
  EXPECT_NEAR(fit.covariance[3], 1. / 12, 1e-12);
  EXPECT_NEAR(fit.standard_errors[0], std::sqrt(5.) / 6, 1e-12);
  EXPECT_NEAR(fit.standard_errors[1], std::sqrt(1. / 12), 1e-12);
}

TEST(LevenbergMarquardt, ExactDataStopAtRoundingLevel)
{
  const auto fit = levenberg_marquardt(line({0, 1, 2, 3}, {1, 3, 5, 7}));
  EXPECT_TRUE(fit.converged) << describe(fit.reason);
  EXPECT_NEAR(fit.parameters[0], 1, 1e-13);
  EXPECT_NEAR(fit.parameters[1], 2, 1e-13);
}

// Both columns of the Jacobian are the same: the sum of the parameters is all that can be found.
TEST(LevenbergMarquardt, RankDeficiencyIsReported)
{
  const auto fit = levenberg_marquardt(line({1, 1, 1}, {1, 2, 4}));
  EXPECT_FALSE(fit.converged);
  EXPECT_EQ(fit.rank, 1u);
  EXPECT_TRUE(std::isnan(fit.standard_errors[0]));
  EXPECT_NEAR(fit.parameters[0] + fit.parameters[1], 7. / 3, 1e-8);
}

TEST(LevenbergMarquardt, AsManyPointsAsParametersHaveNoErrors)
{
  const auto fit = levenberg_marquardt(line({0, 1}, {1, 3}));
  EXPECT_NEAR(fit.parameters[1], 2, 1e-12);
  EXPECT_TRUE(fit.converged) << describe(fit.reason);
  EXPECT_TRUE(std::isnan(fit.standard_errors[0]));
}

TEST(LevenbergMarquardt, IterationLimitIsReported)
{
  LeastSquaresOptions options;
  options.max_iterations = 1;
  LeastSquaresProblem problem; // Rosenbrock's valley
  problem.n_residuals = 2;
  problem.start       = {-1.2, 1};
  problem.evaluate    = [](const auto &p, auto &r, auto *J) {
    r = {10 * (p[1] - p[0] * p[0]), 1 - p[0]};
    if (J)
      *J = {-20 * p[0], 10, -1, 0};
    return true;
  };
  const auto stopped = levenberg_marquardt(problem, options);
  EXPECT_EQ(stopped.reason, StopReason::iteration_limit);
  EXPECT_EQ(stopped.iterations, 1u);
  EXPECT_FALSE(stopped.converged);

  const auto finished = levenberg_marquardt(problem);
  EXPECT_NEAR(finished.parameters[0], 1, 1e-7);
  EXPECT_NEAR(finished.parameters[1], 1, 1e-7);
}

// √p fitted to 0.1: the Gauss–Newton step from p = 4 leads to p < 0, outside the domain.
TEST(LevenbergMarquardt, StepsOutsideTheDomainAreShortened)
{
  LeastSquaresProblem problem;
  problem.n_residuals      = 2;
  problem.start            = {4};
  problem.observation_norm = 0.1;
  problem.evaluate         = [](const auto &p, auto &r, auto *J) {
    if (!(p[0] > 0))
      return false;
    r = {std::sqrt(p[0]) - 0.1, 0.};
    if (J)
      *J = {0.5 / std::sqrt(p[0]), 0.};
    return true;
  };
  const auto fit = levenberg_marquardt(problem);
  EXPECT_TRUE(fit.converged) << describe(fit.reason);
  EXPECT_NEAR(fit.parameters[0], 0.01, 1e-12);
}

TEST(LevenbergMarquardt, BadInputIsRefused)
{
  EXPECT_THROW(levenberg_marquardt(line({1}, {1})), InputError);
  auto problem  = line({0, 1, 2}, {0, 1, 1});
  problem.start = {std::numeric_limits<double>::quiet_NaN(), 0};
  EXPECT_THROW(levenberg_marquardt(problem), InputError);
  LeastSquaresOptions options;
  options.max_iterations = 0;
  EXPECT_THROW(levenberg_marquardt(line({0, 1, 2}, {0, 1, 1}), options), InputError);
  options                 = {};
  options.relative_offset = 0;
  EXPECT_THROW(levenberg_marquardt(line({0, 1, 2}, {0, 1, 1}), options), InputError);
}
