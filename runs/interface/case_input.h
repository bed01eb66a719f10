#ifndef DPCONTACT_RUNS_INTERFACE_CASE_INPUT_H
#define DPCONTACT_RUNS_INTERFACE_CASE_INPUT_H

#include "runs/interface/settings.h"
#include "solver/problem/case.h"

namespace dpcontact
{
  /// The criterion and the material's entries of case_parameters().
  std::vector<Setting> material_settings();

  /// Those, and the radius.
  std::vector<Setting> body_settings();

  /// Material and scene: the criterion, and every entry of case_parameters(). All but the criterion
  /// are lists in a sweep.
  std::vector<Setting> scene_settings();

  /// Of a second body that differs from the first: radius-2, E-2, nu-2, cohesion-2 …, for all
  /// case_parameters() but the force. What is not given is as given of the first: where that has a
  /// cohesion, a phi-2 leaves the cohesion, not the strength that follows from it. radius-2 = flat
  /// is a half-space, E-2 = rigid a body that does not deform.
  std::vector<Setting> second_body_settings();

  /// One material and scene, with the second body where any of its settings is given.
  /// @throws InputError where one is missing, ill-typed, a list, or out of range, for a material of a
  /// rigid body, and for what check_possible() refuses.
  Case read_case(const SettingTexts &texts);

  /// The first body alone, for what depends on no force: that of the case is the default, and
  /// nothing is asked of it.
  /// @throws InputError as read_case().
  Case read_body(const SettingTexts &texts);

  /// How many cases a grid may have.
  constexpr std::size_t largest_grid = 1000000;

  /// The grid of all combinations, in the order of scene_settings(), the first varying slowest.
  /// @throws InputError as read_case(), for a repeated value, and for more than `largest_grid` cases
  /// before any of them is made.
  std::vector<Case> read_grid(const SettingTexts &texts);
} // namespace dpcontact

#endif
