#include "solver/parallel/launcher.h"

#include <algorithm>
#include <cstdlib>

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
} // namespace dpcontact
