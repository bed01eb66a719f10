#include "solver/system/newton.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace
{
  using dpcontact::NewtonOptions;
  using dpcontact::solve_newton;

  /// Minimises a convex potential of one variable, given by its first and second derivatives.
  struct Scalar
  {
    std::function<double(double)> gradient, curvature;
    double                        x, step = 0, rounding_share = 0;
    int                           evaluations = 0;

    double residual()
    {
      ++evaluations;
      return std::abs(gradient(x));
    }
    bool correction()
    {
      const double k = curvature(x);
      if (!(k > 0))
        return false;
      step = -gradient(x) / k;
      return true;
    }
    double slope() const { return step * gradient(x); }
    double rounding() const { return rounding_share; }
    void   move(const double t) { x += t * step; }
  };

  /// −log(1 − x²) + x: its derivative is smooth, its root in (−1, 0) is 1 − √2.
  Scalar smooth(const double start)
  {
    return {[](double x) { return 2 * x / (1 - x * x) + 1; },
            [](double x) { return (2 + 2 * x * x) / ((1 - x * x) * (1 - x * x)); },
            start};
  }

  TEST(Newton, converges_quadratically_on_a_smooth_convex_potential)
  {
    auto       problem = smooth(-0.2);
    const auto report  = solve_newton(problem, {1e-13, 25, 8, 0.5});
    ASSERT_TRUE(report.converged) << report.reason;
    EXPECT_NEAR(problem.x, 1 - std::sqrt(2.), 1e-13);
    EXPECT_EQ(report.residuals.size(), static_cast<std::size_t>(report.iterations) + 1);

    // Order from the last three residuals above rounding.
    std::vector<double> above;
    for (const double r : report.residuals)
      if (r > 1e-14)
        above.push_back(r);
    ASSERT_GE(above.size(), 3u);
    const auto   n = above.size();
    const double order =
      std::log(above[n - 1] / above[n - 2]) / std::log(above[n - 2] / above[n - 3]);
    EXPECT_NEAR(order, 2, 0.2) << "the asymptotic order is reached to 10 % near 1e-8";
  }

  TEST(Newton, a_linear_problem_takes_one_iteration_and_no_search)
  {
    Scalar     problem{[](double x) { return 3 * (x - 2); }, [](double) { return 3.; }, 100.};
    const auto report = solve_newton(problem, NewtonOptions());
    ASSERT_TRUE(report.converged);
    EXPECT_EQ(report.iterations, 1);
    EXPECT_EQ(problem.evaluations, 2);
    EXPECT_DOUBLE_EQ(problem.x, 2.);
  }

  /// x² /2 for |x| < 1, |x| − ½ beyond plus a little stiffness: Newton from outside overshoots and,
  /// without a search, cycles between two points, x = ±b.
  Scalar kinked()
  {
    const double soft = 0.01;
    return {[soft](double x) {
              return std::abs(x) < 1 ? x : std::copysign(1 + soft * (std::abs(x) - 1), x);
            },
            [soft](double x) { return std::abs(x) < 1 ? 1. : soft; },
            3.};
  }

  TEST(Newton, the_line_search_tames_a_convex_potential_with_a_kink)
  {
    NewtonOptions no_search;
    no_search.max_line_search = 0;
    auto       cycling        = kinked();
    const auto failed         = solve_newton(cycling, no_search);
    EXPECT_FALSE(failed.converged) << "the problem must need the search";

    auto       problem = kinked();
    const auto report  = solve_newton(problem, NewtonOptions());
    ASSERT_TRUE(report.converged) << report.reason;
    EXPECT_LE(report.iterations, 5);
    EXPECT_NEAR(problem.x, 0, 1e-10);
  }

  TEST(Newton, a_converged_start_costs_no_iteration)
  {
    auto       problem = smooth(1 - std::sqrt(2.));
    const auto report  = solve_newton(problem, {1e-10, 0, 8, 0.5});
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.iterations, 0);
    EXPECT_TRUE(report.reason.empty());
  }

  TEST(Newton, the_share_that_rounding_leaves_counts_as_converged)
  {
    // A residual that stands at 1e-3 whatever the iterate.
    Scalar stuck{[](double) { return 1e-3; }, [](double) { return 1.; }, 0.};
    EXPECT_FALSE(solve_newton(stuck, NewtonOptions()).converged);
    stuck.rounding_share = 2e-3;
    EXPECT_TRUE(solve_newton(stuck, NewtonOptions()).converged);
  }

  TEST(Newton, says_that_the_iterations_ran_out)
  {
    NewtonOptions options;
    options.max_iterations = 2;
    auto       problem     = smooth(-0.9999);
    const auto report      = solve_newton(problem, options);
    EXPECT_FALSE(report.converged);
    EXPECT_EQ(report.iterations, 2);
    EXPECT_EQ(report.reason, "no convergence in 2 Newton iterations");
  }

  TEST(Newton, says_that_the_tangent_is_not_positive_definite)
  {
    Scalar problem{
      [](double x) { return x * x * x - x; }, [](double x) { return 3 * x * x - 1; }, 0.1};
    const auto report = solve_newton(problem, NewtonOptions());
    EXPECT_FALSE(report.converged);
    EXPECT_EQ(
      report.reason,
      "no correction was found: the tangent is singular or indefinite, or the linear solver "
      "did not converge");
  }

  TEST(Newton, says_that_the_residual_is_not_finite)
  {
    // At the start, and after a step into x > 10 that the search cannot see.
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Scalar       at_start{[nan](double) { return nan; }, [](double) { return 1.; }, 0.};
    EXPECT_EQ(solve_newton(at_start, NewtonOptions()).reason, "the residual is not finite");

    NewtonOptions options;
    options.max_line_search = 0;
    Scalar later{[nan](double x) { return x > 10 ? nan : -1.; }, [](double) { return 0.05; }, 0.};
    const auto report = solve_newton(later, options);
    EXPECT_FALSE(report.converged);
    EXPECT_EQ(report.reason, "the residual is not finite");
    EXPECT_EQ(report.iterations, 1);
  }
} // namespace
