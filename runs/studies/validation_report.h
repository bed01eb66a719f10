#ifndef DPCONTACT_RUNS_STUDIES_VALIDATION_REPORT_H
#define DPCONTACT_RUNS_STUDIES_VALIDATION_REPORT_H

#include "runs/interface/documents.h"
#include "runs/studies/validation_entries.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dpcontact
{
  /// The errors by name; legs as a list of end_force, mean and rms.
  Json json_of(const LawErrors &errors);

  /// What json_of() gave. @throws nlohmann::json::exception where the document is not that.
  LawErrors law_errors_of(const Json &document);

  /// path, law, material, scene, load_level and errors.
  Json json_of(const ValidationEntry &entry);

  /// The errors of one law over all entries of one kind of path.
  struct ValidationSummary
  {
    ValidationPath path;
    LawKind        law;
    std::size_t    count; ///< of entries, at least 1

    // The largest. force_max is over loading and unloading, energy_loss and restitution are the
    // absolute differences to what was computed.
    double loading_rms, unloading_rms, force_max, residual, energy_loss, restitution;
    double median_loading_rms, median_unloading_rms, median_restitution;
  };

  /// One for each path and law that has an entry, rows before histories.
  std::vector<ValidationSummary> summaries_of(const std::vector<ValidationEntry> &entries);

  /// path, law, count, `largest` and `median`.
  Json json_of(const ValidationSummary &summary);

  /// Writes the report: a line for each entry, with path, law, what the case is, load level and
  /// errors. @throws FileError.
  void write_validation_csv(const std::filesystem::path        &file,
                            const std::vector<ValidationEntry> &entries);
} // namespace dpcontact

#endif
