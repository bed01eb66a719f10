#ifndef DPCONTACT_SOLVER_PARALLEL_ENVIRONMENT_H
#define DPCONTACT_SOLVER_PARALLEL_ENVIRONMENT_H

#include "solver/parallel/communicator.h"

namespace dpcontact
{
  /// Keeps the solver's libraries to one thread a process. Keep one
  /// alive while solving. Construct it after any fork, never before,
  /// and in the thread that solves.
  class Environment
  {
  public:
    /// @throws std::bad_alloc where there is no memory for BLAS, InputError where DEAL_II_NUM_THREADS is set to something that is no number of
    /// threads.
    Environment();
    /// Ends MPI and PETSc where they were started.
    ~Environment();
    Environment(const Environment &)            = delete;
    Environment &operator=(const Environment &) = delete;

    /// All processes of this run: those of mpirun, or this one alone.
    Communicator world() const;
  };

  /// deal.II reads DEAL_II_NUM_THREADS while it is being loaded, and ends the process where that is
  /// no number. This takes such an entry out of the environment, for Environment to refuse it. A
  /// program has the loader call it first of all.
  /// @param environment ends with a null pointer; changed in place.
  void set_aside_bad_threads(char **environment);

  /// Starts MPI and PETSc once a process, where they are needed; Environment ends them.
  void start_parallel_libraries();

  /// MPI from its start to its end; once a process, all ranks together. Nothing else starts MPI,
  /// and without a launcher (launched_ranks() == 1) nobody needs it. No fork may follow.
  class MpiSession
  {
  public:
    /// Starts MPI so that any thread may call it.
    /// @throws InputError where the MPI library refuses that, or finds another number of ranks than
    /// the launcher started (a launcher of another MPI).
    MpiSession();
    /// Waits for the other ranks.
    ~MpiSession();
    MpiSession(const MpiSession &)            = delete;
    MpiSession &operator=(const MpiSession &) = delete;

    unsigned int rank() const { return own_rank; }
    unsigned int size() const { return ranks; }

  private:
    unsigned int own_rank = 0;
    unsigned int ranks    = 1;
  };
} // namespace dpcontact

#endif
