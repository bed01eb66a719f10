#ifndef DPCONTACT_RUNS_SWEEP_WORKER_POOL_H
#define DPCONTACT_RUNS_SWEEP_WORKER_POOL_H

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace dpcontact
{
  /// How one job ended.
  struct JobResult
  {
    std::size_t job  = 0;
    bool        died = false; ///< two processes ended before the job did; `text` says how
    std::string text;         ///< otherwise what the worker returned
  };

  /// What a worker process does with a job; its text goes back to the parent.
  using Worker = std::function<std::string(std::size_t job)>;

  /// Runs jobs in forked processes that take them one after another from the parent.
  ///
  /// The calling process must have no other threads. `make_worker` runs once in each child, where
  /// libraries may be started. A child that dies is replaced, and its job is tried once more;
  /// children end with the parent, however that ends. An exception that leaves a worker ends its
  /// child.
  /// @param on_start runs in the parent when a job is handed out.
  /// @param on_end runs in the parent when a job has ended; jobs end in any order. What it throws
  /// ends the pool.
  /// @throws std::system_error where processes or pipes cannot be made.
  void run_jobs(const std::vector<std::size_t>               &jobs,
                unsigned int                                  processes,
                const std::function<Worker()>                &make_worker,
                const std::function<void(std::size_t job)>   &on_start,
                const std::function<void(const JobResult &)> &on_end);
} // namespace dpcontact

#endif
