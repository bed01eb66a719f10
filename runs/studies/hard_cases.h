#ifndef DPCONTACT_RUNS_STUDIES_HARD_CASES_H
#define DPCONTACT_RUNS_STUDIES_HARD_CASES_H

#include "solver/problem/curve.h"

#include <functional>
#include <string>
#include <vector>

namespace dpcontact
{
  /// What a hard case has come to.
  struct HardCaseRun
  {
    PathChecks   checks;
    unsigned int newton_iterations = 0, cut_backs = 0;
    std::string  found;        ///< what the case is about, in numbers
    bool         holds = true; ///< whether they are as they must be
  };

  /// A scene at the edge of what the solver is for.
  struct HardCase
  {
    std::string                  name, about;
    std::function<HardCaseRun()> run;
    /// Part of the message that it must end with; empty: it must converge.
    std::string error = {};
    /// Largest residual: Newton's 1e-10 and what rounding leaves of it.
    double residual_limit = 1e-8;
  };

  /// What every converged case is held to.
  namespace hard_case_limits
  {
    constexpr double yield_excess = 1e-8; ///< over the law's strength
    constexpr double penetration  = 1e-6; ///< over the approach: where augmentation stops
    constexpr double energy_error = 1e-6; ///< of the balance, over the largest work
  }                                       // namespace hard_case_limits

  const std::vector<HardCase> &hard_cases();

  /// Outcome of a case.
  struct HardCaseOutcome
  {
    HardCaseRun run;
    std::string outcome;     ///< "converged", or the error's message
    bool        as_expected; ///< outcome, limits and the case's own numbers
    double      seconds;
  };
  HardCaseOutcome run_hard_case(const HardCase &hard_case);
} // namespace dpcontact

#endif
