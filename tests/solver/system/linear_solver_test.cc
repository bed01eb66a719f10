#include "solver/system/linear_solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

namespace
{
  using dpcontact::make_direct_solver;
  using dpcontact::SparseMatrix;

  double uniform(std::mt19937 &engine)
  {
    return 2 * (static_cast<double>(engine()) / 4294967295.) - 1;
  }

  /// Random sparse symmetric matrix: about a tenth of the entries, in rows of growing size, and a
  /// diagonal that dominates by `margin` (negative: does not).
  SparseMatrix random_matrix(const unsigned int n, const double margin, const std::uint32_t seed)
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
    SparseMatrix matrix;
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
  double
  backward_error(const SparseMatrix &A, const std::vector<double> &x, const std::vector<double> &b)
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
          if (i != j && A.symmetric)
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

  TEST(CholeskySolver, random_positive_definite_systems_are_solved_to_rounding)
  {
    for (const unsigned int n : {1u, 2u, 37u, 300u})
      {
        const auto A      = random_matrix(n, 1e-3, 100 + n);
        const auto solver = make_direct_solver(A);
        ASSERT_TRUE(solver->factorize(A));
        const auto          b = random_vector(n, n);
        std::vector<double> x;
        solver->solve(b, x);
        EXPECT_LT(backward_error(A, x, b), 1e-14) << n << " unknowns";
      }
  }

  TEST(CholeskySolver, new_values_in_the_same_pattern_need_no_new_analysis)
  {
    auto                A      = random_matrix(120, 1., 5);
    const auto          solver = make_direct_solver(A);
    const auto          b      = random_vector(120, 6);
    std::vector<double> x;
    for (const double factor : {1., 1e-6, 3e9})
      {
        auto scaled = A;
        for (auto &value : scaled.value)
          value *= factor;
        ASSERT_TRUE(solver->factorize(scaled));
        solver->solve(b, x);
        EXPECT_LT(backward_error(scaled, x, b), 1e-14) << "factor " << factor;
      }
  }

  TEST(CholeskySolver, an_indefinite_matrix_is_reported_and_leaves_the_solver_usable)
  {
    const unsigned int n      = 50;
    const auto         A      = random_matrix(n, 1., 7);
    const auto         solver = make_direct_solver(A);
    for (const unsigned int flipped : {0u, 23u, n - 1})
      {
        auto indefinite = A;
        indefinite.value[static_cast<std::size_t>(indefinite.position(flipped, flipped))] *= -1;
        EXPECT_FALSE(solver->factorize(indefinite)) << "diagonal " << flipped;
        ASSERT_TRUE(solver->factorize(A)) << "after diagonal " << flipped;
        const auto          b = random_vector(n, 8);
        std::vector<double> x;
        solver->solve(b, x);
        EXPECT_LT(backward_error(A, x, b), 1e-14);
      }
  }

  TEST(CholeskySolver, a_singular_matrix_is_reported)
  {
    // [1 1; 1 1]: the second pivot is an exact zero.
    SparseMatrix A;
    A.column_start    = {0, 1, 3};
    A.row             = {0, 0, 1};
    A.value           = {1., 1., 1.};
    const auto solver = make_direct_solver(A);
    EXPECT_FALSE(solver->factorize(A));
  }

  /// The same pattern with both triangles, their values unlike, A symmetric in pattern alone.
  SparseMatrix make_unsymmetric(const SparseMatrix &A, const std::uint32_t seed)
  {
    std::mt19937                  engine(seed);
    std::vector<std::vector<int>> columns(A.n());
    for (unsigned int j = 0; j < A.n(); ++j)
      for (int k = A.column_start[j]; k < A.column_start[j + 1]; ++k)
        {
          const int i = A.row[static_cast<std::size_t>(k)];
          columns[j].push_back(i);
          columns[static_cast<std::size_t>(i)].push_back(static_cast<int>(j));
        }
    auto B = SparseMatrix::with_pattern(columns, false);
    for (unsigned int j = 0; j < A.n(); ++j)
      for (int k = B.column_start[j]; k < B.column_start[j + 1]; ++k)
        {
          const auto row = static_cast<unsigned int>(B.row[static_cast<std::size_t>(k)]);
          B.value[static_cast<std::size_t>(B.position(row, j))] =
            A.value[static_cast<std::size_t>(A.position(row, j))] *
            (row == j ? 1. : uniform(engine));
        }
    return B;
  }

  TEST(LuSolver, random_unsymmetric_systems_are_solved_to_rounding)
  {
    for (const unsigned int n : {1u, 2u, 37u, 300u})
      {
        const auto A      = make_unsymmetric(random_matrix(n, 1e-3, 200 + n), n);
        const auto solver = make_direct_solver(A);
        for (const double factor : {1., -1e6}) // new values, no new analysis; no sign is needed
          {
            auto scaled = A;
            for (auto &value : scaled.value)
              value *= factor;
            ASSERT_TRUE(solver->factorize(scaled));
            auto                b = random_vector(2 * n, n); // two right-hand sides
            std::vector<double> x;
            solver->solve(b, x);
            for (unsigned int k = 0; k < 2; ++k)
              {
                const auto begin = static_cast<std::ptrdiff_t>(k * n);
                const auto end   = begin + static_cast<std::ptrdiff_t>(n);
                EXPECT_LT(backward_error(scaled,
                                         {x.begin() + begin, x.begin() + end},
                                         {b.begin() + begin, b.begin() + end}),
                          1e-14)
                  << n << " unknowns";
              }
          }
      }
  }

  TEST(LuSolver, a_matrix_singular_up_to_rounding_is_reported)
  {
    // [1 1; 1 1 + e], as full columns
    for (const double excess : {0., 1e-15})
      {
        auto A            = SparseMatrix::with_pattern({{0, 1}, {0, 1}}, false);
        A.value           = {1., 1., 1., 1. + excess};
        const auto solver = make_direct_solver(A);
        EXPECT_FALSE(solver->factorize(A)) << excess;
      }
  }

  TEST(SymmetricMatrix, an_entry_is_found_from_either_side_of_the_diagonal)
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
