#include "solver/system/distributed_solver.h"

#include "meshing/errors.h"
#include "solver/parallel/environment.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <numeric>
#include <petscksp.h>
#include <string>

namespace dpcontact
{
  namespace
  {
    /// Of the residual, to that of the right-hand side: Newton's steps stay quadratic, and the
    /// number of processes leaves no trace in a curve.
    constexpr double       krylov_tolerance = 1e-10;
    constexpr unsigned int most_iterations  = 1000;

    constexpr const char *options_prefix = "dpcontact_";

    /// Smoothing by symmetric successive over-relaxation bounds the spectrum by 1 whatever the
    /// diagonal; PETSc's own, Chebyshev's over an estimated spectrum, misses the few large
    /// eigenvalues of the nodes under penalty. Aggregates of one node carry fewer than six modes
    /// and leave coarse rows empty: the shift, of any size, passes over them, which relaxation by
    /// blocks of rows ("inodes") could not.
    constexpr std::pair<const char *, const char *> smoothing[] = {
      {"-mat_no_inode", ""},
      {"-dpcontact_mg_levels_ksp_type", "richardson"},
      {"-dpcontact_mg_levels_ksp_max_it", "1"},
      {"-dpcontact_mg_levels_pc_type", "sor"},
      {"-dpcontact_mg_levels_pc_sor_diagonal_shift", "1e-12"}};

    void check(const PetscErrorCode code, const char *what)
    {
      if (code == 0)
        return;
      if (code == PETSC_ERR_MEM)
        throw std::bad_alloc(); // the machine's matter, not the scene's
      const char *text = nullptr;
      PetscErrorMessage(code, &text, nullptr);
      throw SolverError(std::string("PETSc could not ") + what + ": " +
                        (text != nullptr ? text : "unknown error") + " (code " +
                        std::to_string(code) + ")");
    }

    void set_default_option(const char *name, const char *value)
    {
      PetscBool is_set = PETSC_FALSE;
      check(PetscOptionsHasName(nullptr, nullptr, name, &is_set), "look up an option");
      if (is_set == PETSC_FALSE)
        check(PetscOptionsSetValue(nullptr, name, value), "set an option");
    }
  } // namespace

  template <int dim>
  struct DistributedSolver<dim>::Objects
  {
    MPI_Comm              comm      = MPI_COMM_SELF;
    bool                  symmetric = true, iterative = true;
    std::vector<PetscInt> row; ///< of each free unknown
    PetscInt              first_row = 0, n_local = 0, n_rows = 0;
    std::vector<PetscInt> dummy_rows; ///< own rows of constrained displacements
    double                dummy_value = 0;
    std::vector<double>   values;
    Mat                   matrix = nullptr;
    KSP                   krylov = nullptr;
    Vec                   b = nullptr, x = nullptr, everywhere = nullptr;
    VecScatter            to_all     = nullptr;
    unsigned int          iterations = 0;

    ~Objects()
    {
      VecScatterDestroy(&to_all);
      VecDestroy(&everywhere);
      VecDestroy(&x);
      VecDestroy(&b);
      KSPDestroy(&krylov);
      MatDestroy(&matrix);
    }

    void number(const std::vector<typename Discretisation<dim>::Unknown> &unknowns,
                const Communicator                                       &processes);
    void create_matrix(const SparseMatrix &pattern, const std::vector<unsigned int> &unknowns);
    void set_near_null_space(const std::vector<typename Discretisation<dim>::Unknown> &unknowns);
    void create_krylov();
  };

  template <int dim>
  void DistributedSolver<dim>::Objects::number(
    const std::vector<typename Discretisation<dim>::Unknown> &unknowns,
    const Communicator                                       &processes)
  {
    // Nodes by owner, then by body and place in the mesh.
    std::vector<unsigned int> order(unknowns.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](const unsigned int i) {
      return std::make_tuple(unknowns[i].owner, unknowns[i].body, unknowns[i].node);
    };
    std::sort(order.begin(), order.end(), [&](const unsigned int i, const unsigned int j) {
      return std::make_pair(key(i), unknowns[i].component) <
             std::make_pair(key(j), unknowns[j].component);
    });
    row.resize(unknowns.size());
    std::vector<PetscInt> rows_of(processes.size(), 0);
    std::vector<bool>     is_free;
    PetscInt              next = 0;
    for (std::size_t k = 0; k < order.size(); ++k)
      {
        const auto &unknown = unknowns[order[k]];
        if (k == 0 || key(order[k]) != key(order[k - 1]))
          {
            next += dim;
            rows_of[unknown.owner] += dim;
            is_free.resize(static_cast<std::size_t>(next), false);
          }
        row[order[k]] = next - dim + static_cast<PetscInt>(unknown.component);
        is_free[static_cast<std::size_t>(row[order[k]])] = true;
      }
    n_rows    = next;
    n_local   = rows_of[processes.rank()];
    first_row = std::accumulate(rows_of.begin(), rows_of.begin() + processes.rank(), PetscInt(0));
    for (PetscInt r = first_row; r < first_row + n_local; ++r)
      if (!is_free[static_cast<std::size_t>(r)])
        dummy_rows.push_back(r);
  }

