#ifndef DPCONTACT_RUNS_SWEEP_RANK_POOL_H
#define DPCONTACT_RUNS_SWEEP_RANK_POOL_H

#include "solver/parallel/environment.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace dpcontact
{
  /// What a rank does with an order; its text goes back to rank 0.
  using RankWorker = std::function<std::string(const std::string &order)>;

  /// What another rank begins with.
  struct RankStart
  {
    RankWorker  worker;
    std::string given; ///< what it was started with, for rank 0 to compare
  };

  /// Rank 0's side of jobs that are computed by all ranks of an MPI job, each in its own process.
  ///
  /// Rank 0 hands out one job after another to whoever is idle, so that the ranks end together
  /// however unlike the jobs and the machines are; a fixed share a rank would be right only as far
  /// as the costs are known beforehand. It computes jobs itself as well, in a thread, or two ranks
  /// would do the work of one. The other ranks are in serve_ranks() meanwhile.
  ///
  /// A rank that dies takes all with it, as MPI has it: what was stored before stays.
  class RankPool
  {
  public:
    explicit RankPool(const MpiSession &session);
    /// Waits until the other ranks have ended what they are at, and lets them go.
    ~RankPool();
    RankPool(const RankPool &)            = delete;
    RankPool &operator=(const RankPool &) = delete;

    std::size_t size() const { return ranks.size(); }

    /// Hands out all orders, the first ones first.
    /// @param here does rank 0's own share, in another thread but one order at a time.
    /// @param on_ready is told what another rank was given before that rank has its first order. What
    /// it throws ends the run.
    /// @param on_end runs in the calling thread when an order (its number) has been done. What it
    /// throws ends the run.
    /// @throws FileError where another rank cannot work; what `here` throws.
    void run(const std::vector<std::string>                                   &orders,
             const RankWorker                                                 &here,
             const std::function<void(std::size_t, const std::string &given)> &on_ready,
             const std::function<void(std::size_t, const std::string &text)>  &on_end);

  private:
    enum class State
    {
      busy, ///< something will come from it; so is every rank at the start
      idle
    };
    struct Rank
    {
      State       state = State::busy;
      std::size_t order = 0; ///< what it works at
    };

    bool receive(const std::function<void(std::size_t, const std::string &given)> &on_ready,
                 const std::function<void(std::size_t, const std::string &text)>  &on_end);

    std::vector<Rank> ranks; ///< [0] is unused
  };

  /// What the other ranks do until rank 0's pool ends. What `start` or the worker throw becomes an
  /// error of rank 0.
  void serve_ranks(const std::function<RankStart()> &start);
} // namespace dpcontact

#endif
