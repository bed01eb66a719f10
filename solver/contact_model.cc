#include "solver/contact_model.h"

#include "meshing/partition.h"
#include "meshing/published_mesh.h"
#include "meshing/quality.h"
#include "meshing/sphere_cap.h"
#include "meshing/wedge_mesh.h"
#include "meshing/zoned_mesh.h"
#include "solver/hertz.h"
#include "solver/law_of.h"

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace dpcontact
{
  template <int dim>
  void ContactModel<dim>::make_mesh(const double mesh_radius)
  {
    const double  a         = mesh_radius;
    const bool    published = options.mesh == MeshKind::published;
    PublishedMesh paper;
    paper.outer_radius = options.outer_radius;
    paper.level        = options.level;
    paper.unit         = a;
    Zones zones;
    zones.resolution       = options.resolution;
    zones.level            = options.level;
    zones.surface_halvings = options.surface_halvings.value_or(0);
    zones.domain_radius    = options.domain_radius;
    zones.stretch          = options.mesh_stretch;
    zones.octaves          = options.octaves;
    if constexpr (dim == 2)
      {
        if (published)
          make_published_mesh(paper, triangulation);
        else
          make_zoned_mesh(zones, triangulation);
        if (options.mesh_distortion > 0)
          dealii::GridTools::distort_random(options.mesh_distortion, triangulation, true, 1);
        if (options.surface == Surface::sphere)
          map_to_sphere(scene.radius / a, triangulation);
      }
    else
      {
        if (published)
          make_published_mesh(paper, options.angle(), triangulation);
        else
          make_wedge_mesh(zones, options.angle(), triangulation);
      }
    mesh_quality = assess(triangulation, 1);
    if (options.units == Units::si)
      dealii::GridTools::scale(a, triangulation);
  }

  template <int dim>
  ContactModel<dim>::ContactModel(const Material      &material,
                                  const Scene         &scene_,
                                  const SolverOptions &options_,
                                  const double         mesh_radius,
                                  const Communicator  &processes)
    : scene(scene_)
    , options(options_)
    , peak_approach_guess(hertz::approach(material, scene, scene.force_max) / symmetry_factor())
  {
    const double a    = mesh_radius;
    const bool   si   = options.units == Units::si;
    const bool   pair = scene.second && scene.second->material;
    // The gap of the model is r²/(2R) with this R: of one sphere, or of both.
    const double gap_radius  = 2 * scene.effective_radius() / (scene.second ? 2 : 1);
    const double unit_radius = 2 * scene.effective_radius();
    const double E           = pair
                                 ? std::min(material.youngs_modulus, scene.second->material->youngs_modulus)
                                 : material.youngs_modulus;
    unit_system =
      si ? UnitSystem{1, 1, 1} : UnitSystem{a, a * a / unit_radius, E * a / unit_radius};
    unit_system.share = dim == 3 ? options.angle() / (2 * M_PI) : 1;

    make_mesh(mesh_radius);
    if (!processes.alone())
      partition(processes.size(), triangulation);

    std::vector<Material> bodies{material};
    if (pair)
      bodies.push_back(*scene.second->material);
    const double                      strain_unit = unit_system.displacement / unit_system.length;
    std::vector<BoussinesqField<dim>> far_fields;
    std::vector<laws::Law>            laws;
    for (const Material &body : bodies)
      {
        far_fields.emplace_back(si ? body.youngs_modulus : body.youngs_modulus / E,
                                body.poisson_ratio);
        laws.push_back(law_of(body, unit_system.stress, strain_unit));
      }

    space =
      std::make_unique<Discretization<dim>>(triangulation, far_fields, options.element, processes);
    const bool curved = options.surface == Surface::sphere;
    contact_system =
      std::make_unique<ContactSystem<dim>>(*space,
                                           laws,
                                           Profile(si ? gap_radius : gap_radius / unit_radius,
                                                   curved ? (si ? 1 : a) / scene.radius : 0.),
                                           options.penalty_stiffness * (si ? E / a : 1.),
                                           options.condensation && dim == 2,
                                           linear_solver(options, space->n_free()));
  }

  template <int dim>
  LoadPath<dim> ContactModel<dim>::start_path(const unsigned int  loading_steps,
                                              const StepObserver &observer)
  {
    typename LoadPath<dim>::Options path_options;
    path_options.loading_steps   = loading_steps;
    path_options.unloading_steps = (loading_steps + 1) / 2;
    path_options.augment         = options.contact == ContactMethod::augmented;
    path_options.predict         = options.predictor;
    path_options.symmetry_factor = symmetry_factor();
    contact_system->reset();
    return LoadPath<dim>(*contact_system, path_options, observer);
  }

  template <int dim>
  std::vector<CurvePoint> ContactModel<dim>::run_to_peak(const unsigned int  loading_steps,
                                                         const StepObserver &observer)
  {
    LoadPath<dim>           path   = start_path(loading_steps, observer);
    std::vector<CurvePoint> branch = path.load(scene.force_max / unit_system.force(),
                                               peak_approach_guess / unit_system.displacement);
    take_counts(path);
    to_si(branch);
    return branch;
  }

  template <int dim>
  Curve ContactModel<dim>::run(const unsigned int           loading_steps,
                               const StepObserver          &observer,
                               const std::function<void()> &at_peak,
                               const std::function<void()> &at_end,
                               const Checkpoint            &checkpoint)
  {
    const std::string name = "run of " + std::to_string(loading_steps) + " ";
    if (const auto done = checkpoint.found.find(name + "loading"); done != checkpoint.found.end())
      {
        // A run before the one that was kept.
        for (const char *const part : {"loading", "unloading", "cut-backs"})
          finished[name + part] = checkpoint.found.at(name + part);
        counted           = {};
        counted.cut_backs = static_cast<unsigned int>(finished[name + "cut-backs"].front());
        return {points_of(finished[name + "loading"]), points_of(finished[name + "unloading"])};
      }

    LoadPath<dim>                    path = start_path(loading_steps, observer);
    typename LoadPath<dim>::Progress progress;
    const auto                       steps = checkpoint.found.find("steps");
    if (steps != checkpoint.found.end() && steps->second.front() == loading_steps)
      {
        path.restore(checkpoint.found);
        progress.loading   = points_of(checkpoint.found.at("loading"));
        progress.unloaded  = points_of(checkpoint.found.at("unloading"));
        progress.unloading = !progress.unloaded.empty();
      }
    std::function<void(const typename LoadPath<dim>::Progress &)> keep;
    if (checkpoint.keep)
      keep = [&](const typename LoadPath<dim>::Progress &reached) {
        Arrays all       = finished;
        all["steps"]     = {static_cast<double>(loading_steps)};
        all["loading"]   = numbers_of(reached.loading);
        all["unloading"] = numbers_of(reached.unloaded);
        all.merge(path.save());
        checkpoint.keep(all);
      };
    path.run(scene.force_max / unit_system.force(),
             peak_approach_guess / unit_system.displacement,
             progress,
             keep,
             at_peak);
    if (at_end)
      at_end();
    take_counts(path);
    Curve curve{progress.loading, progress.unloaded};
    to_si(curve.loading);
    to_si(curve.unloading);
    finished[name + "loading"]   = numbers_of(curve.loading);
    finished[name + "unloading"] = numbers_of(curve.unloading);
    finished[name + "cut-backs"] = {static_cast<double>(counted.cut_backs)};
    return curve;
  }

  template <int dim>
  std::vector<Curve> ContactModel<dim>::run_cycles(const unsigned int         loading_steps,
                                                   const std::vector<double> &forces,
                                                   const StepObserver        &observer)
  {
    LoadPath<dim>      path = start_path(loading_steps, observer);
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

  template <int dim>
  void ContactModel<dim>::take_counts(const LoadPath<dim> &path)
  {
    counted = path.counters();
    checked = path.checks();
    for (double PathChecks::*energy : {&PathChecks::work,
                                       &PathChecks::largest_work,
                                       &PathChecks::elastic_energy,
                                       &PathChecks::dissipation,
                                       &PathChecks::mean_dissipation,
                                       &PathChecks::energy_error})
      checked.*energy *= symmetry_factor() * unit_system.energy();
  }

  template <int dim>
  typename ContactModel<dim>::BranchedRun ContactModel<dim>::run(const Levels       &levels,
                                                                 const StepObserver &observer)
  {
    BranchedRun   run;
    LoadPath<dim> path     = start_path(1, observer);
    std::size_t   stop     = 0;
    const auto    at_level = [&](const double level) {
      run.levels.push_back(level);
      while (stop < levels.stops.size() && level >= levels.stops[stop] * (1 - 1e-12))
        {
          typename BranchedRun::Stop at;
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
        return levels.next(
          level,
          level > 0 ? present.approach / (symmetry_factor() * guess * level * level) : 1.,
          stop < levels.stops.size() ? levels.stops[stop] : 1.);
      },
      at_level);
    take_counts(path);
    to_si(run.loading);
    return run;
  }

  template <int dim>
  std::vector<PressurePoint> ContactModel<dim>::profile() const
  {
    std::vector<PressurePoint> result;
    for (const auto &[r, p] :
         contact_system->contact().profile(contact_system->u, contact_system->approach))
      if (p > 0)
        result.push_back({r * unit_system.length, p * unit_system.stress});
    return result;
  }

  template <int dim>
  double ContactModel<dim>::axisymmetry_deviation() const
  {
    struct Face
    {
      double radius, pressure, area;
    };
    const auto state = contact_system->contact().state(contact_system->u, contact_system->approach);
    std::vector<Face> faces;
    std::size_t       index   = 0;
    double            largest = 0;
    for (const auto &face : space->surface())
      {
        Face mean{0, 0, 0};
        bool touches = true;
        for (const auto &point : face.points)
          {
            const double p = state.pressure[index++];
            touches        = touches && (p > 0 || point.weight <= 0);
            mean.area += point.weight;
            mean.pressure += point.weight * p;
            mean.radius += point.weight * point.radius;
          }
        mean.pressure /= mean.area;
        mean.radius /= mean.area;
        if (touches)
          faces.push_back(mean);
        largest = std::max(largest, mean.pressure);
      }
    double covered = 0;
    for (const Face &face : faces)
      covered += face.area;
    // Bins of one element's width.
    const double                     width = std::sqrt(covered / static_cast<double>(faces.size()));
    std::map<int, std::vector<Face>> bins;
    for (const Face &face : faces)
      bins[static_cast<int>(face.radius / width)].push_back(face);
    constexpr std::size_t fewest = 4; // two say nothing about what differs from a straight line
    for (auto bin = bins.begin(); bin != bins.end() && std::next(bin) != bins.end();)
      if (const auto next = std::next(bin);
          bin->second.size() < fewest ||
          (std::next(next) == bins.end() && next->second.size() < fewest))
        {
          next->second.insert(next->second.end(), bin->second.begin(), bin->second.end());
          bin = bins.erase(bin);
        }
      else
        ++bin;
    double square = 0, area = 0;
    for (const auto &[bin, members] : bins)
      {
        double n = 0, x = 0, y = 0, xx = 0, xy = 0;
        for (const Face &face : members)
          {
            const double rr = face.radius * face.radius, pp = face.pressure * face.pressure;
            n += face.area, x += face.area * rr, y += face.area * pp;
            xx += face.area * rr * rr, xy += face.area * rr * pp;
          }
        const double spread = n * xx - x * x;
        const double slope  = spread > 1e-9 * n * xx ? (n * xy - x * y) / spread : 0.;
        for (const Face &face : members)
          {
            const double pp   = (y - slope * x) / n + slope * face.radius * face.radius;
            const double left = face.pressure - std::sqrt(std::max(0., pp));
            square += face.area * left * left;
            area += face.area;
          }
      }
    return area > 0 ? std::sqrt(square / area) / largest : 0.;
  }

  template <int dim>
  void ContactModel<dim>::to_si(std::vector<CurvePoint> &branch) const
  {
    for (auto &point : branch)
      {
        point.approach *= unit_system.displacement;
        point.force *= unit_system.force();
        point.contact_radius *= unit_system.length;
        point.pressure_max *= unit_system.stress;
        point.mises_stress_max *= unit_system.stress;
        point.plastic_volume *= unit_system.volume();
        point.dissipated_energy *= unit_system.energy();
        point.plastic_strain_max *= unit_system.displacement / unit_system.length;
      }
  }
  template <int dim>
  std::vector<std::vector<CurvePoint>> ContactModel<dim>::run_history(const std::vector<Leg> &legs,
                                                                      const StepObserver &observer)
  {
    LoadPath<dim>                        path    = start_path(1, observer);
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

  template class ContactModel<2>;
  template class ContactModel<3>;
} // namespace dpcontact
