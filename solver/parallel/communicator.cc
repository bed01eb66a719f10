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

    /// The values of all processes: a process's `counts[rank]` of them begin at `first[rank]`.
    template <typename Value>
    struct Gathered
    {
      std::vector<int>   counts, first;
      std::vector<Value> values;
    };

    template <typename Value>
    Gathered<Value>
    gather_all(const std::vector<Value> &own, const MPI_Datatype type, const std::size_t n_ranks)
    {
      const int       count = static_cast<int>(own.size());
      Gathered<Value> all{std::vector<int>(n_ranks), std::vector<int>(n_ranks, 0), {}};
      MPI_Allgather(&count, 1, MPI_INT, all.counts.data(), 1, MPI_INT, communicator);
      std::partial_sum(all.counts.begin(), all.counts.end() - 1, all.first.begin() + 1);
      all.values.resize(static_cast<std::size_t>(all.first.back()) +
                        static_cast<std::size_t>(all.counts.back()));
      MPI_Allgatherv(own.data(),
                     count,
                     type,
                     all.values.data(),
                     all.counts.data(),
                     all.first.data(),
                     type,
                     communicator);
      return all;
    }
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
    return alone() ? values : gather_all(values, MPI_DOUBLE, n_ranks).values;
  }

  std::vector<std::string> Communicator::gather(const std::string &text) const
  {
    if (alone())
      return {text};
    const auto all = gather_all(std::vector<char>(text.begin(), text.end()), MPI_CHAR, n_ranks);
    std::vector<std::string> texts;
    for (unsigned int rank = 0; rank < n_ranks; ++rank)
      texts.emplace_back(all.values.data() + all.first[rank],
                         static_cast<std::size_t>(all.counts[rank]));
    return texts;
  }

  double Communicator::broadcast(double value) const
  {
    if (!alone())
      MPI_Bcast(&value, 1, MPI_DOUBLE, 0, communicator);
    return value;
  }
} // namespace dpcontact
