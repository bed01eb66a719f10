#ifndef DPCONTACT_RUNS_SWEEP_PROGRESS_H
#define DPCONTACT_RUNS_SWEEP_PROGRESS_H

#include <chrono>
#include <cstddef>
#include <string>

namespace dpcontact
{
  /// Rows done, rate and time left on standard error: one line that updates itself on a terminal, a
  /// line a row otherwise.
  class Progress
  {
  public:
    /// @param finished_before rows of `total` that were there already; they do not count in the rate.
    Progress(std::size_t total, std::size_t finished_before);
    ~Progress();

    /// One more row is done; `text` describes it. Lines that matter (failures, warnings) stay on a
    /// terminal too.
    void row_done(const std::string &text, bool matters);

    double seconds() const;

  private:
    std::size_t                           total;
    std::size_t                           done;
    std::size_t                           computed = 0;
    bool                                  terminal;
    std::chrono::steady_clock::time_point start;
  };

  /// "48 s", "12 min", "3 h 5 min"
  std::string format_duration(double seconds);

  /// The beginning of a UTF-8 text that leaves the last of so many columns free, so that a terminal
  /// neither breaks the line nor fails to clear it.
  std::string fitted(const std::string &text, std::size_t columns);
} // namespace dpcontact

#endif
