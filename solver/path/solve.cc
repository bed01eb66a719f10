#include "solver/path/solve.h"

#include "meshing/errors.h"
#include "solver/closed_form/plausibility.h"
#include "solver/output/recovery.h"
#include "solver/path/contact_model.h"
#include "solver/path/elastic_solution.h"
#include "solver/path/pilot.h"
#include "solver/path/runs.h"
#include "solver/path/step_extrapolation.h"
#include "solver/path/step_refinement.h"

#include <chrono>
#include <cmath>
#include <string>
#include <utility>

namespace dpcontact
{
  namespace
  {
    constexpr unsigned int first_loading_steps = 16;
    constexpr unsigned int most_loading_steps  = 1024;

    /// What solve_contact() is asked for.
    struct Task
    {
      const Material      &material;
      const Scene         &scene;
      const SolverOptions &options;
      const FieldSink     &fields;
      const StepObserver  &observer;
      const Communicator  &processes;
      const Checkpoint    &checkpoint;
    };

    /// The first run's steps where the finest has `finest`: halved at least once, and on down to
    /// first_loading_steps while they stay whole.
    unsigned int coarsest(unsigned int finest)
    {
      do
        finest /= 2;
      while (finest % 2 == 0 && finest / 2 >= first_loading_steps);
      return finest;
    }

    StepRule step_rule(const SolverOptions &options)
    {
      StepRule rule;
      rule.extrapolation = options.extrapolation;
      if (options.loading_steps > 0)
        {
          rule.first_steps   = coarsest(options.loading_steps);
          rule.last_steps    = options.loading_steps;
          rule.at_last_steps = AtLastSteps::accept;
        }
      else
        {
          rule.first_steps = first_loading_steps;
          rule.last_steps  = most_loading_steps;
          rule.tolerance   = options.step_tolerance;
        }
      return rule;
    }

    /// What the peak tells beyond its point on the curve.
    template <int dim>
    void enter_peak(const ContactModel<dim> &model, const bool points, Solution &solution)
    {
      solution.peak_profile = pressure_profile(model.system(), model.units());
      if constexpr (dim == 2)
        {
          const double length   = model.units().length;
          solution.peak_axis    = axis_profile(model.system(), model.units());
          solution.plastic_zone = plastic_zone(model.system(), length);
          solution.flow_zone    = plastic_zone(model.system(), length, ZoneRule::flowing);
          if (model.system().discretisation().n_bodies() == 2)
            {
              solution.second_plastic_zone =
                plastic_zone(model.system(), length, ZoneRule::yielded, 1);
              solution.second_flow_zone =
                plastic_zone(model.system(), length, ZoneRule::flowing, 1);
            }
          if (points)
            solution.peak_points = point_states(model.system(), model.units());
        }
      else
        {
          solution.axisymmetry_deviation = axisymmetry_deviation(model.system());
          (void)points;
        }
    }

    /// At the peak what it tells is entered, and there and after release the fields are written
    /// where they are asked for.
    template <int dim>
    CycleEvents events_of(const ContactModel<dim> &model, const Task &task, Solution &solution)
    {
      const auto write = [&model, &task](const char *name) {
        if (task.fields)
          write_fields(model.system(), model.units(), name, task.fields);
      };
      return {[&model, &task, &solution, write] {
                enter_peak(model, static_cast<bool>(task.fields), solution);
                write("peak");
              },
              [write] { write("released"); }};
    }

    /// Enters the curve, and what is known of the error of its load step.
    void enter_curve(RefinedSteps<Curve> &&refined, Solution &solution)
    {
      solution.curve              = std::move(refined.points);
      solution.step_error         = refined.error;
      solution.coarser_steps      = std::move(refined.coarser);
      solution.coarser_share      = refined.coarser_share;
      solution.used.loading_steps = refined.steps;
      if (refined.smooth)
        solution.warnings.emplace_back(smooth_extrapolation_warning);
    }

    /// Says beside the stage which run it is of those that the rule allows: each has twice the
    /// steps of the one before.
    StepObserver
    naming_run(const StepObserver &observer, const StepRule &rule, const unsigned int steps)
    {
      if (!observer)
        return observer;
      unsigned int run = 1, most = 1;
      for (unsigned int n = rule.first_steps; n < rule.last_steps; n *= 2)
        {
          run += n < steps;
          ++most;
        }
      return [observer,
              name = "run " + std::to_string(run) + " of at most " + std::to_string(most) +
                     ", "](const char *stage, const double fraction, const int newton_iterations) {
        observer((name + stage).c_str(), fraction, newton_iterations);
      };
    }

