#ifndef DPCONTACT_RUNS_SWEEP_SWEEP_JOBS_H
#define DPCONTACT_RUNS_SWEEP_SWEEP_JOBS_H

#include "database/rows/record.h"
#include "runs/sweep/sweep.h"

#include <cstddef>
#include <vector>

namespace dpcontact
{
  /// Cases that are computed together, and those of them whose rows are wanted; numbers in
  /// Sweep::cases.
  struct Job
  {
    std::vector<std::size_t> members, wanted;
  };

  /// The jobs that give the wanted rows: a row each, or a family each.
  std::vector<Job> make_jobs(const Sweep &sweep, const std::vector<std::size_t> &wanted);

  /// Sorted by the time that they are expected to take, the same way on every machine.
  std::vector<Job> longest_first(const Sweep &sweep, std::vector<Job> jobs);

  /// The rows that this sweep is to compute, ascending: all, or those of its shard. The jobs of the
  /// whole grid are dealt out by expected cost, whatever is done already, and families stay whole;
  /// so every row is in exactly one of the shards.
  std::vector<std::size_t> rows_of_share(const Sweep &sweep);

  /// The wanted rows of a job. They are failed ones where the computation says so of its scene
  /// (SolverError, InputError); every other exception is the machine's or the program's fault and
  /// leaves, so that no row of it is stored.
  std::vector<Record> compute_rows(const Sweep &sweep, const Job &job);
} // namespace dpcontact

#endif
