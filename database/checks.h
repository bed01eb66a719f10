#ifndef DPCONTACT_DATABASE_CHECKS_H
#define DPCONTACT_DATABASE_CHECKS_H

#include "database/store.h"
#include "database/universal_table.h"

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
  const char *to_string(Grade grade);

  /// Something that a check found.
  struct Finding
  {
    Grade       grade;
    std::string where, what;
  };

  /// Of every row: material and scene in range and not twice there; columns in their ranges
  /// (range_of()), scales of first yield, load level and published convention consistent; errors
  /// present; a, m = 1 and b, n = 1.5 where nothing yields; 0 ≤ δ_res < δ_max; where there is a
  /// curve, both branches monotone, their ends those of the row, unloading's work at most
  /// loading's, else that of the power laws; a, b, m, n smooth over the load levels of equal ν and
  /// φ.
  /// @return the worst first, each grade in the order of the rows.
  std::vector<Finding> check(const Database &database);

  /// The same of the universal table.
  std::vector<Finding> check(const UniversalTable &table);

  /// @throws CorruptData with the first error among the findings, and how many there are.
  void refuse_errors(const std::vector<Finding> &findings, const std::filesystem::path &file);
} // namespace dpcontact

#endif
