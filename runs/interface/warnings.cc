#include "runs/interface/warnings.h"

#include "solver/closed_form/plausibility.h"

#include <iostream>

namespace dpcontact
{
  void print_warnings(const std::vector<std::string> &sentences)
  {
    for (const std::string &sentence : sentences)
      std::cerr << "dpcontact: warning: " << sentence << std::endl;
  }

  void print_doubts(const std::vector<Case> &cases)
  {
    if (cases.size() == 1)
      return print_warnings(doubts_about(cases.front()));
    std::size_t doubtful = 0;
    std::string first;
    for (const Case &input : cases)
      if (const auto doubts = doubts_about(input); !doubts.empty() && doubtful++ == 0)
        first = label(input) + ": " + joined(doubts);
    if (doubtful > 0)
      print_warnings({std::to_string(doubtful) + " of " + std::to_string(cases.size()) +
                      " cases are doubtful, as " + first});
  }
} // namespace dpcontact
