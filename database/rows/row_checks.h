#ifndef DPCONTACT_DATABASE_ROWS_ROW_CHECKS_H
#define DPCONTACT_DATABASE_ROWS_ROW_CHECKS_H

#include "database/rows/findings.h"
#include "database/rows/record.h"
#include "solver/closed_form/first_yield.h"

#include <string>
#include <vector>

namespace dpcontact
{
  // Parts of check() (checks.h). Each takes converged rows and adds errors unless it says
  // otherwise.

  /// How the row was fitted: standard errors and covariances follow from law, misfit and points;
  /// R² and misfit of all forms have the branch's own spread in common; the error of the fit is
  /// standard error and change with the window; the fits say that they converged.
  void check_fit(const Record &row, const std::string &where, Findings &findings);

  /// The state at the peak and after release: contact radius, pressure, energy, plastic volume and
  /// strain between the bounds that they put on each other; their equals on the curve, where there
  /// is one; what the solution cost.
  void check_state(const Record      &row,
                   const FirstYield  &yield,
                   const std::string &where,
                   Findings          &findings);

  /// Warns where rows that nearly fill the grid of their own inputs miss some of it, and where rows
  /// that fill it do not stand in its order; and of one row that alone has another value of an
  /// input than all others. Rows of no grid are left alone.
  void check_grid(const std::vector<Record> &records, Findings &findings);
} // namespace dpcontact

#endif
