#ifndef DPCONTACT_RUNS_ROW_H
#define DPCONTACT_RUNS_ROW_H

#include "database/record.h"
#include "fitting/curve_fit.h"
#include "fitting/uncertainty.h"
#include "runs/settings.h"

#include <array>
#include <string>

namespace dpcontact
{
  RowInputs row_inputs(const Case &input);

  /// Columns of the estimated errors of a, b, m, n: mesh, step, contact, far_field, finite_radius, fit, total.
  using ErrorColumns = std::array<std::array<double Record::*, 7>, 4>;
  ErrorColumns error_columns();

  /// Material and scene of a stored row.
  Case case_of(const RowInputs &inputs);

  /// The row of a computed scene: fits its curve. A fit that does not converge gives a row with
  /// status "failed" and the reason.
  Record row_of(const Case &input, const Solution &solution);

  /// A row without a curve: inputs, first yield, status "failed" and the reason.
  Record failed_row(const Case &input, const std::string &reason);

  /// Fits the row's curve and enters coefficients and status. @throws InputError for a bad curve.
  CurveFit fit_row(Record &row);

  /// Text on one line: libraries' messages have paragraphs.
  std::string one_line(const std::string &text);
} // namespace dpcontact

#endif
