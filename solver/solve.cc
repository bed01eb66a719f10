#include "solver/solve.h"

#include "meshing/errors.h"
#include "solver/half_space_model.h"
#include "solver/hertz.h"
#include "solver/recovery.h"
#include "solver/step_extrapolation.h"

#include <chrono>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <sys/resource.h>

namespace dpcontact
{
  namespace
  {
    constexpr unsigned int first_loading_steps   = 16;
    constexpr unsigned int most_loading_steps    = 1024;
    constexpr unsigned int pilot_resolution      = 16;
    constexpr unsigned int pilot_steps           = 10;
    constexpr unsigned int most_pilots           = 5;
    constexpr double       pilot_accuracy        = 0.04; ///< of the contact radius, relative

    /// Error left after extrapolation, as a share of the difference between the two finest runs.
    /// Halving the steps again and again for Λ = 392 and 3532 leaves 0.08 to 0.25 of it.
    constexpr double share_after_extrapolation = 0.25;

    void check_option(const bool holds, const char *name, const double value, const char *range)
    {
      if (holds)
        return;
      std::ostringstream message;
      message << "option " << name << " is " << value << "; it must be " << range;
      throw InputError(message.str());
    }

    std::uint64_t peak_memory()
    {
      rusage usage{};
      getrusage(RUSAGE_SELF, &usage);
      return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
    }

    void add_cost(Cost &cost, const HalfSpaceModel &model)
    {
      cost.dofs = model.discretization().n_free();
      cost.steps += model.counters().steps;
      cost.newton_iterations += model.counters().newton_iterations;
      cost.cut_backs += model.counters().cut_backs;
    }

    /// Contact radius at the peak, from coarse runs on meshes fitted better and better.
    double pilot_contact_radius(const Material      &material,
                                const Scene         &scene,
                                const FirstYield    &yield,
                                Cost                &cost,
                                const StepObserver  &observer)
    {
      double a = hertz::contact_radius(scene.radius,
                                       hertz::approach(material, scene.radius, scene.force_max));
      if (scene.force_max <= yield.onset_force())
        return a;
      // Defaults but for the mesh: what is varied in a study must not move the mesh it is studied on.
      SolverOptions coarse;
      coarse.resolution = pilot_resolution;
      for (unsigned int k = 0; k < most_pilots; ++k)
        {
          HalfSpaceModel model(material, scene, coarse, a);
          const double   reached = model.run_to_peak(pilot_steps, observer).back().contact_radius;
          add_cost(cost, model);
          const double change = reached / a - 1;
          a                   = reached;
          if (std::abs(change) < pilot_accuracy)
            break;
        }
      return a;
    }

    void warn(const Material &, const Scene &scene, Solution &solution)
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
          text << "small strain is left behind: the largest plastic strain is " << strain << " (> 0.1)";
          solution.warnings.push_back(text.str());
        }
    }
  } // namespace

  void SolverOptions::check() const
  {
    check_option(resolution >= 2 && resolution <= 1024, "resolution", resolution, "from 2 to 1024");
    check_option(level <= 6, "level", level, "at most 6");
    check_option(std::isfinite(domain_radius) && domain_radius >= 10, "domain-radius", domain_radius, "finite and at least 10 contact radii");
    check_option(std::isfinite(mesh_stretch) && mesh_stretch >= 0.5 && mesh_stretch <= 2, "mesh-stretch", mesh_stretch, "from 0.5 to 2");
    check_option(step_tolerance > 0 && step_tolerance <= 1, "step-tolerance", step_tolerance, "above 0 and at most 1");
    check_option(std::isfinite(penalty_stiffness) && penalty_stiffness > 0, "penalty-stiffness", penalty_stiffness, "finite and positive");
  }

  Solution solve_contact(const Material      &material,
                         const Scene         &scene,
                         const SolverOptions &options,
                         const std::string   &fields_directory,
                         const StepObserver  &observer)
  {
    const auto start = std::chrono::steady_clock::now();
    material.check();
    scene.check();
    options.check();
    if (!fields_directory.empty())
      {
        std::error_code error;
        std::filesystem::create_directories(fields_directory, error);
        if (!std::filesystem::is_directory(fields_directory))
          throw FileError("cannot create the directory '" + fields_directory +
                          "': check the path and its permissions");
      }

    Solution solution;
    solution.yield = first_yield(material, scene.radius);
    const double mesh_radius =
      pilot_contact_radius(material, scene, solution.yield, solution.cost, observer);

    HalfSpaceModel model(material, scene, options, mesh_radius);
    solution.mesh_radius  = mesh_radius;
    solution.mesh_quality = model.quality();
    const auto     write = [&](const char *name) {
      if (!fields_directory.empty())
        write_fields(model.system(),
                     model.units().length,
                     model.units().displacement,
                     model.units().stress,
                     fields_directory + "/" + name);
    };
    const auto at_peak = [&] {
      solution.peak_profile.clear();
      for (const auto &[r, p] : model.system().contact().profile(model.system().u, model.system().approach))
        if (p > 0)
          solution.peak_profile.push_back({r * model.units().length, p * model.units().stress});
      solution.peak_axis.clear();
      for (const auto &[depth, axial, radial] : axis_profile(model.system()))
        solution.peak_axis.push_back({depth * model.units().length,
                                      axial * model.units().stress,
                                      radial * model.units().stress});
      write("peak.vtu");
    };

    unsigned int steps  = first_loading_steps;
    Curve        coarse = model.run(steps, observer);
    add_cost(solution.cost, model);
    for (;;)
      {
        steps *= 2;
        Curve fine = model.run(steps, observer, at_peak, [&] { write("released.vtu"); });
        add_cost(solution.cost, model);
        solution.apex_points = model.counters().apex_points;
        solution.step_error  = share_after_extrapolation * step_difference(coarse, fine);
        if (solution.step_error <= options.step_tolerance)
          try
            {
              solution.curve = extrapolate_steps(coarse, fine);
              break;
            }
          catch (const StepsTooLarge &)
            {} // within the tolerance, but not yet a curve: halve the steps once more
        if (2 * steps > most_loading_steps)
          {
            std::ostringstream message;
            message << "step-tolerance " << options.step_tolerance << " is not reached with " << steps
                    << " load steps: the error is estimated at " << solution.step_error
                    << "; ask for a larger tolerance or refine the mesh (resolution)";
            throw SolverError(message.str());
          }
        coarse = std::move(fine);
      }

    warn(material, scene, solution);
    solution.cost.wall_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    solution.cost.peak_memory_bytes = peak_memory();
    return solution;
  }
} // namespace dpcontact