  template <int dim>
  void DistributedSolver<dim>::Objects::create_matrix(const SparseMatrix              &pattern,
                                                      const std::vector<unsigned int> &unknowns)
  {
    std::vector<PetscInt> rows, columns;
    const std::size_t     n = pattern.row.size();
    rows.reserve(2 * n + dummy_rows.size());
    columns.reserve(2 * n + dummy_rows.size());
    for (unsigned int j = 0; j < pattern.n(); ++j)
      for (int k = pattern.column_start[j]; k < pattern.column_start[j + 1]; ++k)
        {
          rows.push_back(row[unknowns[static_cast<unsigned int>(pattern.row[k])]]);
          columns.push_back(row[unknowns[j]]);
        }
    if (symmetric) // the lower triangle: mirror images
      for (std::size_t k = 0; k < n; ++k)
        if (rows[k] != columns[k])
          {
            rows.push_back(columns[k]);
            columns.push_back(rows[k]);
          }
    rows.insert(rows.end(), dummy_rows.begin(), dummy_rows.end());
    columns.insert(columns.end(), dummy_rows.begin(), dummy_rows.end());
    values.resize(rows.size());

    check(MatCreate(comm, &matrix), "create a matrix");
    check(MatSetSizes(matrix, n_local, n_local, n_rows, n_rows), "size the matrix");
    check(MatSetBlockSize(matrix, dim), "set the matrix' block size");
    check(MatSetType(matrix, MATAIJ), "set the matrix' type");
    check(MatSetPreallocationCOO(
            matrix, static_cast<PetscCount>(rows.size()), rows.data(), columns.data()),
          "lay out the matrix");
    if (symmetric)
      check(MatSetOption(matrix, MAT_SPD, PETSC_TRUE), "set the matrix' symmetry");
    check(MatCreateVecs(matrix, &x, &b), "create vectors");
    check(VecScatterCreateToAll(x, &to_all, &everywhere), "create a gathered vector");
  }

  template <int dim>
  void DistributedSolver<dim>::Objects::set_near_null_space(
    const std::vector<typename Discretisation<dim>::Unknown> &unknowns)
  {
    // Translations and rotations of each body; in axisymmetry the translation along the axis.
    constexpr unsigned int n_modes  = dim == 2 ? 1 : 6;
    unsigned int           n_bodies = 0;
    for (const auto &unknown : unknowns)
      n_bodies = std::max(n_bodies, unknown.body + 1);
    std::vector<Vec> modes(static_cast<std::size_t>(n_modes) * n_bodies, nullptr);
    for (std::size_t m = 0; m < modes.size(); ++m)
      {
        check(VecDuplicate(x, &modes[m]), "create a rigid-body mode");
        PetscScalar *value = nullptr;
        VecGetArray(modes[m], &value);
        for (std::size_t i = 0; i < unknowns.size(); ++i)
          {
            const auto    &unknown = unknowns[i];
            const PetscInt local   = row[i] - first_row;
            if (unknown.body != m / n_modes || local < 0 || local >= n_local)
              continue;
            const unsigned int mode = static_cast<unsigned int>(m % n_modes);
            if constexpr (dim == 2)
              value[local] = unknown.component == 1 ? 1 : 0;
            else if (mode < dim)
              value[local] = unknown.component == mode ? 1 : 0;
            else
              {
                dealii::Tensor<1, 3> axis;
                axis[mode - dim] = 1;
                value[local]     = dealii::cross_product_3d(
                  axis, dealii::Tensor<1, 3>(unknown.position))[unknown.component];
              }
          }
        VecRestoreArray(modes[m], &value);
        // Modes are orthonormalised as PETSc asks for.
        for (std::size_t k = 0; k < m; ++k)
          {
            PetscScalar product = 0;
            VecDot(modes[m], modes[k], &product);
            VecAXPY(modes[m], -product, modes[k]);
          }
        VecNormalize(modes[m], nullptr);
      }
    MatNullSpace space = nullptr;
    check(MatNullSpaceCreate(
            comm, PETSC_FALSE, static_cast<PetscInt>(modes.size()), modes.data(), &space),
          "take the rigid-body modes");
    check(MatSetNearNullSpace(matrix, space), "attach the rigid-body modes");
    MatNullSpaceDestroy(&space);
    for (Vec &mode : modes)
      VecDestroy(&mode);
  }

