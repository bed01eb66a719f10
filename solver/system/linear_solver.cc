#include "solver/system/linear_solver.h"

#include "meshing/errors.h"

#include <algorithm>
#include <cholmod.h>
#include <new>
#include <umfpack.h>

namespace dpcontact
{
  int SparseMatrix::position(const unsigned int i, const unsigned int j) const
  {
    const int  r     = static_cast<int>(symmetric ? std::min(i, j) : i);
    const auto c     = symmetric ? std::max(i, j) : j;
    const auto begin = row.begin() + column_start[c], end = row.begin() + column_start[c + 1];
    return static_cast<int>(std::lower_bound(begin, end, r) - row.begin());
  }

  SparseMatrix SparseMatrix::with_pattern(std::vector<std::vector<int>> columns,
                                          const bool                    symmetric)
  {
    SparseMatrix matrix;
    matrix.symmetric = symmetric;
    matrix.column_start.assign(1, 0);
    for (auto &column : columns)
      {
        std::sort(column.begin(), column.end());
        column.erase(std::unique(column.begin(), column.end()), column.end());
        matrix.row.insert(matrix.row.end(), column.begin(), column.end());
        matrix.column_start.push_back(static_cast<int>(matrix.row.size()));
      }
    matrix.value.assign(matrix.row.size(), 0.);
    return matrix;
  }

  namespace
  {
    /// Smallest over largest pivot below which a matrix counts as singular. Tangents of converged
    /// states have 1e-6 and more; what rounding leaves of a mechanism has less than 1e-16.
    constexpr double least_rcond = 1e-12;

    /// A machine that has not enough memory says nothing about the scene, as an error of the solver
    /// would. @throws std::bad_alloc.
    void require_memory(const int status, const int out_of_memory)
    {
      if (status == out_of_memory)
        throw std::bad_alloc();
    }
  } // namespace

  // Not in the unnamed namespace: a profile tells functions by their external names.
  class CholeskySolver : public DirectSolver
  {
  public:
    explicit CholeskySolver(const SparseMatrix &matrix)
    {
      cholmod_start(&common);
      common.print                      = 0;
      common.final_ll                   = 1; // LDLᵀ would take negative pivots without a word
      common.quick_return_if_not_posdef = 1;
      cholmod_sparse a                  = view(matrix);
      factor                            = cholmod_analyze(&a, &common);
      if (factor == nullptr)
        {
          const int status = common.status;
          cholmod_finish(&common);
          require_memory(status, CHOLMOD_OUT_OF_MEMORY);
          throw SolverError("CHOLMOD could not analyse the matrix (status " +
                            std::to_string(status) + ")");
        }
    }
    ~CholeskySolver() override
    {
      cholmod_free_dense(&result, &common);
      cholmod_free_dense(&y, &common);
      cholmod_free_dense(&e, &common);
      cholmod_free_factor(&factor, &common);
      cholmod_finish(&common);
    }
    CholeskySolver(const CholeskySolver &)            = delete;
    CholeskySolver &operator=(const CholeskySolver &) = delete;

    bool factorize(const SparseMatrix &matrix) override
    {
      cholmod_sparse a = view(matrix);
      cholmod_factorize(&a, factor, &common);
      require_memory(common.status, CHOLMOD_OUT_OF_MEMORY);
      return common.status == CHOLMOD_OK;
    }

    void solve(const std::vector<double> &b, std::vector<double> &x) const override
    {
      cholmod_dense rhs{};
      rhs.nrow = rhs.d = factor->n;
      rhs.ncol         = b.size() / factor->n;
      rhs.nzmax        = b.size();
      rhs.x            = const_cast<double *>(b.data());
      rhs.xtype        = CHOLMOD_REAL;
      rhs.dtype        = CHOLMOD_DOUBLE;
      if (!cholmod_solve2(CHOLMOD_A, factor, &rhs, nullptr, &result, nullptr, &y, &e, &common))
        {
          require_memory(common.status, CHOLMOD_OUT_OF_MEMORY);
          throw SolverError("CHOLMOD could not solve (status " + std::to_string(common.status) +
                            ")");
        }
      const double *values = static_cast<const double *>(result->x);
      x.assign(values, values + b.size());
    }

