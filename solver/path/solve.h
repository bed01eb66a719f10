#ifndef DPCONTACT_SOLVER_PATH_SOLVE_H
#define DPCONTACT_SOLVER_PATH_SOLVE_H

#include "solver/output/field_sink.h"
#include "solver/parallel/communicator.h"
#include "solver/path/step_observer.h"
#include "solver/problem/options.h"
#include "solver/problem/scene.h"
#include "solver/system/checkpoint.h"

namespace dpcontact
{
  struct Solution;

  /// Computes one loading–unloading curve of two spheres by finite elements.
  /// @param fields is given the VTU files of the peak and the released state; none: they are not made.
  /// @param processes that solve it together, in space; all get the same solution.
  /// @param checkpoint a state that was kept to go on from, and how to keep the next ones.
  /// @throws InputError for values out of range, SolverError where the load path cannot be completed.
  Solution solve_contact(const Material      &material,
                         const Scene         &scene,
                         const SolverOptions &options,
                         const FieldSink     &fields     = {},
                         const StepObserver  &observer   = {},
                         const Communicator  &processes  = Communicator(),
                         const Checkpoint    &checkpoint = {});
} // namespace dpcontact

#endif
