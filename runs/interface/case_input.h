#ifndef DPCONTACT_RUNS_INTERFACE_CASE_INPUT_H
#define DPCONTACT_RUNS_INTERFACE_CASE_INPUT_H

#include "runs/interface/settings.h"
#include "solver/problem/case.h"

namespace dpcontact
{
  /// Material and scene: the criterion, and every entry of case_parameters(). All but the criterion
  /// are lists in a sweep.
  std::vector<Setting> scene_settings();

  /// Of a second body that differs from the first, for what case_parameters() say is its own:
  /// radius-2, E-2, nu-2, phi-2, sigma-c-2. What is not given is as of the first. radius-2 = flat
  /// is a half-space, E-2 = rigid a body that does not deform.
  std::vector<Setting> second_body_settings();

  /// One material and scene.
  /// @throws InputError where one is missing, ill-typed, a list, or out of range.
  Case read_case(const SettingTexts &texts);

  /// How many cases a grid may have.
  constexpr std::size_t largest_grid = 1000000;

  /// The grid of all combinations, in the order of scene_settings(), the first varying slowest.
  /// @throws InputError as read_case(), for a repeated value, and for more than `largest_grid` cases
  /// before any of them is made.
  std::vector<Case> read_grid(const SettingTexts &texts);

  /// Enters the second body that the texts describe, if any of its settings is given.
  /// @throws InputError where one is ill-typed or out of range, or given for a rigid body.
  void read_second_body(const SettingTexts &texts, Case &input);
} // namespace dpcontact

#endif
