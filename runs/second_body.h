#ifndef DPCONTACT_RUNS_SECOND_BODY_H
#define DPCONTACT_RUNS_SECOND_BODY_H

#include "runs/settings.h"

namespace dpcontact
{
  /// Settings of a second body that differs from the first: radius-2, E-2, nu-2, phi-2, sigma-c-2.
  /// What is not given is as of the first. radius-2 = flat is a half-space, E-2 = rigid a body that
  /// does not deform.
  std::vector<Setting> second_body_settings();

  /// Enters the second body that the texts describe, if any of its settings is given.
  /// @throws InputError where one is ill-typed or out of range, or given for a rigid body.
  void read_second_body(const SettingTexts &texts, Case &input);
} // namespace dpcontact

#endif
