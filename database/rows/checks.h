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
  /// φ; what row_checks.h adds on fit, state and cost. Of all rows: as many as the provenance says,
  /// and a grid that is nearly one.
  /// @return the worst first, each grade in the order of the rows.
  std::vector<Finding> check(const Database &database);

  /// A database whose rows others rely on.
  /// @throws as read_database() does; CorruptData where check() finds an error.
  Database read_checked_database(const std::filesystem::path &file);

  /// An HDF5 file whose rows and curves others rely on.
  /// @throws as read_store() does; CorruptData where check() finds an error, or a converged row has
  /// no curve.
  Database read_checked_store(const std::filesystem::path &file);

  /// Adds an error where the provenance says another number of rows, a warning where it says none.
  void check_rows_said(const Provenance &provenance, std::size_t rows, Findings &findings);
} // namespace dpcontact

#endif
