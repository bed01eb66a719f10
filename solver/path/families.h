#ifndef DPCONTACT_SOLVER_PATH_FAMILIES_H
#define DPCONTACT_SOLVER_PATH_FAMILIES_H

#include "solver/path/solution.h"
#include "solver/path/step_observer.h"
#include "solver/problem/case.h"

#include <vector>

namespace dpcontact
{
  /// The numbers without dimension that a material's loading path depends on, besides the load
  /// level: ν, φ and what its criterion adds (K, ψ). Equal for the members of a family.
  std::vector<double> similarity_group(const Material &material);

  /// @throws InputError unless the material's scenes are similar for equal ν, φ, K, ψ and Λ:
  /// perfectly plastic Drucker–Prager.
  void check_similar(const Material &material);

  /// Computes all scenes of a similarity family (model section 4): with equal ν, φ, K and ψ, F/F_y
  /// depends on δ/δ_y alone while loading, and on Λ = F_max/F_y besides while unloading. So one
  /// loading path serves all members whose contact its mesh resolves, each unloaded from its own Λ.
  ///
  /// A path's mesh resolves contacts between half of its largest and that; with options.octaves = k
  /// from 2^−(k+1) on, by cells that shrink towards the centre. Small meshes and several paths are
  /// the cheaper way: the paths' common history costs little.
  ///
  /// Steps are equal in ln F, the finer the more the approach exceeds Hertz's; each path is
  /// computed with these steps and with halved ones, and extrapolated (smoothly where the contact's
  /// edge makes their difference jump, see step_extrapolation.h). Scenes below first yield are
  /// Hertz's. Resolution, contact and switches of `options` count as in solve_contact(); the steps
  /// do not follow its step_tolerance, `step_error` says what they left. `cost` of a member is its
  /// share of the family's.
  /// @return one solution a member, in SI units; `peak_axis` and `mesh_quality` are left out.
  /// @throws InputError where members differ in ν, φ, K or ψ, or as check_similar(), or a value is out of
  /// range; SolverError where a path cannot be completed.
  std::vector<Solution> solve_family(const std::vector<Case> &members,
                                     const SolverOptions     &options,
                                     const StepObserver      &observer = {});
} // namespace dpcontact

#endif
