#ifndef DPCONTACT_SOLVER_PATH_FORCE_HISTORY_H
#define DPCONTACT_SOLVER_PATH_FORCE_HISTORY_H

#include "solver/path/solution.h"
#include "solver/path/step_observer.h"

#include <vector>

namespace dpcontact
{
  /// A contact driven through a history of forces.
  struct ForceHistory
  {
    FirstYield yield;
    /// One branch a leg, each from the last point of the one before; the first from (0, 0). A leg
    /// beyond the largest force so far is two, which meet there. SI units.
    std::vector<std::vector<CurvePoint>> legs;
    double                               step_error = 0; ///< as Solution::step_error
    Cost                                 cost;
  };

  /// Presses two identical spheres, from the virgin state, to each of the forces in turn; 0
  /// releases them. Mesh, steps and extrapolation in the steps as in solve_contact().
  /// @param turning_points N, finite, not negative, no two neighbours equal, the first above 0.
  /// @throws InputError for values out of range, SolverError where the path cannot be completed.
  ForceHistory solve_force_history(const Material            &material,
                                   double                     radius,
                                   const std::vector<double> &turning_points,
                                   const SolverOptions       &options,
                                   const StepObserver        &observer = {});
} // namespace dpcontact

#endif
