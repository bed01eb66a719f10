#ifndef DPCONTACT_RUNS_COMMANDS_OPTIONS_H
#define DPCONTACT_RUNS_COMMANDS_OPTIONS_H

#include "runs/interface/settings.h"

#include <CLI/App.hpp>

#include <functional>
#include <string>
#include <vector>

namespace dpcontact::commands
{
  /// Adds --NAME for every setting; what is given is stored in `texts` and checked later.
  void add_settings(CLI::App                   &command,
                    const std::vector<Setting> &settings,
                    SettingTexts               &texts,
                    const std::string          &group);

  /// As add_settings(), of those that `shown` holds for; the others are understood, and refused
  /// where they must be, but stand in no help.
  void add_settings(CLI::App                                   &command,
                    const std::vector<Setting>                 &settings,
                    SettingTexts                               &texts,
                    const std::string                          &group,
                    const std::function<bool(const Setting &)> &shown);

  /// Adds --parameter-file.
  void add_parameter_file(CLI::App &command, std::string &file);

  /// Adds --json.
  void add_json_flag(CLI::App &command, bool &json);

  /// The entries of a parameter file (an empty name: none), overridden by what the command line
  /// says.
  SettingTexts merged(const std::string          &parameter_file,
                      const std::vector<Setting> &allowed,
                      const SettingTexts         &command_line);
} // namespace dpcontact::commands

#endif
