#ifndef DPCONTACT_RUNS_STUDIES_EVALUATION_H
#define DPCONTACT_RUNS_STUDIES_EVALUATION_H

#include "runs/interface/documents.h"
#include "runs/interface/lookup_documents.h"

#include <filesystem>
#include <functional>

namespace dpcontact
{
  /// What `evaluate` compares and with what.
  struct Evaluation
  {
    std::filesystem::path rows;      ///< the paper's 162
    std::filesystem::path universal; ///< the universal table
    std::filesystem::path held_out;  ///< curves of materials in neither (runs/studies/held_out)
  };

  /// The document that runs/studies/held_out writes.
  /// @throws FileError, InputError where it has more than 256 MiB, CorruptData where it is no JSON.
  Json read_held_out(const std::filesystem::path &file);

  /// Document with `regression` (eq 19 beside table 2), `table_4` (relative errors of a, b, m, n of
  /// every method for the paper's types 1 and 2 against finite elements), `leave_one_out`,
  /// `held_out` in the paper's box (every method), `similarity` (the universal table on held-out
  /// materials over its box) and `seconds` (setting up and asking once). Coefficients in the
  /// published convention, as the paper's. Runs the solver for the two types.
  /// @param log is told what is done next. @throws FileError, CorruptData, SolverError.
  Json evaluate(const Evaluation &evaluation, const std::function<void(const std::string &)> &log);

  /// The universal table against held-out curves over its whole box: of each the force error of the
  /// master curve over loading and of the law over unloading (root mean square over the approach,
  /// over the peak force), the error of the law's residual overlap over the peak overlap, the
  /// errors of a, b, m, n beside what is stated, the power laws' own misfit; and a summary, whose
  /// `within` is the share of materials within `goal`, and `covered` the share, of those that
  /// yield, whose error is at most what is stated. The curves' own numerical error is not allowed
  /// for: it counts as the table's. Stated are the parts for interpolation and numerical error; a
  /// curve on a half-space has no finite radius.
  /// @throws CorruptData where `held_out` is no such document.
  Json compare_held_out(const UniversalTable &table, const Json &held_out);

  std::string describe_evaluation(const Json &document);
} // namespace dpcontact

#endif
