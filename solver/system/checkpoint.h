#ifndef DPCONTACT_SOLVER_SYSTEM_CHECKPOINT_H
#define DPCONTACT_SOLVER_SYSTEM_CHECKPOINT_H

#include "solver/problem/curve.h"
#include "solver/system/arrays.h"

#include <functional>

namespace dpcontact
{
  /// How a long computation is kept, and taken up again.
  struct Checkpoint
  {
    /// What was kept last, or nothing.
    Arrays found;
    /// Called after every step on all processes with the whole state.
    std::function<void(const Arrays &)> keep;
  };

  /// The numbers of points, one point after another, and back.
  std::vector<double>     numbers_of(const std::vector<CurvePoint> &points);
  std::vector<CurvePoint> points_of(const std::vector<double> &numbers);
} // namespace dpcontact

#endif
