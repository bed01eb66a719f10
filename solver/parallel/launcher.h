#ifndef DPCONTACT_SOLVER_PARALLEL_LAUNCHER_H
#define DPCONTACT_SOLVER_PARALLEL_LAUNCHER_H

namespace dpcontact
{
  /// How many processes an MPI launcher (mpirun, srun) started together with this one, as the
  /// environment that it set says; 1 without a launcher. Starts nothing.
  unsigned int launched_ranks();
} // namespace dpcontact

#endif
