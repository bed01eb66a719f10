#ifndef DPCONTACT_SOLVER_PROBLEM_LINEAR_SOLVER_KIND_H
#define DPCONTACT_SOLVER_PROBLEM_LINEAR_SOLVER_KIND_H

#include "meshing/enum_names.h"

namespace dpcontact
{
  /// How the linear systems of one scene are solved.
  enum class LinearSolver
  {
    automatic, ///< direct up to a number of unknowns, beyond it iterative
    direct,    ///< CHOLMOD or UMFPACK in one process, MUMPS in several
    iterative  ///< a Krylov method with algebraic multigrid
  };

  template <>
  struct EnumNames<LinearSolver>
  {
    static constexpr const char            *what     = "linear-solver";
    static constexpr EnumName<LinearSolver> values[] = {{LinearSolver::automatic, "auto"},
                                                        {LinearSolver::direct, "direct"},
                                                        {LinearSolver::iterative, "iterative"}};
  };
} // namespace dpcontact

#endif