  private:
    /// CHOLMOD's view of the matrix; it takes no ownership and does not write.
    static cholmod_sparse view(const SparseMatrix &matrix)
    {
      cholmod_sparse a{};
      a.nrow = a.ncol = matrix.n();
      a.nzmax         = matrix.row.size();
      a.p             = const_cast<int *>(matrix.column_start.data());
      a.i             = const_cast<int *>(matrix.row.data());
      a.x             = const_cast<double *>(matrix.value.data());
      a.stype         = 1;
      a.itype         = CHOLMOD_INT;
      a.xtype         = CHOLMOD_REAL;
      a.dtype         = CHOLMOD_DOUBLE;
      a.sorted        = 1;
      a.packed        = 1;
      return a;
    }

    mutable cholmod_common common{};
    cholmod_factor        *factor = nullptr;
    mutable cholmod_dense *result = nullptr, *y = nullptr, *e = nullptr;
  };

  class LuSolver : public DirectSolver
  {
  public:
    explicit LuSolver(const SparseMatrix &pattern)
    {
      umfpack_di_defaults(control);
      // The pattern is symmetric and the diagonal holds the elastic stiffness: pivots stay on it.
      control[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC;
      const int n               = static_cast<int>(pattern.n());
      const int status          = umfpack_di_symbolic(n,
                                             n,
                                             pattern.column_start.data(),
                                             pattern.row.data(),
                                             nullptr,
                                             &symbolic,
                                             control,
                                             nullptr);
      require_memory(status, UMFPACK_ERROR_out_of_memory);
      if (status != UMFPACK_OK)
        throw SolverError("UMFPACK could not analyse the matrix (status " + std::to_string(status) +
                          ")");
    }
    ~LuSolver() override
    {
      umfpack_di_free_numeric(&numeric);
      umfpack_di_free_symbolic(&symbolic);
    }
    LuSolver(const LuSolver &)            = delete;
    LuSolver &operator=(const LuSolver &) = delete;

    bool factorize(const SparseMatrix &matrix_) override
    {
      matrix = matrix_; // solving refines with it
      umfpack_di_free_numeric(&numeric);
      const int status = umfpack_di_numeric(matrix.column_start.data(),
                                            matrix.row.data(),
                                            matrix.value.data(),
                                            symbolic,
                                            &numeric,
                                            control,
                                            info);
      require_memory(status, UMFPACK_ERROR_out_of_memory);
      return status == UMFPACK_OK && info[UMFPACK_RCOND] > least_rcond;
    }

    void solve(const std::vector<double> &b, std::vector<double> &x) const override
    {
      const std::size_t n = matrix.n();
      x.resize(b.size());
      for (std::size_t first = 0; first < b.size(); first += n)
        {
          const int status = umfpack_di_solve(UMFPACK_A,
                                              matrix.column_start.data(),
                                              matrix.row.data(),
                                              matrix.value.data(),
                                              x.data() + first,
                                              b.data() + first,
                                              numeric,
                                              control,
                                              nullptr);
          require_memory(status, UMFPACK_ERROR_out_of_memory);
          if (status != UMFPACK_OK)
            throw SolverError("UMFPACK could not solve (status " + std::to_string(status) + ")");
        }
    }

  private:
    double       control[UMFPACK_CONTROL], info[UMFPACK_INFO];
    void        *symbolic = nullptr, *numeric = nullptr;
    SparseMatrix matrix;
  };

  std::unique_ptr<DirectSolver> make_direct_solver(const SparseMatrix &matrix)
  {
    if (matrix.symmetric)
      return std::make_unique<CholeskySolver>(matrix);
    return std::make_unique<LuSolver>(matrix);
  }
} // namespace dpcontact
