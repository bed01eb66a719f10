#include "solver/solve.h"

#include "meshing/errors.h"
#include "solver/contact_model.h"
#include "solver/elastic_solution.h"
#include "solver/hertz.h"
#include "solver/pilot.h"
#include "solver/recovery.h"
#include "solver/step_extrapolation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>
#include <sstream>

namespace dpcontact
{
  namespace
  {
    constexpr unsigned int first_loading_steps = 16;
    constexpr unsigned int most_loading_steps  = 1024;
    constexpr unsigned int largest_direct      = 30000; ///< unknowns, see runs/benchmark

    void check_option(const bool holds, const char *name, const double value, const char *range)
    {
      if (holds)
        return;
      std::ostringstream message;
      message << "option " << name << " is " << value << "; it must be " << range;
      throw InputError(message.str());
    }
    /// The first run's steps where the finest has `finest`: halved at least once, and on down to
    /// first_loading_steps while they stay whole.
    unsigned int coarsest(unsigned int finest)
    {
      do
        finest /= 2;
      while (finest % 2 == 0 && finest / 2 >= first_loading_steps);
      return finest;
    }
  } // namespace

  void add_warnings(const Scene &scene, Solution &solution)
  {
    const auto        &peak = solution.curve.loading.back();
    std::ostringstream text;
    if (peak.contact_radius > 0.1 * scene.radius)
      {
        text << "small strain is left behind: contact radius over sphere radius is "
             << peak.contact_radius / scene.radius << " (> 0.1)";
        solution.warnings.push_back(text.str());
      }
    const double strain = solution.curve.unloading.back().plastic_strain_max;
    if (strain > 0.1)
      {
        text.str("");
        text << "small strain is left behind: the largest plastic strain is " << strain
             << " (> 0.1)";
        solution.warnings.push_back(text.str());
      }
  }

  SolverOptions SolverOptions::of(const Geometry geometry)
  {
    SolverOptions options;
    options.geometry = geometry;
    if (in_space(geometry))
      {
        options.element    = Element::quadratic_full;
        options.resolution = 6;
      }
    if (geometry == Geometry::published)
      {
        options.element = Element::linear_mean_dilatation;
        options.mesh    = MeshKind::published;
      }
    return options;
  }

  double SolverOptions::angle() const
  {
    return geometry == Geometry::disc     ? 2 * M_PI
           : geometry == Geometry::sector ? sector_angle * (M_PI / 180)
                                          : M_PI / 2;
  }

  LinearSolver linear_solver(const SolverOptions &options, const unsigned int n_unknowns)
  {
    if (options.linear_solver != LinearSolver::automatic)
      return options.linear_solver;
    return n_unknowns <= largest_direct ? LinearSolver::direct : LinearSolver::iterative;
  }

  void SolverOptions::check() const
  {
    check_option(
      sector_angle == 90 || sector_angle == 45, "sector-angle", sector_angle, "90 or 45");
    if (in_space(geometry))
      {
        const std::string in = std::string("in space (geometry = ") + to_string(geometry) + ") ";
        if (element == Element::serendipity_reduced)
          throw InputError(in +
                           "element = serendipity is not for contact: nodes inside a face would "
                           "bear pressure without a displacement; take brick or quadratic");
        if (surface == Surface::sphere)
          throw InputError(
            in + "surface = sphere is not modelled: take parabola, or the axisymmetric geometry");
        if (octaves > 0 || mesh_distortion > 0)
          throw InputError(
            in + "octaves and mesh-distortion must be 0: they are for the axisymmetric geometry");
      }
    if ((geometry == Geometry::published) != (mesh == MeshKind::published) && in_space(geometry))
      throw InputError(std::string("geometry = ") + to_string(geometry) +
                       " does not go with mesh = " + to_string(mesh) + ": leave mesh out");

    check_option(resolution >= 2 && resolution <= 1024, "resolution", resolution, "from 2 to 1024");
    check_option(surface_halvings.value_or(0) <= 4,
                 "surface-halvings",
                 surface_halvings.value_or(0),
                 "at most 4");
    check_option(level <= 6, "level", level, "at most 6");
    check_option(octaves <= 12, "octaves", octaves, "at most 12");
    check_option(std::isfinite(domain_radius) && domain_radius >= 10,
                 "domain-radius",
                 domain_radius,
                 "finite and at least 10 contact radii");
    check_option(std::isfinite(mesh_stretch) && mesh_stretch >= 0.5 && mesh_stretch <= 2,
                 "mesh-stretch",
                 mesh_stretch,
                 "from 0.5 to 2");
    check_option(mesh_distortion >= 0 && mesh_distortion <= 0.3,
                 "mesh-distortion",
                 mesh_distortion,
                 "from 0 to 0.3");
    // The run with half as many steps needs a curve that can be fitted as well.
    check_option(loading_steps == 0 ||
                   (loading_steps % 2 == 0 && loading_steps >= 16 && loading_steps <= 4096),
                 "loading-steps",
                 loading_steps,
                 "even, from 16 to 4096 (0: as many as step-tolerance needs)");
    check_option(step_tolerance > 0 && step_tolerance <= 1,
                 "step-tolerance",
                 step_tolerance,
                 "above 0 and at most 1");
    check_option(penalty_stiffness > 0 && penalty_stiffness <= 1e9,
                 "penalty-stiffness",
                 penalty_stiffness,
                 "above 0 and at most 1e9, beyond which the rounding of the gap moves the force");
  }

