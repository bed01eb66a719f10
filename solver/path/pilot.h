#ifndef DPCONTACT_SOLVER_PATH_PILOT_H
#define DPCONTACT_SOLVER_PATH_PILOT_H

#include "solver/path/contact_model.h"
#include "solver/path/solution.h"
#include "solver/path/step_observer.h"

namespace dpcontact
{
  /// Ratio of the peak's approach to Hertz's beyond which an edge that moves from node to node
  /// would be felt: at Λ = 3532 (ratio 1.36) the phase between edge and nodes moves δ_max
  /// by 0.13 % without, by 0.02 % with one more halving of the cells at the surface.
  constexpr double strongly_plastic = 1.22;

  /// Steps of the curve of a scene that yields nowhere.
  constexpr unsigned int elastic_steps = 64;

  /// What coarse runs tell about the peak.
  struct Pilot
  {
    double contact_radius; ///< m
    double approach;       ///< over Hertz's
  };

  /// Coarse runs on meshes fitted better and better; Hertz where nothing yields.
  Pilot run_pilots(const Material     &material,
                   const Scene        &scene,
                   const FirstYield   &yield,
                   Cost               &cost,
                   const StepObserver &observer);

  /// Adds what the model's last run cost.
  template <int dim>
  void add_cost(Cost &cost, const ContactModel<dim> &model)
  {
    cost.dofs = model.discretisation().n_free();
    cost.steps += model.counters().steps;
    cost.newton_iterations += model.counters().newton_iterations;
    cost.cut_backs += model.counters().cut_backs;
  }
} // namespace dpcontact

#endif
