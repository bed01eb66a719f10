#include "runs/interface/spelling.h"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace dpcontact
{
  namespace
  {
    std::string simplified(std::string word)
    {
      for (char &letter : word)
        letter =
          letter == '_' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
      return word;
    }

    /// How many letters are to be changed, added or removed (Levenshtein).
    std::size_t distance(const std::string &from, const std::string &to)
    {
      std::vector<std::size_t> row(to.size() + 1);
      std::iota(row.begin(), row.end(), std::size_t(0));
      for (std::size_t i = 0; i < from.size(); ++i)
        {
          std::size_t diagonal = row[0]++;
          for (std::size_t j = 0; j < to.size(); ++j)
            {
              const std::size_t kept = diagonal + (from[i] == to[j] ? 0 : 1);
              diagonal               = row[j + 1];
              row[j + 1]             = std::min({kept, row[j] + 1, row[j + 1] + 1});
            }
        }
      return row.back();
    }
  } // namespace

  std::string nearest(const std::string &word, const std::vector<std::string> &words)
  {
    constexpr std::size_t longest = 100; // nobody mistypes more than that
    if (word.size() > longest)
      return "";
    const std::string typed = simplified(word);
    std::string       found;
    std::size_t       least = std::max<std::size_t>(1, typed.size() / 3) + 1;
    for (const std::string &candidate : words)
      if (const std::size_t here = distance(typed, simplified(candidate)); here < least)
        {
          least = here;
          found = candidate;
        }
    return found;
  }

  std::string suggestion(const std::string              &word,
                         const std::vector<std::string> &words,
                         const std::string              &prefix)
  {
    const std::string found = nearest(word, words);
    return found.empty() ? "" : " (did you mean " + prefix + found + "?)";
  }
} // namespace dpcontact
