#ifndef DPCONTACT_SOLVER_PATH_STEP_REFINEMENT_H
#define DPCONTACT_SOLVER_PATH_STEP_REFINEMENT_H

#include "solver/path/step_extrapolation.h"

#include <functional>
#include <optional>
#include <string>

namespace dpcontact
{
  /// How two runs of one path are compared, of which the second has twice as many load steps.
  /// Points is what a run gives.
  template <class Points>
  struct StepComparison
  {
    /// Largest difference of the force at equal approach over the largest force.
    std::function<double(const Points &coarse, const Points &fine)> difference;
    /// @throws StepsTooLarge where the result is not monotone.
    std::function<Points(const Points &coarse, const Points &fine)> extrapolate;
    /// The same for the smooth part of a difference that jumps. Both may be empty: there is no such
    /// last resort.
    std::function<double(const Points &coarse, const Points &fine)> smooth_difference;
    std::function<Points(const Points &coarse, const Points &fine)> extrapolate_smoothly;
  };

  /// That of curves of loading and unloading.
  StepComparison<Curve> curve_comparison();

  /// What becomes of an error above the tolerance where the load steps may not be halved any more.
  enum class AtLastSteps
  {
    accept,
    refuse
  };

  /// Whether the curve that is extrapolated from two runs of which one had to cut steps counts in
  /// comparisons of extrapolated curves.
  enum class CutRuns
  {
    compared,
    left_out
  };

  /// When the halving of the load steps ends.
  struct StepRule
  {
    unsigned int first_steps = 16; ///< of the first run
    unsigned int last_steps  = 16; ///< no run has more; first_steps times a power of two
    /// Error that is small enough, over the largest force. Unset: the last steps decide alone.
    std::optional<double> tolerance;
    AtLastSteps           at_last_steps = AtLastSteps::refuse;
    bool                  extrapolation = true;
    CutRuns               cut_runs      = CutRuns::compared;
    /// Error that the first extrapolation leaves, as a share of the two runs' difference.
    double first_share = share_of_first_difference;
  };

  /// What the halving of the load steps led to.
  template <class Points>
  struct RefinedSteps
  {
    Points       points;         ///< extrapolated, where that is asked for
    double       error  = 0;     ///< estimated, of the force over the largest force
    unsigned int steps  = 0;     ///< of the finest run
    bool         smooth = false; ///< whether the smooth part alone was extrapolated
    /// The result with one halving less, and the share of its difference to `points` that is
    /// expected to be left as an error.
    Points coarser;
    double coarser_share = 0;
  };

  /// Halves the load steps of a path, extrapolates in them and estimates the error that they leave,
  /// until that is small enough.
  ///
  /// The error is a share of the difference between the two finest runs and, from the third run on,
  /// at least a share of the difference between the two finest extrapolated curves. Runs that had
  /// to cut steps are no longer half as coarse as one another: nothing is known to cancel, so the
  /// whole difference counts as error, and no tolerance is met by it. Where the last extrapolation
  /// is no curve, or its error too large, the smooth part is extrapolated as a last resort.
  template <class Points>
  class StepRefinement
  {
  public:
    struct Run
    {
      Points points;
      bool   was_cut = false; ///< whether a load step had to be cut
    };

    StepRefinement(const StepComparison<Points> &comparison, const StepRule &rule);

    /// @param run_with makes a run with the given number of load steps.
    /// @throws StepsTooLarge where the last steps give no curve, SolverError where they leave an
    /// error above the tolerance.
    RefinedSteps<Points> refine(const std::function<Run(unsigned int steps)> &run_with);

  private:
    /// What two runs tell.
    struct Estimate
    {
      std::optional<Points> extrapolated; ///< unset where that is no curve, or not asked for
      double                error = 0;
      double                share = 1;      ///< of the runs' difference
      std::string           refusal;        ///< why there is no extrapolated curve
      bool                  trusted = true; ///< no step was cut
    };

    Estimate             estimate(const Run &coarse, const Run &fine) const;
    bool                 accepts(const Estimate &estimate, bool last) const;
    RefinedSteps<Points> result(const Run &coarse, const Run &fine, const Estimate &estimate) const;
    /// @return unset where there is no such last resort.
    std::optional<RefinedSteps<Points>>
                      smooth_result(const Run &coarse, const Run &fine, Estimate &estimate) const;
    [[noreturn]] void refuse(unsigned int steps, const Estimate &estimate) const;

    StepComparison<Points> comparison;
    StepRule               rule;
    std::optional<Points>  before; ///< extrapolated from the two runs before
  };
} // namespace dpcontact

#endif
