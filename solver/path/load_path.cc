#include "solver/path/load_path.h"

#include "meshing/errors.h"
#include "solver/path/sub_steps.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace dpcontact
{
  template <int dim>
  LoadPath<dim>::LoadPath(ContactSystem<dim> &system_,
                          const Options      &options_,
                          const StepObserver &observer_)
    : system(system_)
    , options(options_)
    , observer(observer_)
  {}

  template <int dim>
  bool LoadPath<dim>::try_step(const Control control, const double target)
  {
    // While unloading the residual stresses stay, whose rounding the load itself does not measure.
    const double scale = control != Control::force ? status.peak_force
                         : status.unloading        ? std::max(target, 0.1 * status.peak_force)
                                                   : target;
    system.set_control(control, target, scale);
    for (unsigned int k = 0; k <= options.max_augmentations; ++k)
      {
        report = solve_newton(system, options.newton);
        count.newton_iterations += static_cast<unsigned int>(report.iterations);
        status.iterations_of_point += report.iterations;
        if (!report.converged)
          return false;
        if (!options.augment || control == Control::released ||
            system.contact_contribution().max_violation <=
              options.penetration_tolerance * std::abs(system.unknowns().approach))
          return true;
        system.contact().augment(system.unknowns());
        ++count.augmentations;
      }
    report.converged = false;
    report.reason =
      "the augmentation of the contact did not converge: a larger penalty-stiffness helps";
    return false;
  }

  template <int dim>
  void LoadPath<dim>::prepare_contact(const double level, const double next)
  {
    // What the last step left to the penalty becomes multiplier.
    if (options.augment && status.present_force > 0)
      system.contact().augment(system.unknowns());

    // From no contact at all: Hertz's δ ∝ τ², and at least what lets a node touch.
    if (level == 0)
      {
        if (next > level)
          system.contact().forget();
        Unknowns &unknowns = system.unknowns();
        unknowns.approach =
          system.contact().bearing_approach(unknowns.u) + status.approach_guess * next * next;
        system.cover(system.contact().hertz_radius(unknowns.approach));
      }
    else if (next > level)
      system.cover(system.reach() * next / level);
  }

  template <int dim>
  void LoadPath<dim>::predict(const double target)
  {
    const double now = status.present_force, before = status.last_force;
    if (!options.predict || !status.has_previous || !(target > 0 && before > 0))
      return;
    const double ratio    = std::clamp((std::pow(target, 2. / 3) - std::pow(now, 2. / 3)) /
                                      (std::pow(now, 2. / 3) - std::pow(before, 2. / 3)),
                                    0.,
                                    4.);
    Unknowns    &unknowns = system.unknowns();
    for (std::size_t i = 0; i < unknowns.u.size(); ++i)
      unknowns.u[i] += ratio * (unknowns.u[i] - status.previous.u[i]);
    unknowns.approach += ratio * (unknowns.approach - status.previous.approach);
  }

  template <int dim>
  void LoadPath<dim>::accept(const typename ContactSystem<dim>::Snapshot &before,
                             const double                                 target)
  {
    status.previous      = before.unknowns;
    status.last_force    = status.present_force;
    status.present_force = target;
    status.has_previous  = true;
    const auto integrals = system.commit();
    status.dissipated += options.symmetry_factor * integrals.dissipation;
    count.apex_points += integrals.apex_points;
    status.last_integrals = integrals;
    check(integrals);
    ++count.steps;
  }

  template <int dim>
  std::string LoadPath<dim>::failure(const char *stage) const
  {
    std::ostringstream message;
    message << stage << " stopped at force " << status.present_force / status.peak_force
            << " of the peak: " << report.reason << ", also with the step cut "
            << options.max_cut_backs << " times";
    if (std::any_of(system.materials().begin(), system.materials().end(), [](const laws::Law &law) {
          return !laws::associated(law);
        }))
      message << "; where flow dilates less than the friction angle a stable "
                 "equilibrium need not exist: a larger dilation angle, hardening or a "
                 "smaller peak force helps";
    return message.str();
  }

  template <int dim>
  std::string LoadPath<dim>::failure_log() const
  {
    std::ostringstream text;
    text << "residuals";
    for (const double r : report.residuals)
      text << ' ' << r;
    return text.str();
  }

  template <int dim>
  void LoadPath<dim>::advance(const char                          *stage,
                              const std::function<double(double)> &force_of,
                              const double                         from,
                              const double                         to)
  {
    SubSteps steps(from, to);
    while (!steps.done())
      {
        const double next = steps.next(), target = force_of(next);
        const auto   before = system.snapshot();
        prepare_contact(steps.level, next);
        predict(target);
        const bool converged = try_step(target > 0 ? Control::force : Control::released, target);
        if (converged && system.complete())
          {
            accept(before, target);
            steps.reach(next, report.iterations <= 6);
            continue;
          }
        system.restore(before);
        if (converged)
          system.grow();
        else
          {
            ++count.cut_backs;
            if (steps.halvings == options.max_cut_backs)
              throw SolverError(failure(stage), failure_log());
            steps.halve();
          }
      }
  }

  template <int dim>
  void LoadPath<dim>::check(const StepIntegrals &integrals)
  {
    PathChecks &c  = status.checked;
    c.residual     = std::max(c.residual, report.residuals.back());
    c.yield_excess = std::max(c.yield_excess, integrals.largest_yield_excess);
    if (system.contact_contribution().active > 0)
      c.penetration = std::max(c.penetration,
                               system.contact_contribution().max_violation /
                                 std::abs(system.unknowns().approach));
    c.work += integrals.work;
    c.largest_work   = std::max(c.largest_work, c.work);
    c.elastic_energy = integrals.elastic_energy;
    c.dissipation += integrals.dissipation;
    c.mean_dissipation += integrals.mean_dissipation;
    c.energy_error =
      std::max(c.energy_error, std::abs(c.work - c.elastic_energy - c.mean_dissipation));
  }

  template <int dim>
  CurvePoint LoadPath<dim>::record()
  {
    const auto pressures = system.contact().face_pressures(system.unknowns());
    CurvePoint point;
    point.approach       = options.symmetry_factor * system.unknowns().approach;
    point.force          = system.force();
    point.contact_radius = system.contact().edge_radius(system.unknowns());
    point.pressure_max   = 0;
    for (const auto &[r, p] : pressures)
      point.pressure_max = std::max(point.pressure_max, p);
    point.plastic_volume       = status.last_integrals.plastic_volume;
    point.plastic_strain_max   = status.last_integrals.plastic_strain_max;
    point.dissipated_energy    = status.dissipated;
    point.mises_stress_max     = status.last_integrals.mises_stress_max;
    point.newton_iterations    = status.iterations_of_point;
    status.iterations_of_point = 0;
    return point;
  }

  template <int dim>
  std::vector<CurvePoint> LoadPath<dim>::load(const double peak, const double peak_approach_guess)
  {
    const double n = options.loading_steps;
    return load(peak, peak_approach_guess, [n](const double level, const CurvePoint &) {
      return (std::round(level * n) + 1) / n;
    });
  }

  template <int dim>
  std::vector<CurvePoint> LoadPath<dim>::start_loading(const double peak,
                                                       const double peak_approach_guess)
  {
    status.peak_force     = peak;
    status.present_force  = 0;
    status.unloading      = false;
    status.approach_guess = peak_approach_guess;
    status.has_previous   = false;
    system.contact().set_active(true);
    CurvePoint origin;
    origin.approach =
      options.symmetry_factor * system.contact().touching_approach(system.unknowns().u);
    origin.plastic_volume     = status.last_integrals.plastic_volume;
    origin.plastic_strain_max = status.last_integrals.plastic_strain_max;
    origin.dissipated_energy  = status.dissipated;
    origin.mises_stress_max   = status.last_integrals.mises_stress_max;
    origin.force = origin.contact_radius = origin.pressure_max = 0;
    return {origin};
  }

  template <int dim>
  void
  LoadPath<dim>::load_step(const double level, const double next, std::vector<CurvePoint> &points)
  {
    const double peak = status.peak_force;
    advance(
      "loading", [peak](const double tau) { return peak * tau * tau * tau; }, level, next);
    points.push_back(record());
    if (observer)
      observer("loading", next, points.back().newton_iterations);
  }

  template <int dim>
  std::vector<CurvePoint> LoadPath<dim>::load(const double     peak,
                                              const double     peak_approach_guess,
                                              const NextLevel &next_level,
                                              const std::function<void(double)> &at_level)
  {
    std::vector<CurvePoint> points = start_loading(peak, peak_approach_guess);
    for (double level = 0; level < 1;)
      {
        const double next = next_level(level, points.back());
        load_step(level, next, points);
        level = next;
        if (at_level)
          at_level(level);
      }
    return points;
  }

  template <int dim>
  std::vector<CurvePoint> LoadPath<dim>::unload()
  {
    return unload(options.unloading_steps);
  }

  template <int dim>
  std::vector<CurvePoint> LoadPath<dim>::start_unloading()
  {
    std::vector<CurvePoint> points{record()};
    status.unloading      = true;
    status.has_previous   = false; // the tangent at the peak is another one now
    status.unloading_from = system.force();
    return points;
  }

  template <int dim>
  void LoadPath<dim>::unload_step(const unsigned int       i,
                                  const unsigned int       steps,
                                  std::vector<CurvePoint> &points)
  {
    const double n    = steps;
    const double from = status.unloading_from;
    const bool   last = i + 1 == steps;
    advance(
      "unloading",
      [from](const double t) { return from * std::pow(t, 1.5); },
      1 - i / n,
      last ? 0. : 1 - (i + 1) / n);
    points.push_back(record());
    if (observer)
      observer("unloading", (i + 1) / n, points.back().newton_iterations);
    if (last)
      {
        points.back().approach =
          options.symmetry_factor * system.contact().touching_approach(system.unknowns().u);
        points.back().force          = 0;
        points.back().contact_radius = 0;
        points.back().pressure_max   = 0;
      }
  }

  template <int dim>
  std::vector<CurvePoint> LoadPath<dim>::unload(const unsigned int steps)
  {
    std::vector<CurvePoint> points = start_unloading();
    for (unsigned int i = 0; i < steps; ++i)
      unload_step(i, steps, points);
    return points;
  }

  template <int dim>
  void LoadPath<dim>::run(const double                                 peak,
                          const double                                 peak_approach_guess,
                          Progress                                    &progress,
                          const std::function<void(const Progress &)> &keep,
                          const std::function<void()>                 &at_peak)
  {
    if (progress.loading.empty())
      progress.loading = start_loading(peak, peak_approach_guess);
    const double n = options.loading_steps;
    while (progress.loading.size() <= options.loading_steps)
      {
        const double done = static_cast<double>(progress.loading.size() - 1);
        load_step(done / n, (done + 1) / n, progress.loading);
        // Who goes on from the peak would not know what flowed there: its step is made again.
        if (keep && progress.loading.size() <= options.loading_steps)
          keep(progress);
      }
    if (!progress.unloading)
      {
        if (at_peak)
          at_peak();
        progress.unloaded  = start_unloading();
        progress.unloading = true;
      }
    while (progress.unloaded.size() <= options.unloading_steps)
      {
        unload_step(static_cast<unsigned int>(progress.unloaded.size() - 1),
                    options.unloading_steps,
                    progress.unloaded);
        if (keep && progress.unloaded.size() <= options.unloading_steps)
          keep(progress);
      }
  }

  template <int dim>
  std::vector<CurvePoint> LoadPath<dim>::unload_and_return(const unsigned int steps)
  {
    const auto   system_before = system.snapshot();
    const Status before        = status;
    const double force         = system.force();
    status.peak_force          = force;
    const auto points          = unload(steps);
    status                     = before;
    status.iterations_of_point = 0;
    status.unloading           = false;
    system.restore(system_before);
    system.set_control(Control::force, force, status.peak_force);
    system.residual();
    return points;
  }

  template <int dim>
  std::vector<CurvePoint> LoadPath<dim>::to_force(const double force, const unsigned int steps)
  {
    std::vector<CurvePoint> points{record()};
    const double            present = system.force();
    const double            most    = std::max(force, present);
    const double            power   = force > present ? 3 : 1.5;
    const auto   force_of = [&](const double level) { return most * std::pow(level, power); };
    const double from = std::pow(present / most, 1 / power), to = std::pow(force / most, 1 / power);
    status.peak_force   = std::max(status.peak_force, force);
    status.unloading    = true;  // residual stresses stay
    status.has_previous = false; // the tangent turns where the path does
    for (unsigned int i = 1; i <= steps; ++i)
      {
        const auto level = [&](const unsigned int k) { return from + (to - from) * k / steps; };
        advance(force > present ? "reloading" : "unloading", force_of, level(i - 1), level(i));
        points.push_back(record());
        if (observer)
          observer("history", static_cast<double>(i) / steps, points.back().newton_iterations);
      }
    return points;
  }

  template class LoadPath<2>;
  template class LoadPath<3>;
} // namespace dpcontact
