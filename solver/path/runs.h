#ifndef DPCONTACT_SOLVER_PATH_RUNS_H
#define DPCONTACT_SOLVER_PATH_RUNS_H

#include "solver/output/pressure_profile.h"
#include "solver/path/contact_model.h"
#include "solver/path/step_observer.h"
#include "solver/problem/curve.h"
#include "solver/system/checkpoint.h"

#include <functional>
#include <vector>

namespace dpcontact
{
  // The ways to drive a model, each from the virgin state, with results in SI units. They throw
  // SolverError with the reason where a path ends early.

  /// The loading branch alone, in `loading_steps` steps.
  template <int dim>
  std::vector<CurvePoint> run_to_peak(ContactModel<dim>  &model,
                                      unsigned int        loading_steps,
                                      const StepObserver &observer = {});

  /// What is called on the way of run_cycle(); either may be empty.
  struct CycleEvents
  {
    std::function<void()> at_peak; ///< before the first step down
    std::function<void()> at_end;  ///< after release
  };

  /// Several runs of one model that are kept after every step, and taken up again.
  struct KeptRuns
  {
    Checkpoint checkpoint;
    Arrays     finished; ///< curves and cut-backs of the runs that have ended
  };

  /// The whole path, with `loading_steps` steps up and half as many down.
  /// @param kept where it names a run of that many steps that has ended, its curve is returned;
  /// where it holds the state of such a run, that goes on.
  template <int dim>
  Curve run_cycle(ContactModel<dim>  &model,
                  unsigned int        loading_steps,
                  const StepObserver &observer = {},
                  const CycleEvents  &events   = {},
                  KeptRuns           *kept     = nullptr);

  /// Cycles of loading, to each of the forces (N) in turn, and release.
  template <int dim>
  std::vector<Curve> run_cycles(ContactModel<dim>         &model,
                                unsigned int               loading_steps,
                                const std::vector<double> &forces,
                                const StepObserver        &observer = {});

  /// One leg of a history of forces: from where the last one ended to `force` (N; 0 releases).
  struct Leg
  {
    double       force;
    unsigned int steps;
  };

  /// The legs of a history; each begins with the last point of the one before. After a release the
  /// next one loads anew.
  template <int dim>
  std::vector<std::vector<CurvePoint>> run_history(ContactModel<dim>      &model,
                                                   const std::vector<Leg> &legs,
                                                   const StepObserver     &observer = {});

  /// Where a loading branch stops, to unload from there and to go on loading as if it had not.
  struct UnloadingStops
  {
    std::vector<double> stops; ///< (F/F_max)^⅓ where to unload, ascending; the last is 1
    std::function<unsigned int(std::size_t stop)> unloading_steps;
    /// The next level after `level`, at most the next stop. `approach_ratio`: δ over Hertz's at
    /// `level`.
    std::function<double(double level, double approach_ratio, double stop)> next;
  };

  /// A loading branch and the unloading branches that leave it.
  struct UnloadedAtStops
  {
    struct Stop
    {
      std::size_t                loading_points; ///< of the loading branch up to this stop
      std::vector<CurvePoint>    unloading;
      std::vector<PressurePoint> profile;
    };
    std::vector<double>     levels; ///< of the loading branch's points, without the origin
    std::vector<CurvePoint> loading;
    std::vector<Stop>       stops;
  };

  template <int dim>
  UnloadedAtStops run_with_stops(ContactModel<dim>    &model,
                                 const UnloadingStops &stops,
                                 const StepObserver   &observer = {});
} // namespace dpcontact

#endif
