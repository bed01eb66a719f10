#ifndef DPCONTACT_RUNS_VALIDATION_H
#define DPCONTACT_RUNS_VALIDATION_H

#include "database/contact_law.h"
#include "database/record.h"
#include "runs/settings.h"

#include <string>
#include <vector>

namespace dpcontact
{
  /// How far a contact law is from a computed history, at equal overlaps.
  struct LawErrors
  {
    // |F_law − F| over the largest force, on 200 equidistant overlaps a leg. Loading is where the
    // force is the largest so far; everything below it, reloading too, is unloading.
    double loading_rms = 0, loading_max = 0, unloading_rms = 0, unloading_max = 0;
    double residual = 0; ///< largest |δ_res,law − δ_res| of its releases, over the largest δ
    double energy_loss = 0; ///< (loss by the law − loss) over the work put in
    double restitution = 0, law_restitution = 0; ///< √(work given back / work put in)

    /// A leg's force at its end over the largest, and the mean and rms of (F_law − F) over that.
    struct Leg
    {
      double end, mean, rms;
    };
    std::vector<Leg> legs;
  };

  /// Branches of a computed history, each beginning where the one before ends.
  using Legs = std::vector<std::vector<CurvePoint>>;

  /// Drives a new contact of the pair through the overlaps of the history.
  LawErrors law_errors(const ContactPair &pair, const Legs &legs);

  /// A material and a path that no fit has seen.
  struct RandomHistory
  {
    Case                input;
    std::vector<double> turning_points; ///< N; the largest is input.scene.force_max
  };

  /// Histories drawn by a fixed seed: ν, φ and Λ within the given ranges (φ in degrees), E, σc and
  /// R over decades. Each is loaded, partly released, reloaded below the peak, released further,
  /// overloaded, released, reloaded below the peak, partly released, overloaded again and released.
  struct HistoryRanges
  {
    double nu[2], phi_deg[2], load_level[2];
  };
  std::vector<RandomHistory>
  random_histories(unsigned int count, unsigned int seed, const HistoryRanges &ranges);

  /// The row that a history's largest peak gives: its loading curve, and the release from there,
  /// which the last leg must be. @throws InputError for a history that gives no curve.
  ContactRow row_of_history(const Legs &legs, const FirstYield &yield, double radius);
} // namespace dpcontact

#endif
