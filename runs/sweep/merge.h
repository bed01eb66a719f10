#ifndef DPCONTACT_RUNS_SWEEP_MERGE_H
#define DPCONTACT_RUNS_SWEEP_MERGE_H

#include "runs/sweep/sweep.h"

#include <cstddef>
#include <filesystem>
#include <vector>

namespace dpcontact
{
  /// What came together.
  struct MergeSummary
  {
    std::size_t rows       = 0; ///< of the grid
    std::size_t duplicates = 0; ///< rows that several shards hold
    std::size_t converged  = 0;
    std::size_t failed     = 0;
    std::size_t kept       = 0; ///< rows of other grids that the database holds as well
  };

  /// Brings the rows of shards, and those that the database's own row directory has already,
  /// together in the latter, and assembles the database as a sweep of the whole grid does.
  ///
  /// Everything is checked before anything is written. Rows of the same inputs must be alike but
  /// for time and memory; a converged row stands above a failed one. A row file that is damaged is
  /// set aside as in a sweep, and missing. A merge that was killed is completed by the next.
  /// @param shards their row directories, or the databases that these belong to.
  /// @throws FileError for a directory that is not there, CorruptData where one holds no rows of
  /// ours or rows contradict each other, SettingsMismatch where one was made with other settings or
  /// holds rows of another grid, Error (incomplete) where rows are missing.
  MergeSummary merge_shards(const Sweep &sweep, const std::vector<std::filesystem::path> &shards);
} // namespace dpcontact

#endif
