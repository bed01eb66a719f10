#include "solver/families.h"

#include "meshing/errors.h"
#include "solver/contact_model.h"
#include "solver/elastic_solution.h"
#include "solver/hertz.h"
#include "solver/pilot.h"
#include "solver/step_extrapolation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

namespace dpcontact
{
  namespace
  {
    /// One mesh serves contact radii within a factor of two, and load levels within this ratio: the
    /// contact radius grows like F^⅓ to F^½.
    constexpr double least_load_ratio = 1. / 6;

    /// Excess of the approach over Hertz's at a path's first stop, about, as a share of that at its
    /// last.
    constexpr double share_at_first_stop = 0.7;

    /// Largest step of ln τ, τ = (F/F_max)^⅓, of the coarse path where the approach is `ratio`
    /// times Hertz's. What the step leaves after extrapolation grows with that excess and with the
    /// step.
    double step_size(const double ratio)
    {
      return std::clamp(0.006 / std::max(ratio - 1, 1e-9), 1. / 64, 1. / 14);
    }

    /// Scales of a member over those of the member that was computed.
    struct Scales
    {
      double force, approach, length, stress;

      Scales(const FirstYield &of, const FirstYield &over)
        : force(of.force / over.force)
        , approach(of.approach / over.approach)
        , length(of.contact_radius / over.contact_radius)
        , stress(of.pressure / over.pressure)
      {}

      void apply(std::vector<CurvePoint> &branch) const
      {
        for (auto &point : branch)
          {
            point.approach *= approach;
            point.force *= force;
            point.contact_radius *= length;
            point.pressure_max *= stress;
            point.mises_stress_max *= stress;
            point.plastic_volume *= length * length * length;
            point.dissipated_energy *= force * approach;
            point.plastic_strain_max *= approach / length;
          }
      }

      void apply(Curve &curve) const
      {
        apply(curve.loading);
        apply(curve.unloading);
      }
    };

    /// The curve of a stop.
    Curve curve_of(const HalfSpaceModel::BranchedRun &run, const std::size_t stop)
    {
      const auto &at = run.stops[stop];
      return {
        {run.loading.begin(), run.loading.begin() + static_cast<std::ptrdiff_t>(at.loading_points)},
        at.unloading};
    }

    /// A loading path with its unloading branches, and the same with halved steps.
    struct PathPair
    {
      HalfSpaceModel::BranchedRun coarse, fine;
      unsigned int                apex_points;
      SolverOptions               used;
    };

    /// Enters the extrapolated curve and the error of its load step.
    void extrapolate(const Curve &coarse, const Curve &fine, Solution &solution)
    {
      try
        {
          solution.curve      = extrapolate_steps(coarse, fine);
          solution.step_error = share_of_difference * step_difference(coarse, fine);
        }
      catch (const StepsTooLarge &)
        {
          solution.curve      = extrapolate_steps_smoothly(coarse, fine);
          solution.step_error = share_of_difference * smooth_step_difference(coarse, fine);
          solution.warnings.emplace_back(smooth_extrapolation_warning);
        }
    }

    PathPair run_paths(const FamilyMember        &top,
                       const std::vector<double> &stops,
                       const Pilot               &pilot,
                       const SolverOptions       &options,
                       Cost                      &cost,
                       const StepObserver        &observer)
    {
      SolverOptions used = options;
      if (!used.surface_halvings)
        used.surface_halvings = pilot.approach > strongly_plastic ? 1 : 0;
      HalfSpaceModel model(top.material, top.scene, used, pilot.contact_radius);

      // To the first stop equal steps of τ, later equal steps of ln τ.
      const double first_step =
        stops.front() * step_size(1 + share_at_first_stop * (pilot.approach - 1));
      double                    approach_ratio = 1;
      std::vector<unsigned int> unloading_steps;

      HalfSpaceModel::Levels levels;
      levels.stops = stops;
      levels.next  = [&](const double level, const double ratio, const double stop) {
        approach_ratio = ratio;
        const double n = level < stops.front() * (1 - 1e-12)
                            ? std::ceil((stop - level) / first_step - 1e-9)
                            : std::ceil(std::log(stop / level) / step_size(ratio) - 1e-9);
        if (n <= 1)
          return stop;
        return level < stops.front() ? level + (stop - level) / n
                                      : level * std::pow(stop / level, 1 / n);
      };
      levels.unloading_steps = [&](std::size_t) {
        const double steps = std::clamp(0.5 / step_size(approach_ratio), 8., 16.);
        unloading_steps.push_back(static_cast<unsigned int>(std::lround(steps)));
        return unloading_steps.back();
      };
      PathPair pair{model.run(levels, observer), {}, 0, used};
      add_cost(cost, model);

      std::vector<double> fine_levels;
      double              previous = 0;
      for (const double level : pair.coarse.levels)
        {
          fine_levels.push_back((previous + level) / 2);
          fine_levels.push_back(previous = level);
        }
      std::size_t position   = 0;
      levels.next            = [&](double, double, double) { return fine_levels[position++]; };
      levels.unloading_steps = [&](const std::size_t stop) { return 2 * unloading_steps[stop]; };
      pair.fine              = model.run(levels, observer);
      pair.apex_points       = model.counters().apex_points;
      add_cost(cost, model);
      return pair;
    }

