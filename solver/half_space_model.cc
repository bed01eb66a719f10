#include "solver/half_space_model.h"

#include "meshing/published_mesh.h"
#include "meshing/quality.h"
#include "meshing/sphere_cap.h"
#include "meshing/zoned_mesh.h"
#include "solver/hertz.h"
#include "solver/law_of.h"

#include <deal.II/grid/grid_tools.h>

#include <cmath>

namespace dpcontact
{
  HalfSpaceModel::HalfSpaceModel(const Material      &material,
                                 const Scene         &scene_,
                                 const SolverOptions &options_,
                                 const double         mesh_radius)
    : scene(scene_)
    , options(options_)
    , peak_approach_guess(hertz::approach(material, scene.radius, scene.force_max) / 2)
  {
    const double a = mesh_radius, E = material.youngs_modulus, nu = material.poisson_ratio;
    const bool   si = options.units == Units::si;
    unit_system =
      si ? UnitSystem{1, 1, 1} : UnitSystem{a, a * a / scene.radius, E * a / scene.radius};

    if (options.mesh == MeshKind::published)
      {
        PublishedMesh published;
        published.level = options.level;
        published.unit  = a;
        make_published_mesh(published, triangulation);
      }
    else
      {
        Zones zones;
        zones.resolution       = options.resolution;
        zones.level            = options.level;
        zones.surface_halvings = options.surface_halvings.value_or(0);
        zones.domain_radius    = options.domain_radius;
        zones.stretch          = options.mesh_stretch;
        zones.octaves          = options.octaves;
        make_zoned_mesh(zones, triangulation);
      }
    if (options.mesh_distortion > 0)
      dealii::GridTools::distort_random(options.mesh_distortion, triangulation, true, 1);
    const bool curved = options.surface == Surface::sphere;
    if (curved)
      map_to_sphere(scene.radius / a, triangulation);
    mesh_quality = assess(triangulation, 1);
    if (si)
      dealii::GridTools::scale(a, triangulation);

    const double modulus = si ? E : 1;

    space = std::make_unique<Discretization<2>>(
      triangulation, BoussinesqField<2>(modulus, nu), options.element);
    contact_system = std::make_unique<ContactSystem<2>>(
      *space,
      law_of(material, unit_system.stress, unit_system.displacement / unit_system.length),
      Profile(si ? scene.radius : 1., curved ? (si ? 1 : a) / scene.radius : 0.),
      options.penalty_stiffness * (si ? E / a : 1.),
      options.condensation);
  }

  LoadPath<2> HalfSpaceModel::start_path(const unsigned int  loading_steps,
                                         const StepObserver &observer)
  {
    LoadPath<2>::Options path_options;
    path_options.loading_steps   = loading_steps;
    path_options.unloading_steps = (loading_steps + 1) / 2;
    path_options.augment         = options.contact == ContactMethod::augmented;
    path_options.predict         = options.predictor;
    contact_system->reset();
    return LoadPath<2>(*contact_system, path_options, observer);
  }

  std::vector<CurvePoint> HalfSpaceModel::run_to_peak(const unsigned int  loading_steps,
                                                      const StepObserver &observer)
  {
    LoadPath<2>             path   = start_path(loading_steps, observer);
    std::vector<CurvePoint> branch = path.load(scene.force_max / unit_system.force(),
                                               peak_approach_guess / unit_system.displacement);
    take_counts(path);
    to_si(branch);
    return branch;
  }

  Curve HalfSpaceModel::run(const unsigned int           loading_steps,
                            const StepObserver          &observer,
                            const std::function<void()> &at_peak,
                            const std::function<void()> &at_end)
  {
    LoadPath<2> path = start_path(loading_steps, observer);
    Curve       curve;
    curve.loading = path.load(scene.force_max / unit_system.force(),
                              peak_approach_guess / unit_system.displacement);
    if (at_peak)
      at_peak();
    curve.unloading = path.unload();
    if (at_end)
      at_end();
    take_counts(path);
    to_si(curve.loading);
    to_si(curve.unloading);
    return curve;
  }

