#ifndef DPCONTACT_RUNS_INTERFACE_SPELLING_H
#define DPCONTACT_RUNS_INTERFACE_SPELLING_H

#include <string>
#include <vector>

namespace dpcontact
{
  /// The one of the words that may have been meant: capitals, '-' and '_' do not matter, and a
  /// letter in three may be wrong, missing or too many. Empty where none is near.
  std::string nearest(const std::string &word, const std::vector<std::string> &words);

  /// " (did you mean NEAREST?)", with what stands before the word; empty where none is near.
  std::string suggestion(const std::string              &word,
                         const std::vector<std::string> &words,
                         const std::string              &prefix = "");
} // namespace dpcontact

#endif