    /// What the path tells about the peak of another member, of lower load level.
    Pilot pilot_from(const HalfSpaceModel::BranchedRun &run,
                     const FamilyMember                &computed,
                     const double                       computed_load_level,
                     const FamilyMember                &other,
                     const double                       load_level)
    {
      const double force = computed.scene.force_max * load_level / computed_load_level;
      const auto   above = std::lower_bound(
        run.loading.begin(),
        run.loading.end(),
        force,
        [](const CurvePoint &point, const double value) { return point.force < value; });
      const double ratio =
        above->approach / hertz::approach(computed.material, computed.scene.radius, above->force);
      const Scales scales(first_yield(other.material, other.scene.radius),
                          first_yield(computed.material, computed.scene.radius));
      return {above->contact_radius * std::cbrt(force / above->force) * scales.length, ratio};
    }

    /// Extrapolated curve, its error and the profile of a stop, for the member whose scales are
    /// given.
    void
    enter(const PathPair &paths, const std::size_t stop, const Scales &scales, Solution &solution)
    {
      const Curve coarse = curve_of(paths.coarse, stop), fine = curve_of(paths.fine, stop);
      extrapolate(coarse, fine, solution);
      solution.coarser_steps = fine;
      solution.coarser_share = share_of_difference;
      solution.peak_profile  = paths.fine.stops[stop].profile;
      solution.apex_points   = paths.apex_points;
      scales.apply(solution.curve);
      scales.apply(solution.coarser_steps);
      for (auto &point : solution.peak_profile)
        {
          point.radius *= scales.length;
          point.pressure *= scales.stress;
        }
    }

    Cost share(Cost cost, const std::size_t members)
    {
      const auto n = static_cast<unsigned int>(members);
      cost.steps /= n;
      cost.newton_iterations /= n;
      cost.cut_backs /= n;
      return cost;
    }

    void check_family(const std::vector<FamilyMember> &members)
    {
      for (const FamilyMember &member : members)
        {
          member.material.check();
          member.scene.check();
          const Material &first = members.front().material;
          check_similar(member.material);
          if (member.material.poisson_ratio != first.poisson_ratio ||
              member.material.friction_angle != first.friction_angle ||
              member.material.flow_stress_ratio != first.flow_stress_ratio ||
              member.material.flow_angle() != first.flow_angle())
            throw InputError("the members of a family must have equal nu, phi, K and psi");
        }
    }
  } // namespace

  void check_similar(const Material &material)
  {
    if (material.criterion != Criterion::drucker_prager || material.hardening != 0)
      throw InputError("families need perfectly plastic drucker-prager: other laws bring groups of "
                       "their own (H/E, T0/sigma-c); use mode = direct");
  }

  std::vector<Solution> solve_family(const std::vector<FamilyMember> &members,
                                     const SolverOptions             &options,
                                     const StepObserver              &observer)
  {
    const auto start = std::chrono::steady_clock::now();
    options.check();
    check_family(members);
    if (options.mesh != MeshKind::fitted || options.surface != Surface::parabola)
      throw InputError(
        "families need mesh = fitted and surface = parabola: others are not similar");

    std::vector<Solution>    solutions(members.size());
    std::vector<double>      load_level(members.size());
    std::vector<std::size_t> plastic; // members that yield, by load level
    for (std::size_t i = 0; i < members.size(); ++i)
      {
        const FirstYield yield = first_yield(members[i].material, members[i].scene.radius);
        load_level[i]          = members[i].scene.force_max / yield.force;
        if (options.closed_form && members[i].material.onset_is_known() &&
            members[i].scene.force_max <= yield.onset_force())
          {
            solutions[i] = elastic_solution(members[i].material, members[i].scene, elastic_steps);
            solutions[i].used = options;
          }
        else
          plastic.push_back(i);
        solutions[i].yield = yield;
      }
    std::sort(plastic.begin(), plastic.end(), [&](const std::size_t i, const std::size_t k) {
      return load_level[i] < load_level[k];
    });

    // From the largest load down, each path with the members whose contact its mesh resolves.
    std::optional<Pilot> pilot;
    while (!plastic.empty())
      {
        const FamilyMember &top  = members[plastic.back()];
        const double        most = load_level[plastic.back()];
        Cost                cost;
        if (!pilot)
          pilot =
            run_pilots(top.material, top.scene, solutions[plastic.back()].yield, cost, observer);
        auto first = plastic.end() - 1;
        while (first != plastic.begin() &&
               load_level[*(first - 1)] >= most * std::pow(least_load_ratio, 1. + options.octaves))
          --first;
        const std::vector<std::size_t> served(first, plastic.end());
        plastic.erase(first, plastic.end());

        std::vector<double> stops;
        for (const std::size_t i : served)
          stops.push_back(i == served.back() ? 1. : std::cbrt(load_level[i] / most));
        const PathPair paths = run_paths(top, stops, *pilot, options, cost, observer);
        for (std::size_t k = 0; k < served.size(); ++k)
          {
            Solution &solution = solutions[served[k]];
            enter(paths, k, Scales(solution.yield, solutions[served.back()].yield), solution);
            solution.mesh_radius = pilot->contact_radius;
            solution.used        = paths.used;
            solution.cost        = share(cost, served.size());
          }
        if (!plastic.empty())
          pilot =
            pilot_from(paths.fine, top, most, members[plastic.back()], load_level[plastic.back()]);
      }

    const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    for (std::size_t i = 0; i < members.size(); ++i)
      {
        solutions[i].cost.wall_seconds      = seconds / static_cast<double>(members.size());
        solutions[i].cost.peak_memory_bytes = peak_memory();
        add_warnings(members[i].scene, solutions[i]);
      }
    return solutions;
  }
} // namespace dpcontact
