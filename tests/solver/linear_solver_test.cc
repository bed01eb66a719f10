#include "solver/linear_solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace
{
  using dpcontact::CholeskySolver;
  using dpcontact::SymmetricMatrix;

  double uniform(std::mt19937 &engine)
  {
    return 2 * (static_cast<double>(engine()) / 4294967295.) - 1;
  }

  /// Random sparse symmetric matrix: about a tenth of the entries, in rows of growing size, and a
  /// diagonal that dominates by `margin` (negative: does not).
  SymmetricMatrix random_matrix(const unsigned int n, const double margin, const std::uint32_t seed)
  {
    std::mt19937                     engine(seed);
    std::vector<std::vector<double>> dense(n, std::vector<double>(n, 0.));
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < i; ++j)
        if (uniform(engine) > 0.8)
          dense[i][j] = dense[j][i] = uniform(engine);
    for (unsigned int i = 0; i < n; ++i)
      {
        double sum = 0;
        for (unsigned int j = 0; j < n; ++j)
          sum += std::abs(dense[i][j]);
        dense[i][i] = sum + margin;
      }
    SymmetricMatrix matrix;
    matrix.column_start = {0};
    for (unsigned int j = 0; j < n; ++j)
      {
        for (unsigned int i = 0; i <= j; ++i)
          if (dense[i][j] != 0)
            {
              matrix.row.push_back(static_cast<int>(i));
              matrix.value.push_back(dense[i][j]);
            }
        matrix.column_start.push_back(static_cast<int>(matrix.row.size()));
      }
    return matrix;
  }

  /// ‖b − A x‖∞ / (‖A‖∞ ‖x‖∞): a backward-stable solver leaves a small multiple of 1e-16.
  double backward_error(const SymmetricMatrix     &A,
                        const std::vector<double> &x,
                        const std::vector<double> &b)
  {
    std::vector<double> residual(b), row_sum(b.size(), 0.);
    for (unsigned int j = 0; j < A.n(); ++j)
      for (int k = A.column_start[j]; k < A.column_start[j + 1]; ++k)
        {
          const auto position = static_cast<std::size_t>(k);
          const auto i        = static_cast<unsigned int>(A.row[position]);
          const auto value    = A.value[position];
          residual[i] -= value * x[j];
          row_sum[i] += std::abs(value);
          if (i != j)
            {
              residual[j] -= value * x[i];
              row_sum[j] += std::abs(value);
            }
        }
    double error = 0, size = 0, norm = 0;
    for (std::size_t i = 0; i < b.size(); ++i)
      {
        error = std::max(error, std::abs(residual[i]));
        size  = std::max(size, std::abs(x[i]));
        norm  = std::max(norm, row_sum[i]);
      }
    return error / (norm * size);
  }

  std::vector<double> random_vector(const unsigned int n, const std::uint32_t seed)
  {
    std::mt19937        engine(seed);
    std::vector<double> b(n);
    for (auto &entry : b)
      entry = uniform(engine);
    return b;
  }

  TEST(cholesky_solver, random_positive_definite_systems_are_solved_to_rounding)
  {
    for (const unsigned int n : {1u, 2u, 37u, 300u})
      {
        const auto     A = random_matrix(n, 1e-3, 100 + n);
        CholeskySolver solver(A);
        ASSERT_TRUE(solver.factorize(A));
        const auto          b = random_vector(n, n);
        std::vector<double> x;
        solver.solve(b, x);
        EXPECT_LT(backward_error(A, x, b), 1e-14) << n << " unknowns";
      }
  }

  TEST(cholesky_solver, new_values_in_the_same_pattern_need_no_new_analysis)
  {
    auto                A = random_matrix(120, 1., 5);
    CholeskySolver      solver(A);
    const auto          b = random_vector(120, 6);
    std::vector<double> x;
    for (const double factor : {1., 1e-6, 3e9})
      {
        auto scaled = A;
        for (auto &value : scaled.value)
          value *= factor;
        ASSERT_TRUE(solver.factorize(scaled));
        solver.solve(b, x);
        EXPECT_LT(backward_error(scaled, x, b), 1e-14) << "factor " << factor;
      }
  }

  TEST(cholesky_solver, an_indefinite_matrix_is_reported_and_leaves_the_solver_usable)
  {
    const unsigned int n = 50;
    const auto         A = random_matrix(n, 1., 7);
    CholeskySolver     solver(A);
    for (const unsigned int flipped : {0u, 23u, n - 1})
      {
        auto indefinite = A;
        indefinite.value[static_cast<std::size_t>(indefinite.position(flipped, flipped))] *= -1;
        EXPECT_FALSE(solver.factorize(indefinite)) << "diagonal " << flipped;
        ASSERT_TRUE(solver.factorize(A)) << "after diagonal " << flipped;
        const auto          b = random_vector(n, 8);
        std::vector<double> x;
        solver.solve(b, x);
        EXPECT_LT(backward_error(A, x, b), 1e-14);
      }
  }

  TEST(cholesky_solver, a_singular_matrix_is_reported)
  {
    // [1 1; 1 1]: the second pivot is an exact zero.
    SymmetricMatrix A;
    A.column_start = {0, 1, 3};
    A.row          = {0, 0, 1};
    A.value        = {1., 1., 1.};
    CholeskySolver solver(A);
    EXPECT_FALSE(solver.factorize(A));
  }

  TEST(symmetric_matrix, an_entry_is_found_from_either_side_of_the_diagonal)
  {
    const auto A = random_matrix(20, 1., 9);
    for (unsigned int j = 0; j < A.n(); ++j)
      for (int k = A.column_start[j]; k < A.column_start[j + 1]; ++k)
        {
          const auto i = static_cast<unsigned int>(A.row[static_cast<std::size_t>(k)]);
          EXPECT_EQ(A.position(i, j), k);
          EXPECT_EQ(A.position(j, i), k);
        }
  }
} // namespace
