#include "solver/linear_solver.h"

#include "meshing/errors.h"

#include <algorithm>
#include <cholmod.h>

namespace dpcontact
{
  int SymmetricMatrix::position(const unsigned int i, const unsigned int j) const
  {
    const int  r     = static_cast<int>(std::min(i, j));
    const auto c     = std::max(i, j);
    const auto begin = row.begin() + column_start[c], end = row.begin() + column_start[c + 1];
    return static_cast<int>(std::lower_bound(begin, end, r) - row.begin());
  }

  struct CholeskySolver::Workspace
  {
    cholmod_common         common{};
    cholmod_factor        *factor = nullptr;
    mutable cholmod_dense *x = nullptr, *y = nullptr, *e = nullptr;

    Workspace()
    {
      cholmod_start(&common);
      common.print                      = 0;
      common.final_ll                   = 1; // LDLᵀ would take negative pivots without a word
      common.quick_return_if_not_posdef = 1;
    }
    ~Workspace()
    {
      cholmod_free_dense(&x, &common);
      cholmod_free_dense(&y, &common);
      cholmod_free_dense(&e, &common);
      cholmod_free_factor(&factor, &common);
      cholmod_finish(&common);
    }
    Workspace(const Workspace &)            = delete;
    Workspace &operator=(const Workspace &) = delete;
  };

  namespace
  {
    /// CHOLMOD's view of the matrix; it takes no ownership and does not write.
    cholmod_sparse view(const SymmetricMatrix &matrix)
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
  } // namespace

  CholeskySolver::CholeskySolver(const SymmetricMatrix &matrix)
    : workspace(std::make_unique<Workspace>())
  {
    cholmod_sparse a  = view(matrix);
    workspace->factor = cholmod_analyze(&a, &workspace->common);
    if (workspace->factor == nullptr)
      throw SolverError("CHOLMOD could not analyse the matrix (status " +
                        std::to_string(workspace->common.status) + ")");
  }

  CholeskySolver::~CholeskySolver() = default;

  bool CholeskySolver::factorize(const SymmetricMatrix &matrix)
  {
    cholmod_sparse a = view(matrix);
    cholmod_factorize(&a, workspace->factor, &workspace->common);
    return workspace->common.status == CHOLMOD_OK;
  }

  void CholeskySolver::solve(const std::vector<double> &b, std::vector<double> &x) const
  {
    Workspace    &w = *workspace;
    cholmod_dense rhs{};
    rhs.nrow = rhs.d = w.factor->n;
    rhs.ncol         = b.size() / w.factor->n;
    rhs.nzmax        = b.size();
    rhs.x            = const_cast<double *>(b.data());
    rhs.xtype        = CHOLMOD_REAL;
    rhs.dtype        = CHOLMOD_DOUBLE;
    if (!cholmod_solve2(CHOLMOD_A, w.factor, &rhs, nullptr, &w.x, nullptr, &w.y, &w.e, &w.common))
      throw SolverError("CHOLMOD could not solve (status " + std::to_string(w.common.status) + ")");
    const double *result = static_cast<const double *>(w.x->x);
    x.assign(result, result + b.size());
  }
} // namespace dpcontact
