#include "solver/parallel/environment.h"

#include "meshing/errors.h"

#include <deal.II/base/multithread_info.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <mpi.h>
#include <omp.h>
#include <petscsys.h>
#include <string>

namespace dpcontact
{
  namespace
  {
    /// 0 where the variable is not set or no number.
    unsigned int number_in(const char *variable)
    {
      const char *const text = std::getenv(variable);
      return text == nullptr ? 0 : static_cast<unsigned int>(std::strtoul(text, nullptr, 10));
    }
  } // namespace

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
    if (started == PETSC_TRUE && (std::uncaught_exceptions() == 0 || launched_ranks() == 1))
      PetscFinalize(); // and MPI, which it started
  }

  Communicator Environment::world() const
  {
    if (launched_ranks() == 1)
      return Communicator();
    start_parallel_libraries();
    return Communicator::world();
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

  unsigned int launched_ranks()
  {
    // Open MPI's mpirun; the process managers of MPICH and Intel MPI, srun --mpi=pmi2
    for (const char *const variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
      if (const unsigned int ranks = number_in(variable); ranks > 0)
        return ranks;
    // srun --mpi=pmix
    if (std::getenv("PMIX_RANK") != nullptr)
      return std::max(1U, number_in("SLURM_STEP_NUM_TASKS"));
    return 1;
  }

  MpiSession::MpiSession()
  {
    int provided = MPI_THREAD_SINGLE;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_MULTIPLE, &provided);
    int number = 0, count = 1;
    MPI_Comm_rank(MPI_COMM_WORLD, &number);
    MPI_Comm_size(MPI_COMM_WORLD, &count);
    own_rank = static_cast<unsigned int>(number);
    ranks    = static_cast<unsigned int>(count);

    std::string complaint;
    if (provided < MPI_THREAD_MULTIPLE)
      complaint = "this MPI library allows no threads (MPI_THREAD_MULTIPLE); start without it";
    else if (ranks != launched_ranks())
      complaint = "the launcher started " + std::to_string(launched_ranks()) +
                  " processes, but MPI found " + std::to_string(ranks) +
                  "; use the mpirun of the MPI that the program was built with";
    if (!complaint.empty())
      {
        MPI_Finalize();
        throw InputError(complaint);
      }
  }

  MpiSession::~MpiSession() { MPI_Finalize(); }
} // namespace dpcontact
