#include "solver/parallel/communicator.h"

#include <algorithm>
#include <mpi.h>
#include <numeric>

namespace dpcontact
{
  namespace
  {
    /// MPI counts in int.
    constexpr std::size_t largest_message = std::size_t(1) << 27;

    const MPI_Comm communicator = MPI_COMM_WORLD;
  } // namespace

  Communicator Communicator::world()
  {
    Communicator result;
    int          rank = 0, size = 1;
    MPI_Comm_rank(communicator, &rank);
    MPI_Comm_size(communicator, &size);
    result.own_rank = static_cast<unsigned int>(rank);
    result.n_ranks  = static_cast<unsigned int>(size);
    return result;
  }

  // Reduce and broadcast rather than one reduction to all: only the broadcast promises equal bits.
  void Communicator::sum(double *const values, const std::size_t n) const
  {
    if (alone())
      return;
    for (std::size_t first = 0; first < n; first += largest_message)
      {
        const int count = static_cast<int>(std::min(largest_message, n - first));
        MPI_Reduce(own_rank == 0 ? MPI_IN_PLACE : values + first,
                   values + first,
                   count,
                   MPI_DOUBLE,
                   MPI_SUM,
                   0,
                   communicator);
        MPI_Bcast(values + first, count, MPI_DOUBLE, 0, communicator);
      }
  }

  void Communicator::sum(std::vector<double> &values) const { sum(values.data(), values.size()); }

  double Communicator::sum(double value) const
  {
    sum(&value, 1);
    return value;
  }

  double Communicator::max(double value) const
  {
    if (!alone())
      MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, communicator);
    return value;
  }

  std::vector<double> Communicator::gather(const std::vector<double> &values) const
  {
    if (alone())
      return values;
    const int        own = static_cast<int>(values.size());
    std::vector<int> counts(n_ranks), first(n_ranks, 0);
    MPI_Allgather(&own, 1, MPI_INT, counts.data(), 1, MPI_INT, communicator);
    std::partial_sum(counts.begin(), counts.end() - 1, first.begin() + 1);
    std::vector<double> all(static_cast<std::size_t>(first.back() + counts.back()));
    MPI_Allgatherv(values.data(),
                   own,
                   MPI_DOUBLE,
                   all.data(),
                   counts.data(),
                   first.data(),
                   MPI_DOUBLE,
                   communicator);
    return all;
  }

  double Communicator::broadcast(double value) const
  {
    if (!alone())
      MPI_Bcast(&value, 1, MPI_DOUBLE, 0, communicator);
    return value;
  }
} // namespace dpcontact
