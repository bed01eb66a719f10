#ifndef DPCONTACT_SOLVER_LINEAR_SOLVER_H
#define DPCONTACT_SOLVER_LINEAR_SOLVER_H

#include <memory>
#include <vector>

namespace dpcontact
{
  /// A square sparse matrix of symmetric pattern by columns, rows sorted, of which only the upper
  /// triangle (row ≤ column) is kept.
  struct SymmetricMatrix
  {
    std::vector<int>    column_start; ///< n + 1
    std::vector<int>    row;          ///< n_nonzeros
    std::vector<double> value;        ///< n_nonzeros

    unsigned int n() const { return static_cast<unsigned int>(column_start.size() - 1); }
    /// Index into `row` and `value` of an entry that the pattern holds.
    int position(unsigned int i, unsigned int j) const;
  };

  /// Direct solution of symmetric positive definite systems by CHOLMOD; the symbolic factorisation is
  /// made once for a pattern.
  class CholeskySolver
  {
  public:
    /// Analyses the pattern.
    explicit CholeskySolver(const SymmetricMatrix &matrix);
    ~CholeskySolver();
    CholeskySolver(const CholeskySolver &)            = delete;
    CholeskySolver &operator=(const CholeskySolver &) = delete;

    /// @return false where the matrix is not positive definite; nothing can be solved then.
    bool factorize(const SymmetricMatrix &matrix);

    /// x = A⁻¹ b with the last factorisation; b holds one or several right-hand sides by columns.
    void solve(const std::vector<double> &b, std::vector<double> &x) const;

  private:
    struct Workspace;
    std::unique_ptr<Workspace> workspace;
  };
} // namespace dpcontact

#endif
