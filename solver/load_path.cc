#include "solver/load_path.h"

#include "meshing/errors.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <type_traits>

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
    const double scale = control != Control::force ? state.peak_force
                         : state.unloading         ? std::max(target, 0.1 * state.peak_force)
                                                   : target;
    system.set_control(control, target, scale);
    for (unsigned int k = 0; k <= options.max_augmentations; ++k)
      {
        report = solve_newton(system, options.newton);
        count.newton_iterations += static_cast<unsigned int>(report.iterations);
        state.iterations_of_point += report.iterations;
        if (!report.converged)
          return false;
        if (!options.augment || control == Control::released ||
            system.contact_state().max_violation <=
              options.penetration_tolerance * std::abs(system.approach))
          return true;
        system.contact().augment(system.u, system.approach);
        ++count.augmentations;
      }
    report.converged = false;
    report.reason =
      "the augmentation of the contact did not converge: a larger penalty-stiffness helps";
    return false;
  }

  template <int dim>
  void LoadPath<dim>::advance(const char                          *stage,
                              const std::function<double(double)> &force_of,
                              const double                         from,
                              const double                         to)
  {
    double       level = from, step = to - from;
    unsigned int halvings = 0;
    while (level != to)
      {
        if (std::abs(step) > std::abs(to - level) * (1 - 1e-9))
          step = to - level;
        const double next   = std::abs(to - level - step) < 1e-12 ? to : level + step;
        const double target = force_of(next);
        const auto   saved  = system.snapshot();

        // What the last step left to the penalty becomes multiplier.
        if (options.augment && state.present_force > 0)
          system.contact().augment(system.u, system.approach);

        if (level == 0 && next > level)
          system.contact().forget();

        // From no contact at all: Hertz's δ ∝ τ², and at least what lets a node touch.
        if (level == 0)
          {
            system.approach =
              system.contact().bearing_approach(system.u) + state.approach_guess * next * next;
            system.cover(system.contact().hertz_radius(system.approach));
          }
        else if (next > level)
          system.cover(system.reach() * next / level);

        // Predictor: the secant in the force's own parameter, where there is one.
        const double now = state.present_force;
        if (options.predict && state.has_previous && target > 0)
          {
            const double previous = state.last_force;
            const double ratio    = std::clamp((std::pow(target, 2. / 3) - std::pow(now, 2. / 3)) /
                                              (std::pow(now, 2. / 3) - std::pow(previous, 2. / 3)),
                                            0.,
                                            4.);
            if (previous > 0)
              {
                for (std::size_t i = 0; i < system.u.size(); ++i)
                  system.u[i] += ratio * (system.u[i] - state.previous_u[i]);
                system.approach += ratio * (system.approach - state.previous_approach);
              }
          }

        const bool converged = try_step(target > 0 ? Control::force : Control::released, target);
        if (converged && !system.complete())
          {
            system.restore(saved);
            system.grow();
            continue;
          }
        if (converged)
          {
            state.previous_u        = saved.u;
            state.previous_approach = saved.approach;
            state.last_force        = now;
            state.present_force     = target;
            state.has_previous      = true;
            const auto integrals    = system.commit();
            state.dissipated += options.symmetry_factor * integrals.dissipation;
            count.apex_points += integrals.apex_points;
            state.last_integrals = integrals;
            check(integrals);
            ++count.steps;
            level = next;
            if (halvings > 0 && report.iterations <= 6)
              {
                --halvings;
                step *= 2;
              }
          }
        else
          {
            system.restore(saved);
            ++count.cut_backs;
            if (++halvings > options.max_cut_backs)
              {
                std::ostringstream message;
                message << stage << " stopped at force " << now / state.peak_force
                        << " of the peak: " << report.reason << ", also with the step cut "
                        << options.max_cut_backs << " times";
                if (std::any_of(system.materials().begin(),
                                system.materials().end(),
                                [](const laws::Law &law) { return !laws::associated(law); }))
                  message << "; where flow dilates less than the friction angle a stable "
                             "equilibrium need not exist: a larger dilation angle, hardening or a "
                             "smaller peak force helps";
                message << "; residuals";
                for (const double r : report.residuals)
                  message << ' ' << r;
                throw SolverError(message.str());
              }
            step /= 2;
          }
      }
    (void)stage;
  }

  template <int dim>
  void LoadPath<dim>::check(const typename ContactSystem<dim>::Integrals &integrals)
  {
    PathChecks &c  = state.checked;
    c.residual     = std::max(c.residual, report.residuals.back());
    c.yield_excess = std::max(c.yield_excess, integrals.largest_yield_excess);
    if (system.contact_state().active > 0)
      c.penetration =
        std::max(c.penetration, system.contact_state().max_violation / std::abs(system.approach));
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
    const auto profile = system.contact().profile(system.u, system.approach);
    CurvePoint point;
    point.approach       = options.symmetry_factor * system.approach;
    point.force          = system.force();
    point.contact_radius = system.contact().edge_radius(system.u, system.approach);
    point.pressure_max   = 0;
    for (const auto &[r, p] : profile)
      point.pressure_max = std::max(point.pressure_max, p);
    point.plastic_volume      = state.last_integrals.plastic_volume;
    point.plastic_strain_max  = state.last_integrals.plastic_strain_max;
    point.dissipated_energy   = state.dissipated;
    point.mises_stress_max    = state.last_integrals.mises_stress_max;
    point.newton_iterations   = state.iterations_of_point;
    state.iterations_of_point = 0;
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
    state.peak_force     = peak;
    state.present_force  = 0;
    state.unloading      = false;
    state.approach_guess = peak_approach_guess;
    state.has_previous   = false;
    system.contact().set_active(true);
    CurvePoint origin;
    origin.approach       = options.symmetry_factor * system.contact().touching_approach(system.u);
    origin.plastic_volume = state.last_integrals.plastic_volume;
    origin.plastic_strain_max = state.last_integrals.plastic_strain_max;
    origin.dissipated_energy  = state.dissipated;
    origin.mises_stress_max   = state.last_integrals.mises_stress_max;
    origin.force = origin.contact_radius = origin.pressure_max = 0;
    return {origin};
  }

  template <int dim>
  void
  LoadPath<dim>::load_step(const double level, const double next, std::vector<CurvePoint> &points)
  {
    const double peak = state.peak_force;
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
    state.unloading      = true;
    state.has_previous   = false; // the tangent at the peak is another one now
    state.unloading_from = system.force();
    return points;
  }

  template <int dim>
  void LoadPath<dim>::unload_step(const unsigned int       i,
                                  const unsigned int       steps,
                                  std::vector<CurvePoint> &points)
  {
    const double n    = steps;
    const double from = state.unloading_from;
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
          options.symmetry_factor * system.contact().touching_approach(system.u);
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
    const State  before        = state;
    const double force         = system.force();
    state.peak_force           = force;
    const auto points          = unload(steps);
    state                      = before;
    state.iterations_of_point  = 0;
    state.unloading            = false;
    system.restore(system_before);
    system.set_control(Control::force, force, state.peak_force);
    system.residual();
    return points;
  }

  namespace
  {
    /// All numbers of a path's state, in one order: `visit(double &)`, `visit(int &)`, …
    template <class State, class Visit>
    void visit_numbers(State &state, const Visit &visit)
    {
      for (auto *const number : {&state.peak_force,
                                 &state.unloading_from,
                                 &state.approach_guess,
                                 &state.dissipated,
                                 &state.present_force,
                                 &state.last_force,
                                 &state.previous_approach})
        visit(*number);
      auto &integrals = state.last_integrals;
      for (auto *const number : {&integrals.plastic_volume,
                                 &integrals.dissipation,
                                 &integrals.mean_dissipation,
                                 &integrals.work,
                                 &integrals.elastic_energy,
                                 &integrals.mises_stress_max,
                                 &integrals.plastic_strain_max,
                                 &integrals.largest_yield_excess})
        visit(*number);
      auto &checked = state.checked;
      for (auto *const number : {&checked.residual,
                                 &checked.yield_excess,
                                 &checked.penetration,
                                 &checked.work,
                                 &checked.largest_work,
                                 &checked.elastic_energy,
                                 &checked.dissipation,
                                 &checked.mean_dissipation,
                                 &checked.energy_error})
        visit(*number);
      visit(state.unloading);
      visit(state.iterations_of_point);
      visit(integrals.apex_points);
      visit(state.has_previous);
    }

    template <class Counters, class Visit>
    void visit_counters(Counters &counters, const Visit &visit)
    {
      for (auto *const number : {&counters.steps,
                                 &counters.newton_iterations,
                                 &counters.cut_backs,
                                 &counters.augmentations,
                                 &counters.apex_points})
        visit(*number);
    }
  } // namespace

  template <int dim>
  Arrays LoadPath<dim>::save() const
  {
    Arrays saved       = system.save();
    saved["previous"]  = state.previous_u;
    auto      &numbers = saved["path"];
    const auto keep    = [&numbers](const auto &number) {
      numbers.push_back(static_cast<double>(number));
    };
    visit_numbers(state, keep);
    visit_counters(count, keep);
    return saved;
  }

  template <int dim>
  void LoadPath<dim>::restore(const Arrays &saved)
  {
    system.restore(saved);
    state.previous_u          = array(saved, "previous", {0, system.u.size()});
    std::size_t total         = 0;
    const auto  count_numbers = [&total](const auto &) { ++total; };
    visit_numbers(state, count_numbers);
    visit_counters(count, count_numbers);
    const auto &numbers = array(saved, "path", {total});
    std::size_t next    = 0;
    const auto  take    = [&](auto &number) {
      number = static_cast<std::decay_t<decltype(number)>>(numbers[next++]);
    };
    visit_numbers(state, take);
    visit_counters(count, take);
    system.contact().set_active(true);
    if (state.present_force > 0)
      {
        system.set_control(Control::force, state.present_force, state.peak_force);
        system.residual();
      }
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
    state.peak_force   = std::max(state.peak_force, force);
    state.unloading    = true;  // residual stresses stay
    state.has_previous = false; // the tangent turns where the path does
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
