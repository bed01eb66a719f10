#ifndef DPCONTACT_SOLVER_CONTACT_MODEL_H
#define DPCONTACT_SOLVER_CONTACT_MODEL_H

#include "meshing/zones.h"
#include "solver/checkpoint.h"
#include "solver/contact_system.h"
#include "solver/load_path.h"
#include "solver/solve.h"

#include <deal.II/grid/tria.h>

#include <memory>

namespace dpcontact
{
  /// The units in which a model is solved, as factors to SI.
  ///
  /// Scaled: lengths by the contact radius a, displacements by a²/R, stresses by E a/R, and E, a, R
  /// are 1; for two bodies R is 2R* and E that of the softer. Small strain lets lengths and
  /// displacements have units of their own; a/R then drops out, and only ν, φ and the load level
  /// stay. A sphere's surface brings a/R back, as the curvature of the mesh and in the gap, and
  /// nowhere else.
  struct UnitSystem
  {
    double length, displacement, stress;
    double share =
      1; ///< of the bodies that the mesh covers: a wedge carries that share of the force
    double force() const { return stress * volume() / length; }
    double volume() const { return length * length * length / share; }
    double energy() const { return force() * displacement; }
  };

  /// One scene on one mesh: what solve_contact() is made of. Two identical spheres are a half
  /// model, one of them under the mirror plane; others are modelled both, unless one is rigid. A
  /// body is the half-space, or the sphere's cap within the far boundary where options.surface says
  /// so; beyond the far boundary the half-space's exterior serves both. dim = 2 is axisymmetry, dim
  /// = 3 a wedge of space or all of it, over all processes of the communicator.
  template <int dim>
  class ContactModel
  {
  public:
    /// @param mesh_radius contact radius that the mesh is fitted to, m.
    /// @throws InputError naming domain-radius where a sphere's far boundary lies beyond its radius.
    ContactModel(const Material      &material,
                 const Scene         &scene,
                 const SolverOptions &options,
                 double               mesh_radius,
                 const Communicator  &processes = Communicator());

    /// Scenes' approach and energies over the model's.
    double symmetry_factor() const { return scene.second ? 1 : 2; }

    /// Runs the whole path with `loading_steps` steps up and half as many down, from the virgin
    /// state.
    /// @param at_peak called at the peak, @param at_end after release; may be empty.
    /// @param checkpoint where the run, and those before it, are kept after every step, and taken
    /// up where it holds one of that many steps.
    Curve run(unsigned int                 loading_steps,
              const StepObserver          &observer,
              const std::function<void()> &at_peak    = {},
              const std::function<void()> &at_end     = {},
              const Checkpoint            &checkpoint = {});

    /// Cycles of loading, to each of the forces (N), and release, from the virgin state.
    std::vector<Curve> run_cycles(unsigned int               loading_steps,
                                  const std::vector<double> &forces,
                                  const StepObserver        &observer);

    /// One leg of a history of forces: from where the last one ended to `force` (N; 0 releases).
    struct Leg
    {
      double       force;
      unsigned int steps;
    };

    /// The legs of a history, from the virgin state; each begins with the last point of the one
    /// before. After a release the next one loads anew.
    std::vector<std::vector<CurvePoint>> run_history(const std::vector<Leg> &legs,
                                                     const StepObserver     &observer);

    /// The loading branch alone, from the virgin state.
    std::vector<CurvePoint> run_to_peak(unsigned int loading_steps, const StepObserver &observer);

    /// A loading branch from which several unloading branches leave.
    struct Levels
    {
      std::vector<double> stops; ///< (F/F_max)^⅓ where to unload, ascending; the last is 1
      std::function<unsigned int(std::size_t stop)> unloading_steps;
      /// The next level after `level`, at most the next stop. `approach_ratio`: δ over Hertz's at
      /// `level`.
      std::function<double(double level, double approach_ratio, double stop)> next;
    };
    struct BranchedRun
    {
      struct Stop
      {
        std::size_t                loading_points; ///< of the loading branch up to this stop
        std::vector<CurvePoint>    unloading;
        std::vector<PressurePoint> profile;
      };
      std::vector<double>     levels; ///< of the loading branch's points, without the origin
      std::vector<CurvePoint> loading;
      std::vector<Stop>       stops;
    };
    BranchedRun run(const Levels &levels, const StepObserver &observer);

    /// Contact pressure of the present state, from the axis outwards, where it is positive.
    std::vector<PressurePoint> profile() const;

    /// How far the present contact pressure is from axisymmetric: rms over the area of what the
    /// faces' means differ by from a profile of r alone (p² linear in r², as in Hertz, over every
    /// width of an element, or of the several that hold four faces), over the largest of them.
    /// Faces across the edge are left out.
    double axisymmetry_deviation() const;

    const UnitSystem                       &units() const { return unit_system; }
    const ContactSystem<dim>               &system() const { return *contact_system; }
    const Discretization<dim>              &discretization() const { return *space; }
    const typename LoadPath<dim>::Counters &counters() const { return counted; }
    const PathChecks                       &checks() const { return checked; }
    const MeshQuality                      &quality() const { return mesh_quality; }

  private:
    LoadPath<dim> start_path(unsigned int loading_steps, const StepObserver &observer);
    void          make_mesh(double mesh_radius);
    void          to_si(std::vector<CurvePoint> &branch) const;
    void          take_counts(const LoadPath<dim> &path);

    Scene                                scene;
    SolverOptions                        options;
    UnitSystem                           unit_system;
    double                               peak_approach_guess; ///< of the model, m
    dealii::Triangulation<dim>           triangulation;
    MeshQuality                          mesh_quality;
    std::unique_ptr<Discretization<dim>> space;
    std::unique_ptr<ContactSystem<dim>>  contact_system;
    typename LoadPath<dim>::Counters     counted;
    PathChecks                           checked;
    Arrays                               finished; ///< curves of finished runs, for a checkpoint
  };

  /// In axisymmetry.
  using HalfSpaceModel = ContactModel<2>;
} // namespace dpcontact

#endif
