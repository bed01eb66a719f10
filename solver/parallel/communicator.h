#ifndef DPCONTACT_SOLVER_PARALLEL_COMMUNICATOR_H
#define DPCONTACT_SOLVER_PARALLEL_COMMUNICATOR_H

#include <cstddef>
#include <string>
#include <vector>

namespace dpcontact
{
  /// The processes that solve one scene together. Every result is the same, to the last bit, on all
  /// of them: they take the same decisions. A single process calls no MPI at all.
  class Communicator
  {
  public:
    /// This process alone.
    Communicator() = default;
    /// All processes that mpirun started; MPI must have been started.
    static Communicator world();

    unsigned int rank() const { return own_rank; }
    unsigned int size() const { return n_ranks; }
    bool         alone() const { return n_ranks == 1; }

    /// Sums over the processes, in place.
    void   sum(std::vector<double> &values) const;
    double sum(double value) const;
    double max(double value) const;

    /// The values of all processes one after another, on every process.
    std::vector<double> gather(const std::vector<double> &values) const;

    /// The texts of all processes in the order of their ranks, on every process.
    std::vector<std::string> gather(const std::string &text) const;

    /// The first process's value.
    double broadcast(double value) const;

  private:
    void sum(double *values, std::size_t n) const;

    unsigned int own_rank = 0;
    unsigned int n_ranks  = 1;
  };
} // namespace dpcontact

#endif
