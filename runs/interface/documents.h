#ifndef DPCONTACT_RUNS_INTERFACE_DOCUMENTS_H
#define DPCONTACT_RUNS_INTERFACE_DOCUMENTS_H

#include "database/rows/record.h"
#include "solver/output/plastic_zone.h"
#include "solver/problem/options.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace dpcontact
{
  struct FirstYield;

  using Json = nlohmann::ordered_json;

  // Parts of the documents that --json prints. SI units, angles in degrees, approaches mutual;
  // numbers that are not finite become null.

  /// A line that says what every converged state was held to; empty where Hertz's form was used.
  std::string describe_checks(const PathChecks &checks);
  Json        checks_json(const PathChecks &checks);
  Json        material_json(const Case &input);    ///< criterion, E, nu, phi_deg, sigma_c …
  Json        scene_json(const Case &input);       ///< radius, force_max
  Json        yield_json(const FirstYield &yield); ///< force, approach, pressure, …
  /// Extents in m, null for what is not there; null where nothing was computed.
  Json plastic_zone_json(const std::optional<PlasticZone> &zone);
  Json options_json(const SolverOptions &used); ///< by the names of the options
  Json fit_json(const Record &row);
  Json error_json(const ErrorParts &parts, double total); ///< by source, and the total
  Json error_json(const Record &row);                     ///< of a, b, m, n
  Json published_json(const PublishedRow &published);
  Json by_name(const Coefficients &values); ///< {"a": …, "b": …, "m": …, "n": …}
  Json cost_json(const Record &row);

  // The same for a person, with units.

  std::string describe(const FirstYield &yield);
  std::string describe_fit(const Record &row);

  /// Prints a document on standard output.
  void print_document(const Json &document);
} // namespace dpcontact

#endif
