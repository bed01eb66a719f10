#ifndef DPCONTACT_SOLVER_PROBLEM_OPTION_LIST_H
#define DPCONTACT_SOLVER_PROBLEM_OPTION_LIST_H

#include "solver/laws/parameter.h"
#include "solver/problem/options.h"

#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace dpcontact
{
  /// The value of an option as documents hold it: a count, a number, or a word.
  using OptionValue = std::variant<unsigned int, double, std::string>;

  /// One option of the solver. Command line, parameter files, help, default, range, JSON documents
  /// and the identity of stored rows follow from its entry in solver_options().
  struct SolverOption
  {
    std::string              name;           ///< as in text: "surface-halvings"
    std::string              help;           ///< without the default, which is added to it
    std::vector<std::string> choices   = {}; ///< of a word; empty: a count or a number
    bool                     is_count  = false;
    Dimension                dimension = Dimension::number; ///< of a number
    /// Whether a count or number is allowed, and what it must be in a message: "from 2 to 1024".
    std::function<bool(double)> allows     = {};
    std::string                 range_text = {};

    std::function<OptionValue(const SolverOptions &)> get;
    std::function<void(SolverOptions &, const std::string &)>
      read; ///< from text; throws InputError

    /// Whether the computation depends on it, given the others; empty: always.
    std::function<bool(const SolverOptions &)> applies = {};

    bool counts(const SolverOptions &options) const { return !applies || applies(options); }

    /// "40", "auto", "1000000": the value as text.
    std::string text(const SolverOptions &options) const;
  };

  /// All options, in the order of help. `geometry` comes first, because it sets defaults of others.
  const std::vector<SolverOption> &solver_options();

  /// The default as help says it, and what it is for other geometries where that differs:
  /// "40; in space 6".
  std::string default_text(const SolverOption &option);

  /// @throws InputError naming the first option out of its range, its value and the range.
  void check_option_ranges(const SolverOptions &options);
} // namespace dpcontact

#endif
