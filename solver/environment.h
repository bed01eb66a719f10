#ifndef DPCONTACT_SOLVER_ENVIRONMENT_H
#define DPCONTACT_SOLVER_ENVIRONMENT_H

#include "solver/communicator.h"

namespace dpcontact
{
  /// Keeps the solver's libraries to one thread a process. Keep one
  /// alive while solving. Construct it after any fork, never before.
  class Environment
  {
  public:
    Environment();
    /// Ends MPI and PETSc where they were started.
    ~Environment();
    Environment(const Environment &)            = delete;
    Environment &operator=(const Environment &) = delete;

    /// All processes of this run: those of mpirun, or this one alone.
    Communicator world() const;
  };

  /// Whether an MPI launcher started this process as one of several.
  bool launched_in_parallel();

  /// Starts MPI and PETSc once a process, where they are needed; Environment ends them.
  void start_parallel_libraries();
} // namespace dpcontact

#endif
