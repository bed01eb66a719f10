#include "fitting/least_squares.h"
#include "tests/support/nist_problems.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numeric>

using namespace dpcontact;

namespace
{
  LeastSquaresProblem as_least_squares(const nist::Problem       &problem,
                                       const std::vector<double> &start)
  {
    LeastSquaresProblem result;
    result.n_residuals = problem.x.size();
    result.start       = start;
    result.observation_norm =
      std::sqrt(std::inner_product(problem.y.begin(), problem.y.end(), problem.y.begin(), 0.));
    result.evaluate = [&problem](const auto &p, auto &residuals, auto *jacobian) {
      std::vector<nist::Complex> b(p.begin(), p.end());
      for (std::size_t i = 0; i < problem.x.size(); ++i)
        residuals[i] = problem.model(b, problem.x[i]).real() - problem.y[i];
      if (jacobian)
        for (std::size_t j = 0; j < b.size(); ++j)
          {
            const double step = 1e-30 * (1 + std::fabs(p[j]));
            b[j]              = {p[j], step};
            for (std::size_t i = 0; i < problem.x.size(); ++i)
              (*jacobian)[i * b.size() + j] = problem.model(b, problem.x[i]).imag() / step;
            b[j] = p[j];
          }
      return true;
    };
    return result;
  }

  /// Matching digits, −log10 of the relative error; 11 is all that NIST certifies.
  double digits(const double value, const double certified)
  {
    const double error = std::fabs(value - certified) / std::fabs(certified);
    return std::isfinite(error) ? std::min(11., -std::log10(std::max(error, 1e-11))) : 0;
  }

  double worst(const std::vector<double> &values, const std::vector<double> &certified)
  {
    double result = 11;
    for (std::size_t i = 0; i < certified.size(); ++i)
      result = std::min(result, digits(values[i], certified[i]));
    return result;
  }
} // namespace

// Every problem from both of NIST's starting points. The relative offset of 1e-9 puts the
// parameters within about 1e-9 of a standard error, which is about their own size at worst: 8
// digits and a margin.
TEST(NistNonlinearRegression, CertifiedValuesFromBothStarts)
{
  for (const nist::Problem &problem : nist::problems())
    for (std::size_t s = 0; s < problem.starts.size(); ++s)
      {
        const auto   fit = levenberg_marquardt(as_least_squares(problem, problem.starts[s]));
        const double in_parameters = worst(fit.parameters, problem.certified);
        const double in_errors     = worst(fit.standard_errors, problem.standard_errors);
        const double in_squares    = digits(fit.sum_of_squares, problem.sum_of_squares);
        std::cout << problem.name << ", start " << s + 1 << ": " << in_parameters
                  << " digits in the parameters, " << in_errors << " in their errors, "
                  << in_squares << " in the sum of squares, " << fit.iterations << " iterations; "
                  << describe(fit.reason) << '\n';
        EXPECT_TRUE(fit.converged) << problem.name << ", start " << s + 1;
        EXPECT_GE(in_parameters, 8) << problem.name << ", start " << s + 1;
        EXPECT_GE(in_errors, 7) << problem.name << ", start " << s + 1;
        EXPECT_GE(in_squares, 9) << problem.name << ", start " << s + 1;
        EXPECT_EQ(fit.rank, problem.certified.size());
      }
}
