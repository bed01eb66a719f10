#ifndef DPCONTACT_RUNS_COMMANDS_COMMANDS_H
#define DPCONTACT_RUNS_COMMANDS_COMMANDS_H

#include "meshing/errors.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <functional>

namespace dpcontact::commands
{
  /// What the chosen subcommand does once the whole command line has been understood.
  using Action = std::function<ExitCode()>;

  /// Gives a subcommand its options, and sets `action` when it is chosen.
  using AddOptions = void (*)(CLI::App &command, Action &action);

  void add_yield(CLI::App &command, Action &action);
  void add_yield_surface(CLI::App &command, Action &action);
  void add_solve(CLI::App &command, Action &action);
  void add_converge(CLI::App &command, Action &action);
  void add_sweep(CLI::App &command, Action &action);
  void add_merge(CLI::App &command, Action &action);
  void add_fit(CLI::App &command, Action &action);
  void add_lookup(CLI::App &command, Action &action);
  void add_evaluate(CLI::App &command, Action &action);
  void add_check(CLI::App &command, Action &action);
  void add_table(CLI::App &command, Action &action);
  void add_export(CLI::App &command, Action &action);
  void add_hard_cases(CLI::App &command, Action &action);
  void add_compare(CLI::App &command, Action &action);
  void add_validate(CLI::App &command, Action &action);
  void add_collide(CLI::App &command, Action &action);
} // namespace dpcontact::commands

#endif
