#ifndef DPCONTACT_DATABASE_ROWS_ROW_H
#define DPCONTACT_DATABASE_ROWS_ROW_H

#include "database/rows/record.h"

#include <string>

namespace dpcontact
{
  struct CurveFit;
  struct Solution;

  /// The row of a computed case: fits its curve. A fit that does not converge gives a row with
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
