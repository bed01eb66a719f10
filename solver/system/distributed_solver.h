#ifndef DPCONTACT_SOLVER_SYSTEM_DISTRIBUTED_SOLVER_H
#define DPCONTACT_SOLVER_SYSTEM_DISTRIBUTED_SOLVER_H

#include "solver/discretisation/discretisation.h"
#include "solver/system/linear_solver.h"

#include <memory>
#include <vector>

namespace dpcontact
{
  /// Solution, by PETSc, of the linear systems that one or several processes assemble.
  ///
  /// Rows are distributed by whole nodes, each with `dim` rows: those of constrained displacements
  /// stand on the diagonal alone. So multigrid can be given blocks and the rigid-body modes, which
  /// its coarse spaces must hold. Symmetric: conjugate gradients with smoothed aggregation
  /// (Vaněk, Mandel & Brezina, Computing 56, 1996; PETSc's GAMG), or MUMPS' Cholesky
  /// factorisation. Otherwise GMRES with the same multigrid, or MUMPS' LU.
  template <int dim>
  class DistributedSolver
  {
  public:
    /// @param pattern this process' part of the matrix, over `unknowns`: the free unknowns of
    /// `space` that its columns stand for.
    DistributedSolver(const Discretisation<dim>       &space,
                      const SparseMatrix              &pattern,
                      const std::vector<unsigned int> &unknowns,
                      LinearSolver                     kind);
    ~DistributedSolver();
    DistributedSolver(const DistributedSolver &)            = delete;
    DistributedSolver &operator=(const DistributedSolver &) = delete;

    /// Adds the parts of all processes up and prepares solve().
    /// @return false where a direct solver finds the matrix singular, or a symmetric one not
    /// positive definite.
    bool factorize(const SparseMatrix &part);

    /// x = factor A⁻¹ b over all free unknowns, on every process.
    /// @return false where the Krylov method does not converge (a matrix that is not definite).
    bool solve(const std::vector<double> &b, double factor, std::vector<double> &x);

    /// Krylov iterations of all solves so far; of a direct solver 0.
    unsigned int iterations() const;

  private:
    struct Objects;
    std::unique_ptr<Objects> objects;
  };
} // namespace dpcontact

#endif
