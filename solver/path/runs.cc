#include "solver/path/runs.h"

#include <cmath>
#include <string>
#include <utility>

namespace dpcontact
{
  template <int dim>
  std::vector<CurvePoint> run_to_peak(ContactModel<dim>  &model,
                                      const unsigned int  loading_steps,
                                      const StepObserver &observer)
  {
    LoadPath<dim>           path = model.start_path(loading_steps, observer);
    std::vector<CurvePoint> points =
      path.load(model.peak_force(), model.hertz_approach(model.scene().force_max));
    model.end_path(path);
    model.units().curve_scale().apply(points);
    return points;
  }

  namespace
  {
    std::string name_of_run(const unsigned int loading_steps)
    {
      return "run of " + std::to_string(loading_steps) + " ";
    }

    /// Takes over a run that had ended before what was kept. @return whether there is one.
    template <int dim>
    bool take_finished(const unsigned int loading_steps,
                       KeptRuns          &kept,
                       ContactModel<dim> &model,
                       Curve             &curve)
    {
      const std::string name  = name_of_run(loading_steps);
      const Arrays     &found = kept.checkpoint.found;
      if (found.find(name + "loading") == found.end())
        return false;
      for (const char *const part : {"loading", "unloading", "cut-backs"})
        kept.finished[name + part] = found.at(name + part);
      model.end_known_path(static_cast<unsigned int>(kept.finished[name + "cut-backs"].front()));
      curve = {points_of(kept.finished[name + "loading"]),
               points_of(kept.finished[name + "unloading"])};
      return true;
    }

    /// Where a path of that many steps goes on from.
    template <int dim>
    typename LoadPath<dim>::Progress
    take_up(const Arrays &found, const unsigned int loading_steps, LoadPath<dim> &path)
    {
      typename LoadPath<dim>::Progress progress;
      const auto                       steps = found.find("steps");
      if (steps != found.end() && steps->second.front() == loading_steps)
        {
          path.restore(found);
          progress.loading   = points_of(found.at("loading"));
          progress.unloaded  = points_of(found.at("unloading"));
          progress.unloading = !progress.unloaded.empty();
        }
      return progress;
    }

    void finish(const Curve       &curve,
                const unsigned int loading_steps,
                const unsigned int cut_backs,
                KeptRuns          &kept)
    {
      const std::string name            = name_of_run(loading_steps);
      kept.finished[name + "loading"]   = numbers_of(curve.loading);
      kept.finished[name + "unloading"] = numbers_of(curve.unloading);
      kept.finished[name + "cut-backs"] = {static_cast<double>(cut_backs)};
    }
  } // namespace

  template <int dim>
  Curve run_cycle(ContactModel<dim>  &model,
                  const unsigned int  loading_steps,
                  const StepObserver &observer,
                  const CycleEvents  &events,
                  KeptRuns           *kept)
  {
    using Progress = typename LoadPath<dim>::Progress;
    Curve curve;
    if (kept && take_finished(loading_steps, *kept, model, curve))
      return curve;

    LoadPath<dim> path = model.start_path(loading_steps, observer);
    Progress progress  = kept ? take_up(kept->checkpoint.found, loading_steps, path) : Progress();
    std::function<void(const Progress &)> keep;
    if (kept && kept->checkpoint.keep)
      keep = [&](const Progress &reached) {
        Arrays all       = kept->finished;
        all["steps"]     = {static_cast<double>(loading_steps)};
        all["loading"]   = numbers_of(reached.loading);
        all["unloading"] = numbers_of(reached.unloaded);
        all.merge(path.save());
        kept->checkpoint.keep(all);
      };
    path.run(model.peak_force(),
             model.hertz_approach(model.scene().force_max),
             progress,
             keep,
             events.at_peak);
    if (events.at_end)
      events.at_end();
    model.end_path(path);
    curve = {progress.loading, progress.unloaded};
    model.units().curve_scale().apply(curve);
    if (kept)
      finish(curve, loading_steps, model.counters().cut_backs, *kept);
    return curve;
  }

