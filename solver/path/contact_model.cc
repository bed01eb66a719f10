#include "solver/path/contact_model.h"

#include "meshing/partition.h"
#include "solver/closed_form/hertz.h"
#include "solver/laws/law.h"
#include "solver/path/model_mesh.h"

#include <algorithm>
#include <cmath>

namespace dpcontact
{
  namespace
  {
    /// The materials that deform: one of two identical bodies.
    std::vector<Material> deformable_bodies(const Material &material, const Scene &scene)
    {
      std::vector<Material> bodies{material};
      if (scene.second && scene.second->material)
        bodies.push_back(*scene.second->material);
      return bodies;
    }

    double softest_modulus(const std::vector<Material> &bodies)
    {
      double modulus = bodies.front().youngs_modulus;
      for (const Material &body : bodies)
        modulus = std::min(modulus, body.youngs_modulus);
      return modulus;
    }

    /// @param E Young's modulus that becomes 1 in scaled units.
    UnitSystem units_of(const Scene         &scene,
                        const SolverOptions &options,
                        const double         mesh_radius,
                        const double         E)
    {
      const double a     = mesh_radius;
      const double R     = 2 * scene.effective_radius();
      UnitSystem   units = options.units == Units::si ? UnitSystem{1, 1, 1, 1}
                                                      : UnitSystem{a, a * a / R, E * a / R, 1};
      units.share        = in_space(options.geometry) ? options.angle() / (2 * M_PI) : 1;
      return units;
    }

    /// The model's gap r²/(2R), of one sphere or of both, or that of the sphere itself.
    UndeformedGap gap_of(const Scene &scene, const SolverOptions &options, const double mesh_radius)
    {
      const bool   si          = options.units == Units::si;
      const double gap_radius  = 2 * scene.effective_radius() / (scene.second ? 2 : 1);
      const double unit_radius = 2 * scene.effective_radius();
      const bool   curved      = options.surface == Surface::sphere;
      return UndeformedGap(si ? gap_radius : gap_radius / unit_radius,
                           curved ? (si ? 1 : mesh_radius) / scene.radius : 0.);
    }
  } // namespace

  template <int dim>
  ContactModel<dim>::ContactModel(const Material      &material,
                                  const Scene         &scene,
                                  const SolverOptions &options_,
                                  const double         mesh_radius,
                                  const Communicator  &processes)
    : model_scene(scene)
    , options(options_)
    , peak_approach(hertz::approach(material, scene, scene.force_max) / symmetry_factor())
  {
    const bool                  si     = options.units == Units::si;
    const std::vector<Material> bodies = deformable_bodies(material, scene);
    const double                E      = softest_modulus(bodies);
    unit_system                        = units_of(scene, options, mesh_radius, E);
    mesh_quality = make_model_mesh(options, mesh_radius, scene.radius, triangulation);
    if (!processes.alone())
      partition(processes.size(), triangulation);

    std::vector<BoussinesqField<dim>> far_fields;
    std::vector<laws::Law>            laws;
    for (const Material &body : bodies)
      {
        far_fields.emplace_back(si ? body.youngs_modulus : body.youngs_modulus / E,
                                body.poisson_ratio);
        laws.push_back(law_of(body, unit_system.stress, unit_system.strain()));
      }
    space =
      std::make_unique<Discretisation<dim>>(triangulation, far_fields, options.element, processes);
    contact_system = std::make_unique<ContactSystem<dim>>(
      *space,
      laws,
      gap_of(scene, options, mesh_radius),
      options.penalty_stiffness * (si ? E / mesh_radius : 1.),
      options.condensation && dim == 2 ? Condensation::nested_subdomains : Condensation::none,
      linear_solver(options, space->n_free()));
  }

  template <int dim>
  double ContactModel<dim>::hertz_approach(const double force) const
  {
    return peak_approach / unit_system.displacement *
           std::pow(force / model_scene.force_max, 2. / 3);
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
  void ContactModel<dim>::end_path(const LoadPath<dim> &path)
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
  void ContactModel<dim>::end_known_path(const unsigned int cut_backs)
  {
    counted           = {};
    counted.cut_backs = cut_backs;
  }

  template class ContactModel<2>;
  template class ContactModel<3>;
} // namespace dpcontact
