#ifndef DPCONTACT_DATABASE_ROWS_FINDINGS_H
#define DPCONTACT_DATABASE_ROWS_FINDINGS_H

#include "fitting/coefficients.h"
#include "meshing/enum_names.h"
#include "solver/laws/parameter.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dpcontact
{
  enum class Grade
  {
    error,   ///< the row is wrong
    warning, ///< to be looked at: a failed row, one that stands out from its neighbours
    note
  };

  template <>
  struct EnumNames<Grade>
  {
    static constexpr const char     *what     = "grade";
    static constexpr EnumName<Grade> values[] = {{Grade::error, "error"},
                                                 {Grade::warning, "warning"},
                                                 {Grade::note, "note"}};
  };

  /// Something that a check found.
  struct Finding
  {
    Grade       grade;
    std::string where, what;
  };

  /// What checks find, and the comparisons that they are made of.
  class Findings
  {
  public:
    /// Of closed forms that are stored beside their inputs, relative: what rounding leaves.
    static constexpr double rounding = 1e-7;

    /// Hertz's curve, sampled and fitted, or what discretisation leaves of it, relative.
    static constexpr double elastic_tolerance = 3e-3;

    void add(Grade grade, const std::string &where, const std::string &what);

    /// Adds an error unless the number lies within the range or is not there (NaN).
    void check_number(const std::string &name,
                      double             value,
                      const Range       &range,
                      const std::string &where);

    /// Adds an error unless |value − expected| ≤ tolerance · |expected|.
    void require_close(const std::string &name,
                       double             value,
                       double             expected,
                       const std::string &where,
                       double             tolerance = rounding);

    /// The worst first, each grade in the order in which they were found.
    std::vector<Finding> sorted() const;

  private:
    std::vector<Finding> list;
  };

  /// |value − expected| ≤ tolerance · |expected|; of what is not finite, whether they are equal.
  bool is_close(double value, double expected, double tolerance = Findings::rounding);

  /// "NAME is VALUE, it should be EXPECTED"
  std::string versus(const std::string &name, double value, double expected);

  /// A row's place on the common curve of rows that differ in the load level alone.
  struct PlaceOnCurve
  {
    double       log_level; ///< ln Λ
    Coefficients values;    ///< ln a, b, ln m, n
    std::string  where;
  };

  /// Warns of values that are far from the line through their neighbours in the load level, where
  /// these are near. The curves bend, so that the limits are wide: a misplaced value stands out
  /// much more.
  void check_smooth(std::vector<PlaceOnCurve> places, Findings &findings);

  /// @throws CorruptData with the first error among the findings, and how many there are.
  void refuse_errors(const std::vector<Finding> &findings, const std::filesystem::path &file);
} // namespace dpcontact

#endif