    /// Runs with halved steps until the curve is as accurate as asked for.
    template <int dim>
    void solve_on(const Task &task, Solution &solution)
    {
      ContactModel<dim> model(
        task.material, task.scene, solution.used, solution.mesh_radius, task.processes);
      solution.mesh_quality    = model.quality();
      const CycleEvents events = events_of(model, task, solution);
      const StepRule    rule   = step_rule(task.options);
      KeptRuns          kept{task.checkpoint, {}};

      StepRefinement<Curve> refinement(curve_comparison(), rule);
      const auto            run = [&](const unsigned int steps) {
        const bool         first = steps == rule.first_steps; // it is never the finest
        const StepObserver observer = naming_run(task.observer, rule, steps);
        const Curve        curve =
          run_cycle(model, steps, observer, first ? CycleEvents() : events, &kept);
        add_cost(solution.cost, model);
        return StepRefinement<Curve>::Run{curve, model.counters().cut_backs > 0};
      };
      try
        {
          enter_curve(refinement.refine(run), solution);
        }
      catch (const StepsTooLarge &)
        {
          throw SolverError("with loading-steps " + std::to_string(rule.last_steps) +
                            " the extrapolated curve is not monotone: ask for more steps");
        }
      solution.apex_points            = model.counters().apex_points;
      solution.checks                 = model.checks();
      solution.cost.linear_solves     = model.system().linear_solves();
      solution.cost.linear_iterations = model.system().linear_iterations();
    }

    void check_task(const Task &task)
    {
      task.material.check();
      task.scene.check();
      task.options.check();
      check_possible({task.material, task.scene});
      if (!task.processes.alone() && !in_space(task.options.geometry))
        throw InputError(
          "geometry = axisymmetric is solved by one process: leave mpirun out, or ask for "
          "a geometry in space");
      if (task.scene.second && task.options.surface == Surface::sphere)
        throw InputError(
          "surface = sphere is not modelled for two bodies that differ: take parabola");
    }

    /// Whether Hertz's closed form is the solution.
    bool stays_elastic(const Task &task, const FirstYield &yield)
    {
      return task.options.closed_form && task.options.surface == Surface::parabola &&
             !task.fields && task.scene.force_max <= yield.elastic_force;
    }

    Solution solve_elastic(const Task &task)
    {
      Solution solution = elastic_solution(task.material, task.scene, elastic_steps);
      solution.used     = task.options;
      return solution;
    }

    Solution solve_plastic(const Task &task, const FirstYield &yield)
    {
      const bool space = in_space(task.options.geometry);
      Solution   solution;
      solution.yield = yield;
      const Pilot pilot =
        run_pilots(task.material, task.scene, yield, solution.cost, task.observer);
      solution.mesh_radius = task.processes.broadcast(pilot.contact_radius);
      solution.used        = task.options;
      if (!solution.used.surface_halvings)
        solution.used.surface_halvings =
          task.processes.broadcast(pilot.approach) > strongly_plastic && !space ? 1 : 0;
      if (space)
        solve_on<3>(task, solution);
      else
        solve_on<2>(task, solution);
      solution.cost.processes = task.processes.size();
      return solution;
    }
  } // namespace

  Solution solve_contact(const Material      &material,
                         const Scene         &scene,
                         const SolverOptions &options,
                         const FieldSink     &fields,
                         const StepObserver  &observer,
                         const Communicator  &processes,
                         const Checkpoint    &checkpoint)
  {
    const auto start = std::chrono::steady_clock::now();
    const Task task{material, scene, options, fields, observer, processes, checkpoint};
    check_task(task);
    const FirstYield yield    = first_yield(material, scene);
    const bool       elastic  = stays_elastic(task, yield);
    Solution         solution = elastic ? solve_elastic(task) : solve_plastic(task, yield);
    add_warnings({material, scene}, solution);
    solution.cost.wall_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    solution.cost.peak_memory_bytes =
      elastic ? peak_memory()
              : static_cast<std::uint64_t>(processes.sum(static_cast<double>(peak_memory())));
    return solution;
  }
} // namespace dpcontact
