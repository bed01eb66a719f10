#ifndef DPCONTACT_DATABASE_ROWS_COMPARISON_H
#define DPCONTACT_DATABASE_ROWS_COMPARISON_H

#include "database/rows/store.h"

#include <filesystem>
#include <vector>

namespace dpcontact
{
  /// A row of one database beside the row of another for the same material and scene.
  struct RowComparison
  {
    const Record *row, *other;

    /// One coefficient: a, b, m, n in this order.
    struct Difference
    {
      double value, other; ///< of the two rows
      double numerical;    ///< sum of what both rows state for mesh, step, contact and far field
      double total;        ///< sum of their totals, which hold finite radius and fit besides
    };
    Difference difference[4];

    /// Whether all four lie within that sum.
    bool agrees(double Difference::*stated) const;
  };

  /// Pairs the converged rows of two databases by their inputs, in the order of the first.
  /// @throws InputError where a row of the first has no partner or one of the two has failed.
  std::vector<RowComparison> compare(const Database &one, const Database &other);

  /// One line a row: inputs, load level, and of each coefficient both values, the relative
  /// difference and both stated ones. Lines that begin with `#` explain the columns.
  /// @throws FileError where the file cannot be written.
  void write_csv(const std::filesystem::path &file, const std::vector<RowComparison> &rows);
} // namespace dpcontact

#endif
