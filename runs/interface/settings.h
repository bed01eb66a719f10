#ifndef DPCONTACT_RUNS_INTERFACE_SETTINGS_H
#define DPCONTACT_RUNS_INTERFACE_SETTINGS_H

#include "solver/laws/parameter.h"
#include "solver/problem/options.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace dpcontact
{
  /// Something that an option (--E) and an entry of a parameter file (set E = …) both say.
  struct Setting
  {
    std::string name;
    std::string help;
    /// Throws InputError naming setting and text unless the text is of this setting's type.
    std::function<void(const std::string &)> check;
  };

  /// A number with a dimension; of a `list` several, separated by commas.
  Setting quantity_setting(const std::string &name,
                           const std::string &help,
                           Dimension          dimension,
                           bool               list = false);
  /// A non-negative integer.
  Setting count_setting(const std::string &name, const std::string &help);
  /// One of some words.
  Setting choice_setting(const std::string              &name,
                         const std::string              &help,
                         const std::vector<std::string> &choices);
  /// Anything but nothing.
  Setting text_setting(const std::string &name, const std::string &help);

  std::vector<Setting> operator+(std::vector<Setting> left, const std::vector<Setting> &right);

  /// What has been set, by name, as it was typed. What is missing has its default.
  using SettingTexts = std::map<std::string, std::string>;

  /// The text of a setting, where it is set.
  std::optional<std::string> find(const SettingTexts &texts, const std::string &name);

  /// The options of the solver; each is one value for a whole sweep.
  std::vector<Setting> solver_settings();

  /// @throws InputError where one is ill-typed or out of range.
  SolverOptions read_solver_options(const SettingTexts &texts);
} // namespace dpcontact

#endif
