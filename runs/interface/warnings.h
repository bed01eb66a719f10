#ifndef DPCONTACT_RUNS_INTERFACE_WARNINGS_H
#define DPCONTACT_RUNS_INTERFACE_WARNINGS_H

#include "meshing/errors.h"
#include "solver/problem/case.h"

#include <string>
#include <vector>

namespace dpcontact
{
  /// Prints "dpcontact: warning: SENTENCE" on standard error, a line each.
  void print_warnings(const std::vector<std::string> &sentences);

  /// Prints what is doubtful in the cases of a grid: every sentence for a single case, otherwise
  /// how many cases are doubtful, and the first of them.
  void print_doubts(const std::vector<Case> &cases);

  /// Does something with a case. Errors of input and of the computation say the case as it was
  /// understood, so that a number in the wrong unit is seen.
  template <class Action>
  auto with_case(const Case &input, const Action &action) -> decltype(action())
  {
    try
      {
        return action();
      }
    catch (const InputError &error)
      {
        throw InputError(error.what() + (" (understood: " + label(input) + ")"));
      }
    catch (const SolverError &error)
      {
        throw SolverError(error.what() + (" (understood: " + label(input) + ")"), error.log);
      }
  }
} // namespace dpcontact

#endif
