#ifndef DPCONTACT_RUNS_INTERFACE_AGREEMENT_H
#define DPCONTACT_RUNS_INTERFACE_AGREEMENT_H

#include "runs/interface/documents.h"
#include "solver/parallel/communicator.h"

#include <cstddef>
#include <string>

namespace dpcontact
{
  // Processes that work together must have been given the same: what differs between two of them
  // would mix two computations, or let them wait for each other for ever.

  /// @param given to this process and to rank 0, by name.
  /// @throws InputError that names the first entry in which they differ, with both values.
  void check_agreement(const Json &given, std::size_t rank, const Json &given_to_rank_0);

  /// Compares what all processes were given, on all of them alike; to be called by all, before they
  /// do anything else together. @throws InputError on all of them.
  void check_agreement(const Communicator &processes, const Json &given);
} // namespace dpcontact

#endif
