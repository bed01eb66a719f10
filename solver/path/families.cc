#include "solver/path/families.h"

#include "meshing/errors.h"
#include "solver/closed_form/hertz.h"
#include "solver/path/contact_model.h"
#include "solver/path/elastic_solution.h"
#include "solver/path/pilot.h"
#include "solver/path/runs.h"
#include "solver/path/step_extrapolation.h"
#include "solver/path/step_refinement.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

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

    /// Factors from the quantities of the scene that was computed to those of a similar one.
    CurveScale scale_of(const FirstYield &of, const FirstYield &over)
    {
      const double force    = of.force / over.force;
      const double approach = of.approach / over.approach;
      const double length   = of.contact_radius / over.contact_radius;
      const double stress   = of.pressure / over.pressure;
      return {approach,
              force,
              length,
              stress,
              length * length * length,
              force * approach,
              approach / length};
    }

    /// The curve of a stop.
    Curve curve_of(const UnloadedAtStops &run, const std::size_t stop)
    {
      const auto &at = run.stops[stop];
      return {
        {run.loading.begin(), run.loading.begin() + static_cast<std::ptrdiff_t>(at.loading_points)},
        at.unloading};
    }

    /// A loading path with its unloading branches, and the same with halved steps.
    struct PathPair
    {
      UnloadedAtStops coarse, fine;
      unsigned int    apex_points;
      SolverOptions   used;
    };

    /// Extrapolates in the load step and estimates the error that it leaves.
    RefinedSteps<Curve> extrapolate(const Curve &coarse, const Curve &fine)
    {
      StepRule rule;
      rule.first_steps   = 1;
      rule.last_steps    = 2;
      rule.at_last_steps = AtLastSteps::accept;
      rule.first_share   = share_of_difference;
      StepRefinement<Curve> refinement(curve_comparison(), rule);
      return refinement.refine([&](const unsigned int steps) {
        return StepRefinement<Curve>::Run{steps == 1 ? coarse : fine};
      });
    }

    PathPair run_paths(const Case                &top,
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

      UnloadingStops plan;
      plan.stops = stops;
      plan.next  = [&](const double level, const double ratio, const double stop) {
        approach_ratio = ratio;
        const double n = level < stops.front() * (1 - 1e-12)
                            ? std::ceil((stop - level) / first_step - 1e-9)
                            : std::ceil(std::log(stop / level) / step_size(ratio) - 1e-9);
        if (n <= 1)
          return stop;
        return level < stops.front() ? level + (stop - level) / n
                                      : level * std::pow(stop / level, 1 / n);
      };
      plan.unloading_steps = [&](std::size_t) {
        const double steps = std::clamp(0.5 / step_size(approach_ratio), 8., 16.);
        unloading_steps.push_back(static_cast<unsigned int>(std::lround(steps)));
        return unloading_steps.back();
      };
      PathPair pair{run_with_stops(model, plan, observer), {}, 0, used};
      add_cost(cost, model);

      std::vector<double> fine_levels;
      double              previous = 0;
      for (const double level : pair.coarse.levels)
        {
          fine_levels.push_back((previous + level) / 2);
          fine_levels.push_back(previous = level);
        }
      std::size_t position = 0;
      plan.next            = [&](double, double, double) { return fine_levels[position++]; };
      plan.unloading_steps = [&](const std::size_t stop) { return 2 * unloading_steps[stop]; };
      pair.fine            = run_with_stops(model, plan, observer);
      pair.apex_points     = model.counters().apex_points;
      add_cost(cost, model);
      return pair;
    }

    /// What the path tells about the peak of another member, of lower load level.
    Pilot pilot_from(const UnloadedAtStops &run,
                     const Case            &computed,
                     const double           computed_load_level,
                     const Case            &other,
                     const double           load_level)
    {
      const double force = computed.scene.force_max * load_level / computed_load_level;
      const auto   above = std::lower_bound(
        run.loading.begin(),
        run.loading.end(),
        force,
        [](const CurvePoint &point, const double value) { return point.force < value; });
      const double ratio =
        above->approach / hertz::approach(computed.material, computed.scene.radius, above->force);
      const CurveScale scale = scale_of(first_yield(other.material, other.scene.radius),
                                        first_yield(computed.material, computed.scene.radius));
      return {above->contact_radius * std::cbrt(force / above->force) * scale.length, ratio};
    }

    /// Enters the extrapolated curve, its error and the pressure profile of a stop, for the member
    /// whose scale is given.
    void enter(const PathPair   &paths,
               const std::size_t stop,
               const CurveScale &scale,
               Solution         &solution)
    {
      RefinedSteps<Curve> refined =
        extrapolate(curve_of(paths.coarse, stop), curve_of(paths.fine, stop));
      solution.curve         = std::move(refined.points);
      solution.step_error    = refined.error;
      solution.coarser_steps = std::move(refined.coarser);
      solution.coarser_share = refined.coarser_share;
      if (refined.smooth)
        solution.warnings.emplace_back(smooth_extrapolation_warning);
      solution.peak_profile = paths.fine.stops[stop].profile;
      solution.apex_points  = paths.apex_points;
      scale.apply(solution.curve);
      scale.apply(solution.coarser_steps);
      for (auto &point : solution.peak_profile)
        {
          point.radius *= scale.length;
          point.pressure *= scale.stress;
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

    void check_family(const std::vector<Case> &members)
    {
      for (const Case &member : members)
        {
          member.material.check();
          member.scene.check();
          const Material &first = members.front().material;
          check_similar(member.material);
          if (similarity_group(member.material) != similarity_group(first))
            throw InputError("the members of a family must have equal nu, phi, K and psi");
        }
    }
  } // namespace

  std::vector<double> similarity_group(const Material &material)
  {
    std::vector<double> numbers;
    for (const MaterialParameter &parameter : material_parameters())
      if (parameter.dimension == Dimension::number || parameter.dimension == Dimension::angle)
        numbers.push_back(parameter.get(material));
    return numbers;
  }

  void check_similar(const Material &material)
  {
    // What has the unit of a stress brings a group of its own.
    bool has_own_stress = false;
    for (const MaterialParameter &parameter : material_parameters())
      if (!parameter.owners.empty() && parameter.dimension == Dimension::pressure)
        has_own_stress = has_own_stress || !is_default(parameter, material);
    if (material.criterion != Criterion::drucker_prager || has_own_stress)
      throw InputError("families need perfectly plastic drucker-prager: other laws bring groups of "
                       "their own (H/E, T0/sigma-c); use mode = direct");
  }

  namespace
  {
    /// Refuses what is not similar.
    void check_similar_meshes(const SolverOptions &options)
    {
      if (options.mesh != MeshKind::fitted || options.surface != Surface::parabola)
        throw InputError(
          "families need mesh = fitted and surface = parabola: others are not similar");
    }

    /// The members of a family on their way.
    struct Family
    {
      const std::vector<Case> &members;
      const SolverOptions     &options;
      const StepObserver      &observer;
      std::vector<Solution>    solutions;
      std::vector<double>      load_level; ///< Λ of each member
      std::vector<std::size_t> plastic;    ///< still to be computed, by load level
    };

    /// Enters first yield of all members and the curves of those that stay elastic.
    Family begin(const std::vector<Case> &members,
                 const SolverOptions     &options,
                 const StepObserver      &observer)
    {
      Family family{members, options, observer, {}, {}, {}};
      family.solutions.resize(members.size());
      family.load_level.resize(members.size());
      for (std::size_t i = 0; i < members.size(); ++i)
        {
          const auto &[material, scene] = members[i];
          const FirstYield yield        = first_yield(material, scene.radius);
          family.load_level[i]          = scene.force_max / yield.force;
          if (options.closed_form && scene.force_max <= yield.elastic_force)
            {
              family.solutions[i]      = elastic_solution(material, scene, elastic_steps);
              family.solutions[i].used = options;
            }
          else
            family.plastic.push_back(i);
          family.solutions[i].yield = yield;
        }
      std::sort(family.plastic.begin(),
                family.plastic.end(),
                [&](const std::size_t i, const std::size_t k) {
                  return family.load_level[i] < family.load_level[k];
                });
      return family;
    }

    /// Takes from `plastic` the member of the largest load and those whose contact its mesh
    /// resolves. @return them, by load level.
    std::vector<std::size_t> take_largest(Family &family)
    {
      const double most  = family.load_level[family.plastic.back()];
      auto         first = family.plastic.end() - 1;
      while (first != family.plastic.begin() &&
             family.load_level[*(first - 1)] >=
               most * std::pow(least_load_ratio, 1. + family.options.octaves))
        --first;
      const std::vector<std::size_t> served(first, family.plastic.end());
      family.plastic.erase(first, family.plastic.end());
      return served;
    }

    /// Computes one path and the members that it serves.
    /// @param pilot of the largest of them; unset: it is made. Afterwards of the next path's.
    void solve_path(Family &family, std::optional<Pilot> &pilot)
    {
      const std::vector<std::size_t> served = take_largest(family);
      const Case                    &top    = family.members[served.back()];
      const double                   most   = family.load_level[served.back()];
      const FirstYield               over   = family.solutions[served.back()].yield;
      Cost                           cost;
      if (!pilot)
        pilot = run_pilots(top.material, top.scene, over, cost, family.observer);
      std::vector<double> stops;
      for (const std::size_t i : served)
        stops.push_back(i == served.back() ? 1. : std::cbrt(family.load_level[i] / most));
      const PathPair paths = run_paths(top, stops, *pilot, family.options, cost, family.observer);
      for (std::size_t k = 0; k < served.size(); ++k)
        {
          Solution &solution = family.solutions[served[k]];
          enter(paths, k, scale_of(solution.yield, over), solution);
          solution.mesh_radius = pilot->contact_radius;
          solution.used        = paths.used;
          solution.cost        = share(cost, served.size());
        }
      if (!family.plastic.empty())
        pilot = pilot_from(paths.fine,
                           top,
                           most,
                           family.members[family.plastic.back()],
                           family.load_level[family.plastic.back()]);
    }
  } // namespace

  std::vector<Solution> solve_family(const std::vector<Case> &members,
                                     const SolverOptions     &options,
                                     const StepObserver      &observer)
  {
    const auto start = std::chrono::steady_clock::now();
    options.check();
    check_family(members);
    check_similar_meshes(options);
    Family               family = begin(members, options, observer);
    std::optional<Pilot> pilot;
    while (!family.plastic.empty())
      solve_path(family, pilot);

    const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    for (std::size_t i = 0; i < members.size(); ++i)
      {
        Solution &solution              = family.solutions[i];
        solution.cost.wall_seconds      = seconds / static_cast<double>(members.size());
        solution.cost.peak_memory_bytes = peak_memory();
        add_warnings(members[i], solution);
      }
    return std::move(family.solutions);
  }
} // namespace dpcontact
