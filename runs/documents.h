#ifndef DPCONTACT_RUNS_DOCUMENTS_H
#define DPCONTACT_RUNS_DOCUMENTS_H

#include "database/record.h"
#include "runs/settings.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace dpcontact
{
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
  Json error_json(const Record &row);     ///< a, b, m, n and how well they fit
  Json published_json(const Record &row); ///< a, m, approach_yield of the published convention
  Json cost_json(const Record &row);

  // The same for a person, with units.

  /// "E = 10 GPa, nu = 0.1, phi = 20°, sigma_c = 5 MPa, R = 100 mm, F_max = 100 N"
  std::string label(const Case &input);
  std::string describe(const FirstYield &yield);
  std::string describe_fit(const Record &row);

  /// Prints a document on standard output.
  void print_document(const Json &document);
} // namespace dpcontact

#endif
