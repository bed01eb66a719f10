#ifndef DPCONTACT_DATABASE_ROWS_IDENTITY_H
#define DPCONTACT_DATABASE_ROWS_IDENTITY_H

#include "solver/problem/case.h"
#include "solver/problem/options.h"

#include <nlohmann/json_fwd.hpp>

namespace dpcontact
{
  // What makes two rows the same row: the case, and what it was computed with. Both are part of the
  // name of a row's file and are compared before rows are taken up again.

  /// The key of a case (key_of()), as one list: the criterion, then numbers. Infinite ones, which
  /// stand for what is not there, are null.
  nlohmann::json key_json(const Case &input);

  /// By name, the value of every option of the solver that the computation depends on: all of
  /// solver_options() but those that the others make void (SolverOption::applies).
  nlohmann::json identity_json(const SolverOptions &options);
} // namespace dpcontact

#endif
