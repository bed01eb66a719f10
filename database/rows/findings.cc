#include "database/rows/findings.h"

#include "meshing/errors.h"
#include "meshing/number_text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dpcontact
{
  void Findings::add(const Grade grade, const std::string &where, const std::string &what)
  {
    list.push_back({grade, where, what});
  }

  std::vector<Finding> Findings::sorted() const
  {
    std::vector<Finding> result = list;
    std::stable_sort(result.begin(), result.end(), [](const Finding &p, const Finding &q) {
      return p.grade < q.grade;
    });
    return result;
  }

  void Findings::check_number(const std::string &name,
                              const double       value,
                              const Range       &range,
                              const std::string &where)
  {
    if (std::isnan(value))
      return;
    if (value < range.low || value > range.high || (range.open_low && value == range.low) ||
        (range.open_high && value == range.high))
      add(Grade::error,
          where,
          name + " = " + number_text(value) + " is outside [" + number_text(range.low) + ", " +
            number_text(range.high) + "]");
  }

  void Findings::require_close(const std::string &name,
                               const double       value,
                               const double       expected,
                               const std::string &where,
                               const double       tolerance)
  {
    if (!is_close(value, expected, tolerance))
      add(Grade::error, where, versus(name, value, expected));
  }

  bool is_close(const double value, const double expected, const double tolerance)
  {
    return value == expected || (std::isfinite(expected) &&
                                 std::abs(value - expected) <= tolerance * std::abs(expected));
  }

  std::string versus(const std::string &name, const double value, const double expected)
  {
    return name + " is " + number_text(value) + ", it should be " + number_text(expected);
  }

  void check_smooth(std::vector<PlaceOnCurve> places, Findings &findings)
  {
    constexpr double                widest_gap = 3; ///< of ln Λ
    constexpr std::array<double, 4> limits{.06, .03, .15, .04};
    // Of a load level that is not positive there is no logarithm to sort by; its range says so.
    places.erase(std::remove_if(places.begin(),
                                places.end(),
                                [](const PlaceOnCurve &p) { return !std::isfinite(p.log_level); }),
                 places.end());
    std::sort(places.begin(), places.end(), [](const PlaceOnCurve &p, const PlaceOnCurve &q) {
      return p.log_level < q.log_level;
    });
    for (std::size_t i = 1; i + 1 < places.size(); ++i)
      {
        const PlaceOnCurve &before = places[i - 1], &here = places[i], &after = places[i + 1];
        const double        gap = after.log_level - before.log_level;
        if (gap > widest_gap || gap < 1e-9)
          continue;
        const double t = (here.log_level - before.log_level) / gap;
        for (std::size_t c = 0; c < 4; ++c)
          {
            const double line = before.values[c] + t * (after.values[c] - before.values[c]);
            if (std::abs(here.values[c] - line) >
                limits[c] + 0.25 * std::abs(after.values[c] - before.values[c]))
              findings.add(Grade::warning,
                           here.where,
                           std::string(coefficient_names[c]) +
                             " stands out from its neighbours in the load level");
          }
      }
  }

  void refuse_errors(const std::vector<Finding> &findings, const std::filesystem::path &file)
  {
    std::size_t count = 0;
    while (count < findings.size() && findings[count].grade == Grade::error)
      ++count;
    if (count > 0)
      throw CorruptData(file.string() + ", " + findings[0].where + ": " + findings[0].what +
                        (count == 1 ? "" : ", and " + std::to_string(count - 1) + " more errors") +
                        "; `dpcontact check` lists what is wrong, export or table makes it again");
  }
} // namespace dpcontact
