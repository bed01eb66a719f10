#ifndef DPCONTACT_RUNS_SWEEP_ASSEMBLY_H
#define DPCONTACT_RUNS_SWEEP_ASSEMBLY_H

#include "database/rows/row_store.h"
#include "runs/sweep/sweep.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>

namespace dpcontact
{
  /// What every row depends on besides its inputs. In a family a row depends on the others: their
  /// load levels are where the common path stops.
  nlohmann::json row_settings(const Sweep &sweep);

  /// A database without its rows cannot be resumed, but it must not be overwritten by rows of
  /// other settings either.
  /// @throws SettingsMismatch, FileError where sweep.database is a directory.
  void check_database(const Sweep &sweep);

  /// What stands in a database.
  struct Assembled
  {
    std::size_t converged = 0, failed = 0; ///< rows
    bool        written = false;           ///< else the file was up to date
  };

  /// Makes sweep.database of the rows of its whole grid, in the grid's order, and says so.
  /// @throws FileError where a row is missing.
  Assembled assemble_database(const Sweep &sweep, const RowStore &rows);

  /// A line on standard error.
  void log_sweep(const std::string &message);
} // namespace dpcontact

#endif
