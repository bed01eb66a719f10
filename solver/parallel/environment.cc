#include "solver/parallel/environment.h"

#include "meshing/errors.h"
#include "solver/parallel/blas_memory.h"
#include "solver/parallel/launcher.h"

#include <deal.II/base/multithread_info.h>

#include <cstdlib>
#include <cstring>
#include <exception>
#include <mpi.h>
#include <omp.h>
#include <petscsys.h>
#include <string>

namespace dpcontact
{
  namespace
  {
    const char threads_variable[] = "DEAL_II_NUM_THREADS";

    /// The entry of the environment for deal.II's threads that set_aside_bad_threads() took out.
    const char *bad_threads = nullptr;

    bool counts_threads(const char *text)
    {
      const std::size_t digits = std::strspn(text, "0123456789");
      return digits > 0 && digits < 10 && text[digits] == '\0' &&
             std::strtol(text, nullptr, 10) > 0;
    }
  } // namespace

  void set_aside_bad_threads(char **environment)
  {
    constexpr std::size_t length = sizeof(threads_variable) - 1;
    char                **kept   = environment;
    for (char **entry = environment; *entry != nullptr; ++entry)
      if (std::strncmp(*entry, threads_variable, length) == 0 && (*entry)[length] == '=' &&
          !counts_threads(*entry + length + 1))
        bad_threads = *entry;
      else
        *kept++ = *entry;
    *kept = nullptr;
  }

  Environment::Environment()
  {
    if (bad_threads != nullptr)
      throw InputError(std::string(bad_threads) + " is no number of threads: leave " +
                       threads_variable + " out of the environment; a solve has one thread");
    require_blas_memory();
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
