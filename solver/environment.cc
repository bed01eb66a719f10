#include "solver/environment.h"

#include <deal.II/base/multithread_info.h>

#include <cstdlib>
#include <exception>
#include <omp.h>
#include <petscsys.h>
#include <string>

namespace dpcontact
{
  Environment::Environment()
  {
    // One thread a process: sweeps run as many processes as there are cores.
    dealii::MultithreadInfo::set_thread_limit(1);
    // CHOLMOD asks for four threads whatever the number set; no active level leaves it one.
    omp_set_max_active_levels(0);
  }

  Environment::~Environment()
  {
    PetscBool started = PETSC_FALSE;
    PetscInitialized(&started);
    // Whoever leaves by an exception must not wait here for the others: it ends, and mpirun them.
    if (started == PETSC_TRUE && (std::uncaught_exceptions() == 0 || !launched_in_parallel()))
      PetscFinalize(); // and MPI, which it started
  }

  Communicator Environment::world() const
  {
    if (!launched_in_parallel())
      return Communicator();
    start_parallel_libraries();
    return Communicator::world();
  }

  bool launched_in_parallel()
  {
    // Open MPI, MPICH and Slurm's srun, each in its own way.
    for (const char *const name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
      if (const char *const text = std::getenv(name); text != nullptr)
        return std::atoi(text) > 1;
    return false;
  }

  void start_parallel_libraries()
  {
    PetscBool started = PETSC_FALSE;
    PetscInitialized(&started);
    if (started == PETSC_TRUE)
      return;
    // Crashes end the process as they do without PETSc, errors come back as codes.
    PetscOptionsSetValue(nullptr, "-no_signal_handler", "");
    PetscInitializeNoArguments();
    PetscPushErrorHandler(PetscIgnoreErrorHandler, nullptr);
  }
} // namespace dpcontact