  template <int dim>
  std::vector<Curve> run_cycles(ContactModel<dim>         &model,
                                const unsigned int         loading_steps,
                                const std::vector<double> &forces,
                                const StepObserver        &observer)
  {
    LoadPath<dim>      path = model.start_path(loading_steps, observer);
    std::vector<Curve> cycles;
    for (const double force : forces)
      {
        Curve curve;
        curve.loading   = path.load(force / model.units().force(), model.hertz_approach(force));
        curve.unloading = path.unload();
        model.units().curve_scale().apply(curve);
        cycles.push_back(std::move(curve));
      }
    model.end_path(path);
    return cycles;
  }

  template <int dim>
  std::vector<std::vector<CurvePoint>>
  run_history(ContactModel<dim> &model, const std::vector<Leg> &legs, const StepObserver &observer)
  {
    LoadPath<dim>                        path    = model.start_path(1, observer);
    double                               present = 0;
    std::vector<std::vector<CurvePoint>> result;
    for (const Leg &leg : legs)
      {
        const double force = leg.force / model.units().force(), steps = leg.steps;
        if (present == 0)
          result.push_back(
            path.load(force, model.hertz_approach(leg.force), [steps](double level, const auto &) {
              return (std::round(level * steps) + 1) / steps;
            }));
        else if (force == 0)
          result.push_back(path.unload(leg.steps));
        else
          result.push_back(path.to_force(force, leg.steps));
        present = force;
      }
    model.end_path(path);
    for (auto &leg : result)
      model.units().curve_scale().apply(leg);
    return result;
  }

  template <int dim>
  UnloadedAtStops run_with_stops(ContactModel<dim>    &model,
                                 const UnloadingStops &stops,
                                 const StepObserver   &observer)
  {
    UnloadedAtStops  run;
    const CurveScale scale    = model.units().curve_scale();
    LoadPath<dim>    path     = model.start_path(1, observer);
    std::size_t      stop     = 0;
    const auto       at_level = [&](const double level) {
      run.levels.push_back(level);
      while (stop < stops.stops.size() && level >= stops.stops[stop] * (1 - 1e-12))
        {
          UnloadedAtStops::Stop at;
          at.loading_points = run.levels.size() + 1;
          at.profile        = pressure_profile(model.system(), model.units());
          at.unloading      = path.unload_and_return(stops.unloading_steps(stop));
          scale.apply(at.unloading);
          run.stops.push_back(std::move(at));
          ++stop;
        }
    };
    const double guess = model.hertz_approach(model.scene().force_max);
    run.loading        = path.load(
      model.peak_force(),
      guess,
      [&](const double level, const CurvePoint &present) {
        return stops.next(
          level,
          level > 0 ? present.approach / (model.symmetry_factor() * guess * level * level) : 1.,
          stop < stops.stops.size() ? stops.stops[stop] : 1.);
      },
      at_level);
    model.end_path(path);
    scale.apply(run.loading);
    return run;
  }

  template std::vector<CurvePoint>
  run_to_peak(ContactModel<2> &, unsigned int, const StepObserver &);
  template Curve
  run_cycle(ContactModel<2> &, unsigned int, const StepObserver &, const CycleEvents &, KeptRuns *);
  template std::vector<Curve>
  run_cycles(ContactModel<2> &, unsigned int, const std::vector<double> &, const StepObserver &);
  template std::vector<std::vector<CurvePoint>>
  run_history(ContactModel<2> &, const std::vector<Leg> &, const StepObserver &);
  template UnloadedAtStops
  run_with_stops(ContactModel<2> &, const UnloadingStops &, const StepObserver &);
  template std::vector<CurvePoint>
  run_to_peak(ContactModel<3> &, unsigned int, const StepObserver &);
  template Curve
  run_cycle(ContactModel<3> &, unsigned int, const StepObserver &, const CycleEvents &, KeptRuns *);
  template std::vector<Curve>
  run_cycles(ContactModel<3> &, unsigned int, const std::vector<double> &, const StepObserver &);
  template std::vector<std::vector<CurvePoint>>
  run_history(ContactModel<3> &, const std::vector<Leg> &, const StepObserver &);
  template UnloadedAtStops
  run_with_stops(ContactModel<3> &, const UnloadingStops &, const StepObserver &);
} // namespace dpcontact
