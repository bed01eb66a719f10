#ifndef DPCONTACT_RUNS_COMMANDS_SWEEP_OPTIONS_H
#define DPCONTACT_RUNS_COMMANDS_SWEEP_OPTIONS_H

#include "runs/interface/settings.h"
#include "runs/sweep/sweep.h"

#include <CLI/App.hpp>

#include <string>
#include <vector>

namespace dpcontact::commands
{
  /// jobs, mode, database: what a sweep has besides material, scene and solver.
  std::vector<Setting> sweep_settings();

  /// --replace.
  void add_replace_flag(CLI::App &command, bool &replace);

  /// The whole grid of a parameter file and what the command line says about it.
  /// @throws InputError for a value that is wrong, and for jobs under MPI; FileError.
  Sweep read_sweep(const std::string &parameter_file, const SettingTexts &given);
} // namespace dpcontact::commands

#endif
