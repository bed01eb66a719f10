#ifndef DPCONTACT_RUNS_STUDIES_VALIDATION_H
#define DPCONTACT_RUNS_STUDIES_VALIDATION_H

#include "database/contact_law/contact_law.h"
#include "database/rows/record.h"
#include "solver/problem/case.h"

#include <string>
#include <vector>

namespace dpcontact
{
  struct FirstYield;

  /// How far a contact law is from a computed history, at equal overlaps.
  struct LawErrors
  {
    // |F_law − F| over the largest force, on 200 equidistant overlaps a leg. Loading is where the
    // force is the largest so far; everything below it, reloading too, is unloading.
    double loading_rms = 0, loading_max = 0, unloading_rms = 0, unloading_max = 0;
    double residual = 0; ///< largest |δ_res,law − δ_res| of its releases, over the largest δ
    double energy_loss = 0; ///< (work lost by the law − work lost) over the work put in
    double restitution = 0, law_restitution = 0; ///< √(work given back / work put in)

    /// One leg of the history.
    struct Leg
    {
      double end;  ///< the force at its end over the largest force
      double mean; ///< of (F_law − F) over the largest force
      double rms;  ///< of (F_law − F) over the largest force
    };
    std::vector<Leg> legs;
  };

  /// Branches of a computed history, each beginning where the one before ends.
  using Legs = std::vector<std::vector<CurvePoint>>;

  /// Drives a new contact of the pair through the overlaps of the history, which begins without
  /// force.
  LawErrors law_errors(const ContactPair &pair, const Legs &legs);

  /// A material and a path that no fit has seen.
  struct RandomHistory
  {
    Case                input;
    std::vector<double> turning_points; ///< N; the largest is input.scene.force_max
  };

  /// From where to where the materials and peaks of random histories reach; φ in degrees.
  struct HistoryRanges
  {
    double nu[2], phi_deg[2], load_level[2];
  };

  /// Histories drawn by a fixed seed, the same on every machine: ν and φ uniform within the ranges,
  /// Λ uniform in its logarithm, and so are E from 1 to 100 GPa, σc/E from 2e-4 to 5e-3 and R from
  /// 1 mm to 1 m. Each contact is loaded, partly released, reloaded below the peak, released
  /// further, overloaded, released, reloaded below the peak, partly released, overloaded again and
  /// released.
  std::vector<RandomHistory>
  random_histories(unsigned int count, unsigned int seed, const HistoryRanges &ranges);

  /// The row that a history's largest peak gives, fitted to the loading curve and to the release
  /// from the peak, which the last leg must be. The radius (m) is that of both spheres.
  /// @throws InputError for a history that gives no curve.
  ContactRow row_of_history(const Legs &legs, const FirstYield &yield, double radius);
} // namespace dpcontact

#endif
