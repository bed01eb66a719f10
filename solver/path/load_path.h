#ifndef DPCONTACT_SOLVER_PATH_LOAD_PATH_H
#define DPCONTACT_SOLVER_PATH_LOAD_PATH_H

#include "solver/path/step_observer.h"
#include "solver/problem/curve.h"
#include "solver/system/arrays.h"
#include "solver/system/contact_system.h"
#include "solver/system/newton.h"
#include "solver/system/step_integrals.h"
#include "solver/system/unknowns.h"

#include <functional>
#include <string>
#include <vector>

namespace dpcontact
{
  /// Drives a ContactSystem up to a peak force and back to separation.
  ///
  /// Levels of the force are nominal: τ = (F/F_max)^(1/3), the growth of an elastic contact radius,
  /// in equal steps going up; t = (F/F_max)^(2/3), the elastic approach, going down. A step that
  /// Newton cannot make is rolled back and halved, and doubled again after easy ones, never beyond
  /// the nominal step: its size is what the accuracy of the load step is tied to. Numbers are in
  /// the system's own units.
  template <int dim>
  class LoadPath
  {
  public:
    struct Options
    {
      unsigned int loading_steps   = 20;
      unsigned int unloading_steps = 8;
      bool         augment         = true;
      bool         predict         = true; ///< extrapolate the last step into the next
      /// Approach and energies of the scene over those of the model: 2 of a half model.
      double        symmetry_factor       = 2;
      double        penetration_tolerance = 1e-6; ///< largest gap violation over the approach
      unsigned int  max_augmentations     = 20;
      unsigned int  max_cut_backs         = 10; ///< halvings of one nominal step
      NewtonOptions newton;
    };

    struct Counters
    {
      unsigned int steps = 0, newton_iterations = 0, cut_backs = 0, augmentations = 0,
                   apex_points = 0;
    };

    LoadPath(ContactSystem<dim> &system, const Options &options, const StepObserver &observer);

    /// From no contact to force `peak`, in the virgin state or released again. The first point is
    /// where the plane touches.
    /// @param peak_approach_guess guess of the plane's approach at the peak.
    /// @throws SolverError with the reason where the path ends early.
    std::vector<CurvePoint> load(double peak, double peak_approach_guess);

    /// The next level τ in (τ, 1] after the level τ that was reached with the given point.
    using NextLevel = std::function<double(double level, const CurvePoint &present)>;

    /// The same through levels of the caller's choice; `at_level(τ)` is called at each, and may
    /// call unload_and_return().
    std::vector<CurvePoint> load(double                             peak,
                                 double                             peak_approach_guess,
                                 const NextLevel                   &next_level,
                                 const std::function<void(double)> &at_level = {});

    /// unload() in `steps` steps, after which system and path are as before.
    std::vector<CurvePoint> unload_and_return(unsigned int steps);

    /// Where a path stands between two points of its curve: what save() and restore() carry.
    struct Progress
    {
      bool                    unloading = false; ///< branch of the next point
      std::vector<CurvePoint> loading, unloaded; ///< points so far; with the peak both have it
    };

    /// load() and unload(), in the steps of the options, going on from `progress` where that holds
    /// points. `keep` is called at every point but the peak and the last.
    void run(double                                       peak,
             double                                       peak_approach_guess,
             Progress                                    &progress,
             const std::function<void(const Progress &)> &keep,
             const std::function<void()>                 &at_peak);

    /// Everything that a path needs to go on from the present state, without its points. Every
    /// process gets all of it.
    Arrays save() const;
    /// @throws InputError where `saved` is not of this mesh and material.
    void restore(const Arrays &saved);

    /// From the present state to separation; the first point is the present one, the last is free
    /// of contact, its approach that at which the plane would touch the deformed surface.
    std::vector<CurvePoint> unload();

    /// The same in a number of steps that differs from the options'.
    std::vector<CurvePoint> unload(unsigned int steps);

    /// From the present state, in contact, to another force > 0, in `steps` equal steps of the
    /// force's own parameter (as load() up, as unload() down). The first point is the present one.
    std::vector<CurvePoint> to_force(double force, unsigned int steps);

    const Counters   &counters() const { return count; }
    const PathChecks &checks() const { return status.checked; }
    /// Newton's residuals in the last step, for convergence tests.
    const NewtonReport &last_newton() const { return report; }

  private:
    using Control = typename ContactSystem<dim>::Control;

    bool try_step(Control control, double target);
    void advance(const char                          *stage,
                 const std::function<double(double)> &force_of,
                 double                               from,
                 double                               to);
    /// Where a step starts from nothing the contact of before is forgotten, and the plane is moved
    /// to Hertz's approach; where it goes up, the subdomain is made to cover what it will reach.
    void prepare_contact(double level, double next);
    /// Moves the unknowns on along the secant of the last step in the force's own parameter, where
    /// there is one.
    void predict(double target);
    /// Makes the converged step of force `target` the history.
    void accept(const typename ContactSystem<dim>::Snapshot &before, double target);
    /// Says where the path ended and why.
    std::string failure(const char *stage) const;
    /// Numbers that belong to it.
    std::string failure_log() const;
    void        check(const StepIntegrals &integrals);
    CurvePoint  record();

    std::vector<CurvePoint> start_loading(double peak, double peak_approach_guess);
    std::vector<CurvePoint> start_unloading();
    /// The i-th of `steps` steps of unloading, and its point.
    void unload_step(unsigned int i, unsigned int steps, std::vector<CurvePoint> &points);
    void load_step(double level, double next, std::vector<CurvePoint> &points);

    ContactSystem<dim> &system;
    Options             options;
    StepObserver        observer;
    Counters            count;
    NewtonReport        report;

    /// What changes from step to step besides the system and the counters.
    struct Status
    {
      PathChecks    checked; ///< energies of the model
      double        peak_force          = 0;
      bool          unloading           = false;
      double        unloading_from      = 0; ///< force
      double        approach_guess      = 0; ///< at the peak
      double        dissipated          = 0;
      int           iterations_of_point = 0;
      double        present_force       = 0; ///< of the converged state
      double        last_force          = 0; ///< of the converged state before the present one
      StepIntegrals last_integrals;
      Unknowns      previous; ///< the converged ones before the present ones
      bool          has_previous = false;
    };
    Status status;
  };
} // namespace dpcontact

#endif
