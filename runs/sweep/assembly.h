#ifndef DPCONTACT_RUNS_SWEEP_ASSEMBLY_H
#define DPCONTACT_RUNS_SWEEP_ASSEMBLY_H

#include "database/rows/row_store.h"
#include "runs/sweep/sweep.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace dpcontact
{
  /// What every row depends on besides its inputs. In a family a row depends on the others: their
  /// load levels are where the common path stops.
  nlohmann::json row_settings(const Sweep &sweep);

  /// A database must not be overwritten by rows of other settings. One that is damaged may be, if
  /// its rows are beside it.
  /// @throws SettingsMismatch printing both, CorruptData, FileError where sweep.database is a
  /// directory.
  void check_database(const Sweep &sweep);

  /// The rows of sweep.database as they stand in the file; none where it is missing, damaged, or
  /// made with other settings.
  std::vector<Record> rows_in_file(const Sweep &sweep);

  /// Writes rows of the file that are not among @p rows to them, and says how many: all where there
  /// are no rows at all, else those of other grids (unless they are to be dropped). So nothing is
  /// lost with the row directory. Call it under the lock. @throws FileError.
  void take_up_rows(const Sweep &sweep, const RowStore &rows);

  /// What stands in a database.
  struct Assembled
  {
    std::size_t converged = 0, failed = 0; ///< rows of the grid
    std::size_t kept    = 0;               ///< rows of other grids
    bool        written = false;           ///< else the file was up to date
  };

  /// Makes sweep.database of the rows of its whole grid, in the grid's order, and of those of other
  /// grids behind them: in the order in which they stand in the file, then the others by the names
  /// of their files. Says so. Where other rows are to be dropped, they leave the row directory once
  /// the database is written.
  /// @throws FileError where a row is missing.
  Assembled assemble_database(const Sweep &sweep, const RowStore &rows);

  /// A line on standard error.
  void log_sweep(const std::string &message);
} // namespace dpcontact

#endif
