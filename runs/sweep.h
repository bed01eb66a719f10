#ifndef DPCONTACT_RUNS_SWEEP_H
#define DPCONTACT_RUNS_SWEEP_H

#include "runs/settings.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace dpcontact
{
  /// How the rows are computed.
  enum class SweepMode
  {
    direct,  ///< every row for itself
    families ///< one loading path serves rows of equal ν and φ (solver/families.h)
  };

  /// A grid to compute and where it goes.
  struct Sweep
  {
    std::vector<Case>     cases; ///< in the order of the table
    SweepMode             mode = SweepMode::direct;
    SolverOptions         solver;
    std::filesystem::path database;
    unsigned int          jobs         = 1;
    bool                  retry_failed = false; ///< compute rows again that failed before
  };

  /// What is stored of one case.
  enum class RowState
  {
    missing,
    converged,
    failed
  };

  /// How a sweep ended.
  struct SweepSummary
  {
    std::size_t computed  = 0; ///< in this run
    std::size_t converged = 0; ///< of all rows
    std::size_t failed    = 0; ///< of all rows
    double      seconds   = 0;
    bool assembled = false; ///< whether the database file was written (else it was up to date)
  };

  /// What is there already, one state a case. Changes nothing.
  /// @throws SettingsMismatch, FileError, CorruptData as RowStore.
  std::vector<RowState> row_states(const Sweep &sweep);

  /// Computes the rows that are missing, each stored on its own as it ends, by `jobs` processes,
  /// and assembles the database when none is missing. Must run before any Environment exists in
  /// this process. Progress goes to standard error.
  /// @throws SettingsMismatch where rows or database were made with other settings, FileError.
  SweepSummary run_sweep(const Sweep &sweep);
} // namespace dpcontact

#endif