  namespace
  {
    /// What the peak tells beyond its point on the curve.
    template <int dim>
    void enter_peak(const ContactModel<dim> &model, const bool points, Solution &solution)
    {
      const UnitSystem &units = model.units();
      solution.peak_profile   = model.profile();
      if constexpr (dim == 2)
        {
          solution.peak_axis.clear();
          for (const auto &[depth, axial, radial] : axis_profile(model.system()))
            solution.peak_axis.push_back(
              {depth * units.length, axial * units.stress, radial * units.stress});
          solution.plastic_zone = plastic_zone(model.system(), units.length);
          solution.flow_zone    = plastic_zone(model.system(), units.length, ZoneRule::flowing);
          if (points)
            solution.peak_points =
              point_states(model.system(), units.length, units.displacement, units.stress);
        }
      else
        {
          solution.axisymmetry_deviation = model.axisymmetry_deviation();
          (void)points;
        }
    }

    /// Enters the curve that extrapolate_steps_smoothly() makes, and the error of its load step.
    /// @return false where that is no curve either.
    bool extrapolate_smoothly(const Curve &coarse,
                              const Curve &fine,
                              const double share,
                              Solution    &solution)
    {
      try
        {
          solution.curve = extrapolate_steps_smoothly(coarse, fine);
        }
      catch (const StepsTooLarge &)
        {
          return false;
        }
      solution.step_error    = share * smooth_step_difference(coarse, fine);
      solution.coarser_steps = fine;
      solution.coarser_share = share_of_first_difference;
      return true;
    }

    /// Runs with halved steps until the curve is as accurate as asked for.
    template <int dim>
    void solve_on(const Material      &material,
                  const Scene         &scene,
                  const SolverOptions &options,
                  const std::string   &fields_directory,
                  const StepObserver  &observer,
                  const Communicator  &processes,
                  const Checkpoint    &checkpoint,
                  Solution            &solution)
    {
      SolverOptions    &used = solution.used;
      ContactModel<dim> model(material, scene, used, solution.mesh_radius, processes);
      solution.mesh_quality = model.quality();
      const auto write      = [&](const char *name) {
        if (!fields_directory.empty())
          write_fields(model.system(),
                       model.units().length,
                       model.units().displacement,
                       model.units().stress,
                       fields_directory + "/" + name);
      };
      const auto at_peak = [&] {
        enter_peak(model, !fields_directory.empty(), solution);
        write("peak");
      };
      const auto at_end = [&] { write("released"); };

      unsigned int steps =
        options.loading_steps > 0 ? coarsest(options.loading_steps) : first_loading_steps;
      Curve coarse         = model.run(steps, observer, {}, {}, checkpoint);
      bool  coarse_was_cut = model.counters().cut_backs > 0;
      add_cost(solution.cost, model);
      std::optional<Curve> extrapolated; // from the two runs before
      for (;;)
        {
          steps *= 2;
          Curve fine = model.run(steps, observer, at_peak, at_end, checkpoint);
          add_cost(solution.cost, model);
          solution.apex_points    = model.counters().apex_points;
          solution.checks         = model.checks();
          const double difference = step_difference(coarse, fine);
          // Steps that were cut are no longer twice the finer ones: nothing is known to cancel
          // then.
          const bool           fine_was_cut = model.counters().cut_backs > 0;
          const double         share        = coarse_was_cut || fine_was_cut ? 1.
                                              : extrapolated                 ? share_of_difference
                                                             : share_of_first_difference;
          std::optional<Curve> finer;
          if (!options.extrapolation)
            solution.step_error = difference; // what is left of a first-order error
          else
            try
              {
                finer               = extrapolate_steps(coarse, fine);
                solution.step_error = share * difference;
                if (extrapolated)
                  solution.step_error = std::max(solution.step_error,
                                                 share_of_extrapolated_difference *
                                                   step_difference(*extrapolated, *finer));
              }
            catch (const StepsTooLarge &)
              {
                solution.step_error = difference; // not yet a curve: halve the steps once more
              }
          const bool enough =
            options.loading_steps > 0
              ? steps == options.loading_steps
              : solution.step_error <= options.step_tolerance && !(coarse_was_cut || fine_was_cut);
          if (enough && (finer || !options.extrapolation))
            {
              solution.coarser_steps = extrapolated ? *extrapolated : finer ? fine : coarse;
              solution.coarser_share = extrapolated ? share_of_extrapolated_difference
                                       : finer      ? share_of_first_difference
                                                    : 1.;
              solution.curve         = finer ? *finer : fine;
              used.loading_steps     = steps;
              break;
            }
          // No more steps may be taken: where the edge of the contact, moving from node to node,
          // makes the difference jump, its smooth part is extrapolated instead.
          const bool last = options.loading_steps > 0 ? steps == options.loading_steps
                                                      : 2 * steps > most_loading_steps;
          if (last && options.extrapolation &&
              extrapolate_smoothly(coarse, fine, share, solution) &&
              (options.loading_steps > 0 ||
               (solution.step_error <= options.step_tolerance && !fine_was_cut && !coarse_was_cut)))
            {
              solution.warnings.emplace_back(smooth_extrapolation_warning);
              used.loading_steps = steps;
              break;
            }
          if (last && options.loading_steps > 0)
            throw SolverError("with loading-steps " + std::to_string(steps) +
                              " the extrapolated curve is not monotone: ask for more steps");
          if (last)
            {
              std::ostringstream message;
              message << "step-tolerance " << options.step_tolerance << " is not reached with "
                      << steps << " load steps: the error is estimated at " << solution.step_error
                      << "; ask for a larger tolerance or refine the mesh (resolution)";
              throw SolverError(message.str());
            }
          coarse         = std::move(fine);
          extrapolated   = std::move(finer);
          coarse_was_cut = fine_was_cut;
        }
      solution.cost.linear_solves     = model.system().linear_solves();
      solution.cost.linear_iterations = model.system().linear_iterations();
    }
  } // namespace

