#ifndef DPCONTACT_RUNS_INTERFACE_LOOKUP_DOCUMENTS_H
#define DPCONTACT_RUNS_INTERFACE_LOOKUP_DOCUMENTS_H

#include "database/tables/lookup.h"
#include "runs/interface/documents.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dpcontact
{
  /// Where the table of a method lies in this project.
  std::filesystem::path default_database(LookupMethod method);

  /// The objects `material`, `scene`, `yield`, `fit`, `published_convention` of solve's document
  /// with what a table knows of them, `uncertainty` and others.
  /// @param curve_points of either branch of the law besides the first; 0: without `curve`.
  Json lookup_json(const Case &input, const LookupResult &result, unsigned int curve_points);

  /// `loading` and `unloading`, each `curve_points` + 1 points {approach, force} in m and N: of
  /// similarity the master curve and the contact law's unloading, else the power laws.
  Json lookup_curve_json(const LookupResult &result, unsigned int curve_points);

  /// The same for a person, with units.
  std::string describe(const Case &input, const LookupResult &result);

  /// One case of a grid, and what the table says about it.
  struct LookupAnswer
  {
    Case         input;
    LookupResult result;  ///< where it answers
    std::string  refused; ///< why it does not; otherwise empty
  };

  /// One line an answer: inputs, a, b, m, n in both conventions with their uncertainties, F_y, δ_y,
  /// peak and residual approach, warnings, and a `status`: "answered" or why not. Lines that begin
  /// with `#` give units. What is not known is empty.
  std::string lookup_csv(const std::vector<LookupAnswer> &answers);
} // namespace dpcontact

#endif
