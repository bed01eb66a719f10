#ifndef DPCONTACT_DATABASE_ROWS_CHECKS_H
#define DPCONTACT_DATABASE_ROWS_CHECKS_H

#include "database/rows/findings.h"
#include "database/rows/store.h"

#include <vector>

namespace dpcontact
{
  /// Of every row: material and scene in range and not twice there; columns in their ranges
  /// (schema.h), scales of first yield, load level and published convention consistent; errors
  /// present; a, m = 1 and b, n = 1.5 where nothing yields; 0 ≤ δ_res < δ_max; where there is a
  /// curve, both branches monotone, their ends those of the row, unloading's work at most
  /// loading's, else that of the power laws; a, b, m, n smooth over the load levels of equal ν and
  /// φ.
  /// @return the worst first, each grade in the order of the rows.
  std::vector<Finding> check(const Database &database);
} // namespace dpcontact

#endif