  std::vector<Curve> HalfSpaceModel::run_cycles(const unsigned int         loading_steps,
                                                const std::vector<double> &forces,
                                                const StepObserver        &observer)
  {
    LoadPath<2>        path = start_path(loading_steps, observer);
    std::vector<Curve> cycles;
    for (const double force : forces)
      {
        Curve curve;
        curve.loading   = path.load(force / unit_system.force(),
                                  peak_approach_guess / unit_system.displacement *
                                    std::pow(force / scene.force_max, 2. / 3));
        curve.unloading = path.unload();
        to_si(curve.loading);
        to_si(curve.unloading);
        cycles.push_back(std::move(curve));
      }
    take_counts(path);
    return cycles;
  }

  void HalfSpaceModel::take_counts(const LoadPath<2> &path)
  {
    counted = path.counters();
    checked = path.checks();
    for (double PathChecks::*energy : {&PathChecks::work,
                                       &PathChecks::largest_work,
                                       &PathChecks::elastic_energy,
                                       &PathChecks::dissipation,
                                       &PathChecks::mean_dissipation,
                                       &PathChecks::energy_error})
      checked.*energy *= 2 * unit_system.energy();
  }

  HalfSpaceModel::BranchedRun HalfSpaceModel::run(const Levels       &levels,
                                                  const StepObserver &observer)
  {
    BranchedRun run;
    LoadPath<2> path     = start_path(1, observer);
    std::size_t stop     = 0;
    const auto  at_level = [&](const double level) {
      run.levels.push_back(level);
      while (stop < levels.stops.size() && level >= levels.stops[stop] * (1 - 1e-12))
        {
          BranchedRun::Stop at;
          at.loading_points = run.levels.size() + 1;
          at.profile        = profile();
          at.unloading      = path.unload_and_return(levels.unloading_steps(stop));
          to_si(at.unloading);
          run.stops.push_back(std::move(at));
          ++stop;
        }
    };
    const double guess =
      peak_approach_guess / unit_system.displacement; // of one sphere, at the peak
    run.loading = path.load(
      scene.force_max / unit_system.force(),
      guess,
      [&](const double level, const CurvePoint &present) {
        return levels.next(level,
                           level > 0 ? present.approach / (2 * guess * level * level) : 1.,
                           stop < levels.stops.size() ? levels.stops[stop] : 1.);
      },
      at_level);
    take_counts(path);
    to_si(run.loading);
    return run;
  }

  std::vector<PressurePoint> HalfSpaceModel::profile() const
  {
    std::vector<PressurePoint> result;
    for (const auto &[r, p] :
         contact_system->contact().profile(contact_system->u, contact_system->approach))
      if (p > 0)
        result.push_back({r * unit_system.length, p * unit_system.stress});
    return result;
  }

  void HalfSpaceModel::to_si(std::vector<CurvePoint> &branch) const
  {
    for (auto &point : branch)
      {
        point.approach *= unit_system.displacement;
        point.force *= unit_system.force();
        point.contact_radius *= unit_system.length;
        point.pressure_max *= unit_system.stress;
        point.mises_stress_max *= unit_system.stress;
        point.plastic_volume *= unit_system.length * unit_system.length * unit_system.length;
        point.dissipated_energy *= unit_system.energy();
        point.plastic_strain_max *= unit_system.displacement / unit_system.length;
      }
  }

  std::vector<std::vector<CurvePoint>>
  HalfSpaceModel::run_history(const std::vector<Leg> &legs, const StepObserver &observer)
  {
    LoadPath<2>                          path    = start_path(1, observer);
    const double                         guess   = peak_approach_guess / unit_system.displacement;
    double                               present = 0;
    std::vector<std::vector<CurvePoint>> result;
    for (const Leg &leg : legs)
      {
        const double force = leg.force / unit_system.force(), steps = leg.steps;
        if (present == 0)
          result.push_back(path.load(force,
                                     guess * std::pow(leg.force / scene.force_max, 2. / 3),
                                     [steps](const double level, const CurvePoint &) {
                                       return (std::round(level * steps) + 1) / steps;
                                     }));
        else if (force == 0)
          result.push_back(path.unload(leg.steps));
        else
          result.push_back(path.to_force(force, leg.steps));
        present = force;
      }
    take_counts(path);
    for (auto &leg : result)
      to_si(leg);
    return result;
  }
} // namespace dpcontact
