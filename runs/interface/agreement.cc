#include "runs/interface/agreement.h"

#include "database/files/json_text.h"
#include "meshing/errors.h"

#include <string>
#include <vector>

namespace dpcontact
{
  void check_agreement(const Json &given, const std::size_t rank, const Json &given_to_rank_0)
  {
    const auto found = differences(given_to_rank_0, given);
    if (!found.empty())
      throw InputError("the MPI ranks were not given the same: " + found.front().name + " is " +
                       found.front().left + " on rank 0 and " + found.front().right + " on rank " +
                       std::to_string(rank) +
                       "; start the same program with the same input on every host");
  }

  void check_agreement(const Communicator &processes, const Json &given)
  {
    if (processes.alone())
      return;
    const std::vector<std::string> texts = processes.gather(given.dump());
    const Json                     first = Json::parse(texts.front());
    for (std::size_t rank = 1; rank < texts.size(); ++rank)
      check_agreement(Json::parse(texts[rank]), rank, first);
  }
} // namespace dpcontact
