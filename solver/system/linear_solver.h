#ifndef DPCONTACT_SOLVER_SYSTEM_LINEAR_SOLVER_H
#define DPCONTACT_SOLVER_SYSTEM_LINEAR_SOLVER_H

#include "solver/problem/linear_solver_kind.h"

#include <memory>
#include <vector>

namespace dpcontact
{
  /// A square sparse matrix of symmetric pattern by columns, rows sorted. Of a symmetric one only
  /// the upper triangle (row ≤ column) is kept.
  struct SparseMatrix
  {
    bool                symmetric = true;
    std::vector<int>    column_start; ///< n + 1
    std::vector<int>    row;          ///< n_nonzeros
    std::vector<double> value;        ///< n_nonzeros

    /// A matrix of zeros with the given rows, in any order and any number of times, in each column.
    static SparseMatrix with_pattern(std::vector<std::vector<int>> columns, bool symmetric);

    unsigned int n() const { return static_cast<unsigned int>(column_start.size() - 1); }
    /// Index into `row` and `value` of an entry that the pattern holds; where only the upper
    /// triangle is kept, of its mirror image.
    int position(unsigned int i, unsigned int j) const;
  };

  /// Direct solution of sparse systems; the symbolic factorisation is made once for a pattern.
  class DirectSolver
  {
  public:
    virtual ~DirectSolver() = default;

    /// @return false where the matrix is singular, or a symmetric one not positive definite; nothing
    /// can be solved then.
    virtual bool factorize(const SparseMatrix &matrix) = 0;

    /// x = A⁻¹ b with the last factorisation; b holds one or several right-hand sides by columns.
    virtual void solve(const std::vector<double> &b, std::vector<double> &x) const = 0;
  };

  /// Analyses the pattern: CHOLMOD for a symmetric matrix, UMFPACK for another.
  std::unique_ptr<DirectSolver> make_direct_solver(const SparseMatrix &matrix);
} // namespace dpcontact

#endif
