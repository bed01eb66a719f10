#ifndef DPCONTACT_SOLVER_PATH_CONTACT_MODEL_H
#define DPCONTACT_SOLVER_PATH_CONTACT_MODEL_H

#include "meshing/mesh_quality.h"
#include "solver/path/load_path.h"
#include "solver/path/solve.h"
#include "solver/path/step_observer.h"
#include "solver/problem/unit_system.h"
#include "solver/system/contact_system.h"

#include <deal.II/grid/tria.h>

#include <memory>

namespace dpcontact
{
  /// One scene on one mesh: what solve_contact() is made of; runs.h drives it. Two identical
  /// spheres are a half model, one of them under the mirror plane; others are modelled both, unless
  /// one is rigid. A body is the half-space, or the sphere's cap within the far boundary where
  /// options.surface says so; beyond the far boundary the half-space's exterior serves both. dim =
  /// 2 is axisymmetry, dim = 3 a wedge of space or all of it, over all processes of the
  /// communicator.
  template <int dim>
  class ContactModel
  {
  public:
    using Counters = typename LoadPath<dim>::Counters;

    /// @param mesh_radius contact radius that the mesh is fitted to, m.
    /// @throws InputError naming domain-radius where a sphere's far boundary lies beyond its
    /// radius.
    ContactModel(const Material      &material,
                 const Scene         &scene,
                 const SolverOptions &options,
                 double               mesh_radius,
                 const Communicator  &processes = Communicator());

    /// The scene's approach and energies over the model's: 2 of a half model.
    double symmetry_factor() const { return model_scene.second ? 1 : 2; }
    /// The scene's F_max in the model's units.
    double peak_force() const { return model_scene.force_max / unit_system.force(); }
    /// The model's approach at a force (N) by Hertz, in its units.
    double hertz_approach(double force) const;

    /// A path that begins in the virgin state, to which the model is set back.
    /// @param loading_steps up to the peak; half as many lead down again.
    LoadPath<dim> start_path(unsigned int loading_steps, const StepObserver &observer);
    /// Takes over what a path that has ended counted and checked.
    void end_path(const LoadPath<dim> &path);
    /// The same of a path whose cut-backs alone are known.
    void end_known_path(unsigned int cut_backs);

    const Scene               &scene() const { return model_scene; }
    const UnitSystem          &units() const { return unit_system; }
    const ContactSystem<dim>  &system() const { return *contact_system; }
    const Discretisation<dim> &discretisation() const { return *space; }
    const MeshQuality         &quality() const { return mesh_quality; }

    // Of the path that ended last; energies of the scene in J.
    const Counters   &counters() const { return counted; }
    const PathChecks &checks() const { return checked; }

  private:
    Scene                                model_scene;
    SolverOptions                        options;
    UnitSystem                           unit_system;
    double                               peak_approach; ///< of the model, by Hertz, m
    dealii::Triangulation<dim>           triangulation;
    MeshQuality                          mesh_quality;
    std::unique_ptr<Discretisation<dim>> space;
    std::unique_ptr<ContactSystem<dim>>  contact_system;
    Counters                             counted;
    PathChecks                           checked;
  };

  /// In axisymmetry.
  using HalfSpaceModel = ContactModel<2>;
} // namespace dpcontact

#endif
