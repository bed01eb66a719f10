#ifndef DPCONTACT_RUNS_COMMANDS_PROGRAM_H
#define DPCONTACT_RUNS_COMMANDS_PROGRAM_H

namespace dpcontact
{
  namespace commands
  {
    struct SolverParts;
  }

  /// Runs the command line of `dpcontact` and returns the exit code (meshing/errors.h). Results go
  /// to standard output, messages and progress to standard error. Never throws.
  /// @param parts null: what needs them is left to `dpcontact-solver`.
  int run_program(int argc, const char *const *argv, const commands::SolverParts *parts);
} // namespace dpcontact

#endif
