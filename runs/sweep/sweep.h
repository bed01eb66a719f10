#ifndef DPCONTACT_RUNS_SWEEP_SWEEP_H
#define DPCONTACT_RUNS_SWEEP_SWEEP_H

#include "solver/problem/case.h"
#include "solver/problem/options.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dpcontact
{
  class RankPool;

  /// How the rows are computed.
  enum class SweepMode
  {
    direct,  ///< every row for itself
    families ///< one loading path serves rows of equal ν and φ (solver/path/families.h)
  };

  template <>
  struct EnumNames<SweepMode>
  {
    static constexpr const char         *what     = "mode";
    static constexpr EnumName<SweepMode> values[] = {{SweepMode::direct, "direct"},
                                                     {SweepMode::families, "families"}};
  };

  /// One of several parts of a grid that are computed independently and merged
  /// (runs/sweep/merge.h).
  struct Shard
  {
    unsigned int number = 1; ///< from 1 on
    unsigned int count  = 1;
  };
  std::string to_string(const Shard &shard); ///< "2/4"

  /// What becomes of rows of other grids, made with the same settings, that the database holds.
  enum class OtherRows
  {
    keep, ///< they stand behind the grid's
    drop
  };

  /// A grid to compute and where it goes.
  struct Sweep
  {
    std::vector<Case>     cases; ///< in the order of the table
    SweepMode             mode = SweepMode::direct;
    SolverOptions         solver;
    std::filesystem::path database;             ///< of the whole grid
    unsigned int          jobs         = 1;     ///< processes that compute
    bool                  retry_failed = false; ///< compute rows again that failed before
    OtherRows             other_rows   = OtherRows::keep;
    std::optional<Shard>  shard; ///< compute this part only, and assemble nothing
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
    std::size_t rows      = 0; ///< of the grid, or of the shard
    std::size_t computed  = 0; ///< in this run
    std::size_t converged = 0; ///< of `rows`
    std::size_t failed    = 0; ///< of `rows`
    std::size_t kept      = 0; ///< rows of other grids that the database holds as well
    double      seconds   = 0;
  };

  /// The database whose row directory (RowStore::directory_of) takes the rows of this sweep: that
  /// of the grid, or `<name>.shard-2-of-4<extension>` beside it, which is never assembled.
  std::filesystem::path database_of_share(const Sweep &sweep);

  /// What is there already, one state a row of rows_of_share(). Changes nothing.
  /// @throws SettingsMismatch, FileError, CorruptData as RowStore.
  std::vector<RowState> row_states(const Sweep &sweep);

  /// Computes the rows that are missing, each stored on its own as it ends, and assembles the
  /// database when none is missing (a shard does not). Rows that the database holds but its row
  /// directory has lost are taken up from it. Progress goes to standard error.
  ///
  /// What the computation says of a scene is a failed row. Anything else (memory, files, a process
  /// that somebody ended twice) stops the sweep with its reason; the rows finished before are kept.
  /// @param ranks rank 0's pool under MPI, where the ranks compute; else `jobs` forked processes do,
  /// and no Environment may exist yet in this process.
  /// @throws SettingsMismatch where rows or database were made with other settings, FileError, and
  /// Error with the code of what stopped a worker.
  SweepSummary run_sweep(const Sweep &sweep, RankPool *ranks = nullptr);

  /// What the other ranks do meanwhile. What `read_sweep` throws becomes an error of rank 0.
  void serve_sweep(const std::function<Sweep()> &read_sweep);
} // namespace dpcontact

#endif
