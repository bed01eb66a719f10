#ifndef DPCONTACT_SOLVER_STEP_EXTRAPOLATION_H
#define DPCONTACT_SOLVER_STEP_EXTRAPOLATION_H

#include "meshing/errors.h"
#include "solver/curve.h"

namespace dpcontact
{
  /// The extrapolated approach is not monotone: coarse and fine run differ too much.
  struct StepsTooLarge : SolverError
  {
    using SolverError::SolverError;
  };

  /// Richardson extrapolation in the load step, whose error is of first order (backward Euler under a
  /// growing contact). `coarse` and `fine` pass through the same force levels, `fine` through one more
  /// between each two. The result has the points of `fine`, whose approach and dissipated energy
  /// are moved on by their difference to `coarse`, interpolated linearly between common levels.
  /// @throws SolverError where the branches do not share their levels, StepsTooLarge.
  Curve extrapolate_steps(const Curve &coarse, const Curve &fine);

  /// Largest |F_fine(δ) − F_coarse(δ)| / F_max over the common levels of both branches: the force is
  /// compared at equal approach through the fine branch's own slope.
  double step_difference(const Curve &coarse, const Curve &fine);
} // namespace dpcontact

#endif
