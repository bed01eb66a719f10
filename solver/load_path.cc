#include "solver/load_path.h"

#include "meshing/errors.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <tuple>

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
    const double scale = control != Control::force ? peak_force
                         : unloading               ? std::max(target, 0.1 * peak_force)
                                                   : target;
    system.set_control(control, target, scale);
    for (unsigned int k = 0; k <= options.max_augmentations; ++k)
      {
        report = solve_newton(system, options.newton);
        count.newton_iterations += static_cast<unsigned int>(report.iterations);
        iterations_of_point += report.iterations;
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
    report.reason    = "the augmentation of the contact did not converge: a larger penalty-stiffness helps";
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
        if (options.augment && present_force > 0)
          system.contact().augment(system.u, system.approach);

        if (level == 0 && next > level)
          system.contact().forget();

        // From no contact at all: Hertz's δ ∝ τ², and at least what lets a node touch.
        if (level == 0)
          {
            system.approach =
              system.contact().bearing_approach(system.u) + approach_guess * next * next;
            system.cover(system.contact().hertz_radius(system.approach));
          }
        else if (next > level)
          system.cover(system.reach() * next / level);

        // Predictor: the secant in the force's own parameter, where there is one.
        const double now = present_force;
        if (options.predict && has_previous && target > 0)
          {
            const double previous = last_force;
            const double ratio    = std::clamp((std::pow(target, 2. / 3) - std::pow(now, 2. / 3)) /
                                              (std::pow(now, 2. / 3) - std::pow(previous, 2. / 3)),
                                            0.,
                                            4.);
            if (previous > 0)
              {
                for (std::size_t i = 0; i < system.u.size(); ++i)
                  system.u[i] += ratio * (system.u[i] - previous_u[i]);
                system.approach += ratio * (system.approach - previous_approach);
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
            previous_u           = saved.u;
            previous_approach    = saved.approach;
            last_force           = now;
            present_force        = target;
            has_previous         = true;
            const auto integrals = system.commit();
            dissipated += 2 * integrals.dissipation;
            count.apex_points += integrals.apex_points;
            last_integrals = integrals;
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
                message << stage << " stopped at force " << now / peak_force
                        << " of the peak: " << report.reason << ", also with the step cut "
                        << options.max_cut_backs << " times";
                if (!laws::associated(system.material()))
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
    PathChecks &c  = checked;
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
    point.approach       = 2 * system.approach;
    point.force          = system.force();
    point.contact_radius = system.contact().edge_radius(system.u, system.approach);
    point.pressure_max   = 0;
    for (const auto &[r, p] : profile)
      point.pressure_max = std::max(point.pressure_max, p);
    point.plastic_volume     = last_integrals.plastic_volume;
    point.plastic_strain_max = last_integrals.plastic_strain_max;
    point.dissipated_energy  = dissipated;
    point.mises_stress_max   = last_integrals.mises_stress_max;
    point.newton_iterations  = iterations_of_point;
    iterations_of_point      = 0;
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
  std::vector<CurvePoint> LoadPath<dim>::load(const double     peak,
                                              const double     peak_approach_guess,
                                              const NextLevel &next_level,
                                              const std::function<void(double)> &at_level)
  {
    peak_force     = peak;
    present_force  = 0;
    unloading      = false;
    approach_guess = peak_approach_guess;
    has_previous   = false;
    system.contact().set_active(true);
    CurvePoint origin;
    origin.approach           = 2 * system.contact().touching_approach(system.u);
    origin.plastic_volume     = last_integrals.plastic_volume;
    origin.plastic_strain_max = last_integrals.plastic_strain_max;
    origin.dissipated_energy  = dissipated;
    origin.mises_stress_max   = last_integrals.mises_stress_max;
    origin.force = origin.contact_radius = origin.pressure_max = 0;
    std::vector<CurvePoint> points{origin};

    const auto force_of = [peak](const double tau) { return peak * tau * tau * tau; };
    for (double level = 0; level < 1;)
      {
        const double next = next_level(level, points.back());
        advance("loading", force_of, level, next);
        level = next;
        points.push_back(record());
        if (observer)
          observer("loading", level, points.back().newton_iterations);
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
  std::vector<CurvePoint> LoadPath<dim>::unload(const unsigned int steps)
  {
    std::vector<CurvePoint> points{record()};
    unloading             = true;
    has_previous          = false; // the tangent at the peak is another one now
    const double peak     = system.force();
    const auto   force_of = [peak](const double t) { return peak * std::pow(t, 1.5); };
    const double n        = steps;
    for (unsigned int i = 0; i < steps; ++i)
      {
        advance("unloading", force_of, 1 - i / n, i + 1 == steps ? 0. : 1 - (i + 1) / n);
        if (i + 1 < steps)
          points.push_back(record());
        if (observer)
          observer("unloading", (i + 1) / n, points.back().newton_iterations);
      }
    CurvePoint released     = record();
    released.approach       = 2 * system.contact().touching_approach(system.u);
    released.force          = 0;
    released.contact_radius = 0;
    released.pressure_max   = 0;
    points.push_back(released);
    return points;
  }

  template <int dim>
  std::vector<CurvePoint> LoadPath<dim>::unload_and_return(const unsigned int steps)
  {
    const auto   state   = system.snapshot();
    const auto   before  = std::make_tuple(previous_u,
                                        previous_approach,
                                        has_previous,
                                        present_force,
                                        last_force,
                                        last_integrals,
                                        dissipated,
                                        checked,
                                        peak_force);
    const double force   = system.force();
    peak_force           = force;
    const auto points    = unload(steps);
    std::tie(previous_u,
             previous_approach,
             has_previous,
             present_force,
             last_force,
             last_integrals,
             dissipated,
             checked,
             peak_force) = before;
    unloading            = false;
    system.restore(state);
    system.set_control(Control::force, force, peak_force);
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
    peak_force   = std::max(peak_force, force);
    unloading    = true;  // residual stresses stay
    has_previous = false; // the tangent turns where the path does
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
