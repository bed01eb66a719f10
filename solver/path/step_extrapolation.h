#ifndef DPCONTACT_SOLVER_PATH_STEP_EXTRAPOLATION_H
#define DPCONTACT_SOLVER_PATH_STEP_EXTRAPOLATION_H

#include "meshing/errors.h"
#include "solver/problem/curve.h"

namespace dpcontact
{
  /// The extrapolated approach is not monotone: coarse and fine run differ too much.
  struct StepsTooLarge : SolverError
  {
    using SolverError::SolverError;
  };

  /// Order of the load step's error in the step. Backward Euler is of first order, but the edge of
  /// the contact sweeps over material at the surface that goes from no load to the full pressure
  /// within one step: halving the steps five times moves δ_max by ratios of 2.0 at Λ = 11 and 838
  /// (φ = 40°), of 1.65 to 1.9 at Λ = 392 and 3532 (φ = 20°).
  constexpr double step_order = 0.95;

  /// Error left after extrapolation, as a share of the difference between the two finest runs,
  /// while these are the first two and later; and of the difference between the two finest
  /// extrapolated curves. Halving the steps on, to 512, for Λ = 11, 392, 838 and 3532 leaves 0.05
  /// to 0.26, 0.05 to 0.15 (0.2 where the cells at the surface are not halved), and up to 0.4 of
  /// them.
  constexpr double share_of_first_difference        = 0.25;
  constexpr double share_of_difference              = 0.15;
  constexpr double share_of_extrapolated_difference = 0.35;

  /// Richardson extrapolation in the load step, for an error of the given order. `coarse` and
  /// `fine` pass through the same force levels, `fine` through one more between each two. The
  /// result has the points of `fine`, whose approach and dissipated energy are moved on by their
  /// difference to `coarse`, interpolated linearly between common levels.
  /// @throws SolverError where the branches do not share their levels, StepsTooLarge.
  Curve extrapolate_steps(const Curve &coarse, const Curve &fine, double order = step_order);

  /// The same where the contact's edge, moving from node to node under a pressure that does not
  /// grow any more, makes the difference of the two paths jump: of loading its smooth part corrects
  /// the fine path, a polynomial in ln F; of unloading its change since the peak besides.
  /// @throws SolverError, StepsTooLarge as extrapolate_steps().
  Curve
  extrapolate_steps_smoothly(const Curve &coarse, const Curve &fine, double order = step_order);

  /// What a solution of it carries among its warnings.
  constexpr const char *smooth_extrapolation_warning =
    "load step: its error jumps where the contact's edge moves from node to node; the smooth part "
    "is extrapolated, and of loading step_error holds that alone";

  /// Largest difference of the two paths' force over the peak force, of loading its smooth part.
  double smooth_step_difference(const Curve &coarse, const Curve &fine);

  /// Largest |F_fine(δ) − F_coarse(δ)| / F_max over the common levels of both branches: the force
  /// is compared at equal approach through the fine branch's own slope.
  double step_difference(const Curve &coarse, const Curve &fine);
} // namespace dpcontact

#endif
