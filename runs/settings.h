#ifndef DPCONTACT_RUNS_SETTINGS_H
#define DPCONTACT_RUNS_SETTINGS_H

#include "runs/quantity.h"
#include "solver/solve.h"

#include <map>
#include <string>
#include <vector>

namespace dpcontact
{
  /// Something that an option (--E) and an entry of a parameter file (set E = …) both say.
  struct Setting
  {
    enum class Kind
    {
      quantity, ///< a number with a dimension
      count,    ///< a non-negative integer
      choice,   ///< one of `choices`
      text      ///< anything but nothing
    };

    std::string              name;
    Kind                     kind;
    std::string              help;
    Dimension                dimension = Dimension::number;
    std::vector<std::string> choices   = {};
    bool                     list      = false; ///< a sweep takes several, separated by commas

    /// @throws InputError naming setting and text unless `text` is of this setting's type.
    void check(const std::string &text) const;
  };

  /// Material and scene: criterion, E, nu, phi, sigma-c or what the criterion has instead, and what
  /// else it has; radius, force-max or load-level. All but the criterion are lists in a sweep.
  std::vector<Setting> scene_settings();

  /// The options of the solver; each is one value for a whole sweep.
  std::vector<Setting> solver_settings();

  /// What has been set, by name, as it was typed. What is missing has its default.
  using SettingTexts = std::map<std::string, std::string>;

  /// One scene to compute.
  struct Case
  {
    Material material;
    Scene    scene;
    double   friction_angle_degrees; ///< as it was given, free of the rounding of radians
    double   dilation_angle_degrees; ///< likewise; the friction angle where none was given
  };

  /// One material and scene.
  /// @throws InputError where one is missing, ill-typed, a list, or out of range.
  Case read_case(const SettingTexts &texts);

  /// The grid of all combinations, in the order of scene_settings(), the first varying slowest.
  /// @throws InputError as read_case(), and for a repeated value.
  std::vector<Case> read_grid(const SettingTexts &texts);

  /// @throws InputError where one is ill-typed or out of range.
  SolverOptions read_solver_options(const SettingTexts &texts);
} // namespace dpcontact

#endif