  template <int dim>
  void DistributedSolver<dim>::Objects::create_krylov()
  {
    check(KSPCreate(comm, &krylov), "create a solver");
    // PETSC_OPTIONS of the environment reaches this solver by its own names alone.
    check(KSPSetOptionsPrefix(krylov, options_prefix), "name the solver's options");
    PC preconditioner = nullptr;
    check(KSPGetPC(krylov, &preconditioner), "create a preconditioner");
    if (iterative)
      {
        check(KSPSetType(krylov, symmetric ? KSPCG : KSPGMRES), "set the Krylov method");
        check(PCSetType(preconditioner, PCGAMG), "set the preconditioner");
        for (const auto &[name, value] : smoothing)
          set_default_option(name, value);
        KSPSetNormType(krylov, symmetric ? KSP_NORM_UNPRECONDITIONED : KSP_NORM_PRECONDITIONED);
        KSPSetTolerances(krylov,
                         krylov_tolerance,
                         PETSC_DEFAULT,
                         PETSC_DEFAULT,
                         static_cast<PetscInt>(most_iterations));
      }
    else
      {
        check(KSPSetType(krylov, KSPPREONLY), "set the direct solver");
        check(PCSetType(preconditioner, symmetric ? PCCHOLESKY : PCLU), "set the factorisation");
        check(PCFactorSetMatSolverType(preconditioner, MATSOLVERMUMPS), "find MUMPS");
      }
    KSPSetFromOptions(krylov);
  }

  template <int dim>
  DistributedSolver<dim>::DistributedSolver(const Discretisation<dim>       &space,
                                            const SparseMatrix              &pattern,
                                            const std::vector<unsigned int> &unknowns,
                                            const LinearSolver               kind)
  {
    start_parallel_libraries();
    objects            = std::make_unique<Objects>();
    const auto &all    = space.communicator();
    objects->comm      = all.alone() ? MPI_COMM_SELF : MPI_COMM_WORLD;
    objects->symmetric = pattern.symmetric;
    objects->iterative = kind == LinearSolver::iterative;
    const auto places  = space.unknowns();
    objects->number(places, all);
    objects->create_matrix(pattern, unknowns);
    if (objects->iterative)
      objects->set_near_null_space(places);
    objects->create_krylov();
  }

  template <int dim>
  DistributedSolver<dim>::~DistributedSolver() = default;

  template <int dim>
  bool DistributedSolver<dim>::factorize(const SparseMatrix &part)
  {
    auto             &values = objects->values;
    const std::size_t n      = part.row.size();
    std::copy(part.value.begin(), part.value.end(), values.begin());
    std::size_t next     = n;
    double      diagonal = 0;
    for (unsigned int j = 0; j < part.n(); ++j)
      for (int k = part.column_start[j]; k < part.column_start[j + 1]; ++k)
        if (static_cast<unsigned int>(part.row[k]) == j)
          diagonal += part.value[k];
        else if (part.symmetric)
          values[next++] = part.value[k];
    if (objects->dummy_value == 0)
      objects->dummy_value = diagonal / part.n();
    std::fill(
      values.begin() + static_cast<std::ptrdiff_t>(next), values.end(), objects->dummy_value);
    check(MatSetValuesCOO(objects->matrix, values.data(), INSERT_VALUES), "assemble the matrix");
    check(KSPSetOperators(objects->krylov, objects->matrix, objects->matrix), "take the matrix");
    check(KSPSetUp(objects->krylov), "prepare the solver");
    PC preconditioner = nullptr;
    KSPGetPC(objects->krylov, &preconditioner);
    PCFailedReason reason = PC_NOERROR;
    PCGetFailedReason(preconditioner, &reason);
    return reason == PC_NOERROR;
  }

  template <int dim>
  bool DistributedSolver<dim>::solve(const std::vector<double> &b,
                                     const double               factor,
                                     std::vector<double>       &x)
  {
    PetscScalar *value = nullptr;
    VecSet(objects->b, 0);
    VecGetArray(objects->b, &value);
    for (std::size_t i = 0; i < b.size(); ++i)
      if (const PetscInt local = objects->row[i] - objects->first_row;
          local >= 0 && local < objects->n_local)
        value[local] = factor * b[i];
    VecRestoreArray(objects->b, &value);
    check(KSPSolve(objects->krylov, objects->b, objects->x), "solve");
    KSPConvergedReason reason     = KSP_CONVERGED_ITERATING;
    PetscInt           iterations = 0;
    KSPGetConvergedReason(objects->krylov, &reason);
    KSPGetIterationNumber(objects->krylov, &iterations);
    if (objects->iterative)
      objects->iterations += static_cast<unsigned int>(iterations);
    if (reason <= 0)
      return false;
    VecScatterBegin(
      objects->to_all, objects->x, objects->everywhere, INSERT_VALUES, SCATTER_FORWARD);
    VecScatterEnd(objects->to_all, objects->x, objects->everywhere, INSERT_VALUES, SCATTER_FORWARD);
    const PetscScalar *result = nullptr;
    VecGetArrayRead(objects->everywhere, &result);
    x.resize(b.size());
    for (std::size_t i = 0; i < b.size(); ++i)
      x[i] = result[objects->row[i]];
    VecRestoreArrayRead(objects->everywhere, &result);
    return true;
  }

  template <int dim>
  unsigned int DistributedSolver<dim>::iterations() const
  {
    return objects->iterations;
  }

  template class DistributedSolver<2>;
  template class DistributedSolver<3>;
} // namespace dpcontact
