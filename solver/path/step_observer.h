#ifndef DPCONTACT_SOLVER_PATH_STEP_OBSERVER_H
#define DPCONTACT_SOLVER_PATH_STEP_OBSERVER_H

#include <functional>

namespace dpcontact
{
  /// Is told after every converged load step: the stage ("loading", "unloading" or "history", of
  /// a solve with the run before it), the fraction of the stage that is done (0 to 1), and the
  /// Newton iterations of the step.
  using StepObserver =
    std::function<void(const char *stage, double fraction, int newton_iterations)>;
} // namespace dpcontact

#endif
