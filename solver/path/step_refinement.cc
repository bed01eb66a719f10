#include "solver/path/step_refinement.h"

#include "meshing/errors.h"

#include <algorithm>
#include <sstream>
#include <utility>
#include <vector>

namespace dpcontact
{
  StepComparison<Curve> curve_comparison()
  {
    return {step_difference,
            [](const Curve &coarse, const Curve &fine) { return extrapolate_steps(coarse, fine); },
            smooth_step_difference,
            [](const Curve &coarse, const Curve &fine) {
              return extrapolate_steps_smoothly(coarse, fine);
            }};
  }

  template <class Points>
  StepRefinement<Points>::StepRefinement(const StepComparison<Points> &comparison_,
                                         const StepRule               &rule_)
    : comparison(comparison_)
    , rule(rule_)
  {}

  template <class Points>
  typename StepRefinement<Points>::Estimate StepRefinement<Points>::estimate(const Run &coarse,
                                                                             const Run &fine) const
  {
    Estimate result;
    result.trusted = !(coarse.was_cut || fine.was_cut);
    result.share   = !result.trusted ? 1. : before ? share_of_difference : rule.first_share;
    const double difference = comparison.difference(coarse.points, fine.points);
    result.error            = difference; // what is left of a first-order error
    if (!rule.extrapolation)
      return result;
    try
      {
        result.extrapolated = comparison.extrapolate(coarse.points, fine.points);
      }
    catch (const StepsTooLarge &not_a_curve)
      {
        result.refusal = not_a_curve.what();
        return result;
      }
    result.error = result.share * difference;
    if (before && (result.trusted || rule.cut_runs == CutRuns::compared))
      result.error = std::max(result.error,
                              share_of_extrapolated_difference *
                                comparison.difference(*before, *result.extrapolated));
    return result;
  }

  template <class Points>
  bool StepRefinement<Points>::accepts(const Estimate &estimate, const bool last) const
  {
    return (last && rule.at_last_steps == AtLastSteps::accept) ||
           (rule.tolerance && estimate.error <= *rule.tolerance && estimate.trusted);
  }

  template <class Points>
  RefinedSteps<Points>
  StepRefinement<Points>::result(const Run &coarse, const Run &fine, const Estimate &estimate) const
  {
    RefinedSteps<Points> result;
    result.error = estimate.error;
    if (!estimate.extrapolated)
      {
        result.points        = fine.points;
        result.coarser       = before ? *before : coarse.points;
        result.coarser_share = before ? share_of_extrapolated_difference : 1.;
        return result;
      }
    result.points        = *estimate.extrapolated;
    result.coarser       = before ? *before : fine.points;
    result.coarser_share = before ? share_of_extrapolated_difference : rule.first_share;
    return result;
  }

  template <class Points>
  std::optional<RefinedSteps<Points>>
  StepRefinement<Points>::smooth_result(const Run &coarse,
                                        const Run &fine,
                                        Estimate  &estimate) const
  {
    if (!rule.extrapolation || !comparison.extrapolate_smoothly)
      return {};
    RefinedSteps<Points> result;
    try
      {
        result.points = comparison.extrapolate_smoothly(coarse.points, fine.points);
      }
    catch (const StepsTooLarge &)
      {
        return {};
      }
    estimate.error = estimate.share * comparison.smooth_difference(coarse.points, fine.points);
    result.error   = estimate.error;
    result.smooth  = true;
    result.coarser = fine.points;
    result.coarser_share = rule.first_share;
    return result;
  }

  template <class Points>
  void StepRefinement<Points>::refuse(const unsigned int steps, const Estimate &estimate) const
  {
    if (rule.at_last_steps == AtLastSteps::accept)
      throw StepsTooLarge(estimate.refusal);
    std::ostringstream message;
    message << "step-tolerance " << *rule.tolerance << " is not reached with " << steps
            << " load steps: ";
    const bool small = estimate.error <= *rule.tolerance;
    if (!estimate.refusal.empty())
      message << "the extrapolated curve is none (" << estimate.refusal << ")";
    else if (small && !estimate.trusted)
      message << "the error is estimated at " << estimate.error
              << ", but steps had to be cut, so that the estimate cannot be trusted";
    else
      message << "the error is estimated at " << estimate.error;
    message << (small ? "; refine the mesh (resolution)"
                      : "; ask for a larger tolerance or refine the mesh (resolution)");
    throw SolverError(message.str());
  }

  template <class Points>
  RefinedSteps<Points>
  StepRefinement<Points>::refine(const std::function<Run(unsigned int steps)> &run_with)
  {
    before              = {};
    unsigned int steps  = rule.first_steps;
    Run          coarse = run_with(steps);
    for (;;)
      {
        steps *= 2;
        Run        fine   = run_with(steps);
        Estimate   found  = estimate(coarse, fine);
        const bool last   = 2 * steps > rule.last_steps;
        const auto enough = [&](RefinedSteps<Points> refined) {
          refined.steps = steps;
          return refined;
        };
        if (accepts(found, last) && (found.extrapolated || !rule.extrapolation))
          return enough(result(coarse, fine, found));
        if (last)
          {
            // Where the edge of the contact, moving from node to node, makes the difference jump,
            // its smooth part is extrapolated instead.
            if (auto smooth = smooth_result(coarse, fine, found); smooth && accepts(found, last))
              return enough(std::move(*smooth));
            refuse(steps, found);
          }
        if (found.trusted || rule.cut_runs == CutRuns::compared)
          before = std::move(found.extrapolated);
        coarse = std::move(fine);
      }
  }

  template class StepRefinement<Curve>;
  template class StepRefinement<std::vector<std::vector<CurvePoint>>>;
} // namespace dpcontact
