#ifndef DPCONTACT_RUNS_STUDIES_VALIDATION_ENTRIES_H
#define DPCONTACT_RUNS_STUDIES_VALIDATION_ENTRIES_H

#include "meshing/enum_names.h"
#include "runs/studies/validation.h"
#include "solver/problem/options.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dpcontact
{
  /// What a law is compared with.
  enum class ValidationPath
  {
    row,    ///< a stored curve, to the peak and back
    history ///< a history computed for the comparison
  };

  template <>
  struct EnumNames<ValidationPath>
  {
    static constexpr const char              *what     = "path";
    static constexpr EnumName<ValidationPath> values[] = {{ValidationPath::row, "row"},
                                                          {ValidationPath::history, "history"}};
  };

  /// Which of the two contact laws.
  enum class LawKind
  {
    row,      ///< ContactLaw::from_row of the curve's own row
    universal ///< ContactLaw::universal of its material
  };

  template <>
  struct EnumNames<LawKind>
  {
    static constexpr const char       *what     = "law";
    static constexpr EnumName<LawKind> values[] = {{LawKind::row, "row"},
                                                   {LawKind::universal, "universal"}};
  };

  /// One law against one computed path.
  struct ValidationEntry
  {
    Case           input;
    ValidationPath path;
    LawKind        law;
    double         load_level; ///< the largest F/F_y
    LawErrors      errors;
  };

  /// The converged rows of a database, each by the law of the row and, where the table covers the
  /// material, by the universal law.
  /// @throws FileError, CorruptData as read_checked_store().
  std::vector<ValidationEntry> entries_of_rows(const std::filesystem::path       &database,
                                               const std::optional<ContactTable> &table);

  /// Random histories to compute.
  struct HistoryStudy
  {
    unsigned int  count = 0, seed = 1;
    unsigned int  processes          = 1;
    double        largest_load_level = 1000; ///< of the peaks; the table may end before
    SolverOptions options;
  };

  /// What has become of them.
  struct HistoryEntries
  {
    std::vector<ValidationEntry> entries;
    std::vector<std::string>     failures; ///< one line for each history that was not computed
  };

  /// Computes random histories of materials within the table, or within 0 ≤ ν ≤ 0.45 and 0 ≤ φ ≤
  /// 50° without one, in processes of their own (run_jobs()). The law of a history's row is fitted
  /// to its largest peak.
  /// @param on_end is told which history has been done, counted from 0.
  HistoryEntries entries_of_histories(const HistoryStudy                     &study,
                                      const std::optional<ContactTable>      &table,
                                      const std::function<void(std::size_t)> &on_end);
} // namespace dpcontact

#endif