  Solution solve_contact(const Material      &material,
                         const Scene         &scene,
                         const SolverOptions &options,
                         const std::string   &fields_directory,
                         const StepObserver  &observer,
                         const Communicator  &processes,
                         const Checkpoint    &checkpoint)
  {
    const auto start = std::chrono::steady_clock::now();
    material.check();
    scene.check();
    options.check();
    if (!processes.alone() && !in_space(options.geometry))
      throw InputError(
        "geometry = axisymmetric is solved by one process: leave mpirun out, or ask for "
        "a geometry in space");
    if (scene.second && options.surface == Surface::sphere)
      throw InputError(
        "surface = sphere is not modelled for two bodies that differ: take parabola");
    if (!fields_directory.empty())
      {
        std::error_code error;
        std::filesystem::create_directories(fields_directory, error);
        if (!std::filesystem::is_directory(fields_directory))
          throw FileError("cannot create the directory '" + fields_directory +
                          "': check the path and its permissions");
      }

    const FirstYield yield = first_yield(material, scene);
    if (options.closed_form && options.surface == Surface::parabola && fields_directory.empty() &&
        material.onset_is_known() && scene.force_max <= yield.onset_force())
      {
        Solution solution = elastic_solution(material, scene, elastic_steps);
        solution.used     = options;
        add_warnings(scene, solution);
        solution.cost.peak_memory_bytes = peak_memory();
        solution.cost.wall_seconds =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        return solution;
      }

    Solution solution;
    solution.yield       = yield;
    const Pilot pilot    = run_pilots(material, scene, solution.yield, solution.cost, observer);
    solution.mesh_radius = processes.broadcast(pilot.contact_radius);
    solution.used        = options;
    if (!solution.used.surface_halvings)
      solution.used.surface_halvings =
        processes.broadcast(pilot.approach) > strongly_plastic && !in_space(options.geometry) ? 1
                                                                                              : 0;
    if (in_space(options.geometry))
      solve_on<3>(
        material, scene, options, fields_directory, observer, processes, checkpoint, solution);
    else
      solve_on<2>(
        material, scene, options, fields_directory, observer, processes, checkpoint, solution);

    add_warnings(scene, solution);
    solution.cost.processes = processes.size();
    solution.cost.wall_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    solution.cost.peak_memory_bytes =
      static_cast<std::uint64_t>(processes.sum(static_cast<double>(peak_memory())));
    return solution;
  }
} // namespace dpcontact
