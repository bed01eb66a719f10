#include "solver/environment.h"

#include <deal.II/base/multithread_info.h>

#include <omp.h>

namespace dpcontact
{
  Environment::Environment()
  {
    // One thread a process: sweeps run as many processes as there are cores.
    dealii::MultithreadInfo::set_thread_limit(1);
    // CHOLMOD asks for four threads whatever the number set; no active level leaves it one.
    omp_set_max_active_levels(0);
  }

  Environment::~Environment() = default;
} // namespace dpcontact
