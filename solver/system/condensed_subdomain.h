#ifndef DPCONTACT_SOLVER_SYSTEM_CONDENSED_SUBDOMAIN_H
#define DPCONTACT_SOLVER_SYSTEM_CONDENSED_SUBDOMAIN_H

#include "solver/discretisation/discretisation.h"
#include "solver/system/distributed_solver.h"
#include "solver/system/linear_solver.h"

#include <memory>
#include <vector>

namespace dpcontact
{
  /// The part of the body that a step is solved for: the cells within a radius of the contact's
  /// centre.
  ///
  /// The rest stays elastic and untouched while the subdomain holds (the system checks that after
  /// every step), so it is condensed statically onto the unknowns that it shares with the
  /// subdomain: with the rest's stiffness K, E its own unknowns and I the shared ones,
  ///   S = K_II − K_IE K_EE⁻¹ K_EI,   u_E = −K_EE⁻¹ K_EI u_I.
  /// The solution is that of the whole body to rounding.
  ///
  /// Over several processes the subdomain is the whole body, and what stands here of cells,
  /// unknowns and matrix is a process's part: its cells, the unknowns that they touch, and what
  /// they add.
  template <int dim>
  class CondensedSubdomain
  {
  public:
    /// @param elastic_blocks elastic stiffness of every cell: upper triangle, row by row.
    /// @param radius in the mesh's unit; infinity: the whole body, nothing is condensed.
    /// @param symmetric whether the tangents of what yields are.
    /// @param kind of the linear solver; anything but LinearSolver::direct asks for the whole body.
    CondensedSubdomain(const Discretisation<dim>              &space,
                       const std::vector<std::vector<double>> &elastic_blocks,
                       double                                  radius,
                       bool                                    symmetric,
                       LinearSolver                            kind = LinearSolver::direct);

    bool whole() const { return n_shared() == 0; }

    double                    radius;
    std::vector<unsigned int> cells;    ///< indices of its cells
    std::vector<unsigned int> outside;  ///< and of the others
    std::vector<unsigned int> unknowns; ///< free unknown of each of its unknowns, ascending
    unsigned int              n_faces;  ///< its faces are the first n_faces of the surface

    SparseMatrix        matrix;         ///< tangent, over its unknowns
    std::vector<double> elastic_values; ///< of `matrix`, without plasticity and contact
    /// Of each of its cells' blocks in `matrix`, row by row: the upper triangle, or all of it where
    /// the matrix is not symmetric.
    std::vector<std::vector<int>> cell_positions;
    /// The same of each of its faces; empty where another process has the face's cell.
    std::vector<std::vector<int>> surface_positions;

    /// Prepares solve() with the present matrix. @return false where that is singular, or a
    /// symmetric one not positive definite.
    bool factorize();
    /// x = factor A⁻¹ b over all free unknowns; what lies outside the subdomain is ignored in b and
    /// zero in x.
    /// @return false where an iterative solver did not converge.
    bool solve(const std::vector<double> &b, double factor, std::vector<double> &x);
    /// Iterations of the linear solver so far; 0 of a direct one.
    unsigned int linear_iterations() const { return distributed ? distributed->iterations() : 0; }

    /// Adds what the elastic rest resists with to `residual` (over all free unknowns).
    void add_exterior_force(const std::vector<double> &u, std::vector<double> &residual) const;

    /// Sets the rest's own unknowns in `u` to equilibrium.
    void recover(std::vector<double> &u) const;

  private:
    std::size_t n_shared() const { return shared.size(); }
    void        condense(const Discretisation<dim>              &space,
                         const std::vector<std::vector<double>> &elastic_blocks,
                         const std::vector<unsigned int>        &inner_index);
    void        add_elastic(const std::vector<double> &upper_triangle, std::size_t cell);
    void        build_pattern(const Discretisation<dim>       &space,
                              const std::vector<unsigned int> &inner_index);

    std::unique_ptr<DirectSolver>           serial;      ///< of one process
    std::unique_ptr<DistributedSolver<dim>> distributed; ///< of several, or iterative
    std::vector<double>                     inner_rhs, inner_solution;

    std::vector<unsigned int> shared;      ///< free unknowns that subdomain and rest share
    std::vector<unsigned int> exterior;    ///< free unknowns of the rest alone
    std::vector<double>       stiffness;   ///< S, n_shared × n_shared, symmetric
    std::vector<double>       recovery;    ///< −K_EE⁻¹ K_EI by columns: n_exterior × n_shared
    std::vector<unsigned int> far_unknown; ///< of each body
    std::vector<double>       far_stiffness; ///< on it, where it is the subdomain's
  };
} // namespace dpcontact

#endif
