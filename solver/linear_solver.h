#ifndef DPCONTACT_SOLVER_LINEAR_SOLVER_H
#define DPCONTACT_SOLVER_LINEAR_SOLVER_H

#include "meshing/errors.h"

#include <memory>
#include <string>
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

  /// How the linear systems of one scene are solved.
  enum class LinearSolver
  {
    automatic, ///< direct up to a size, then iterative
    direct,    ///< CHOLMOD or UMFPACK of one process, MUMPS of several
    iterative  ///< Krylov method with algebraic multigrid
  };

  /// The name by which a linear solver is asked for.
  inline const char *to_string(const LinearSolver solver)
  {
    return solver == LinearSolver::direct      ? "direct"
           : solver == LinearSolver::iterative ? "iterative"
                                               : "auto";
  }

  /// @throws InputError where `name` is none of the names that to_string() gives.
  inline LinearSolver parse_linear_solver(const std::string &name)
  {
    for (const LinearSolver solver :
         {LinearSolver::automatic, LinearSolver::direct, LinearSolver::iterative})
      if (name == to_string(solver))
        return solver;
    throw InputError("linear-solver = '" + name +
                     "' is unknown; it must be auto, direct or iterative");
  }

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
