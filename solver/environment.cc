#include "solver/environment.h"

#include <deal.II/base/multithread_info.h>

namespace dpcontact
{
  Environment::Environment()
  {
    // One thread a process: sweeps run as many processes as there are cores.
    dealii::MultithreadInfo::set_thread_limit(1);
  }

  Environment::~Environment() = default;
} // namespace dpcontact
