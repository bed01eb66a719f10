#ifndef DPCONTACT_RUNS_COMMANDS_PROGRAM_H
#define DPCONTACT_RUNS_COMMANDS_PROGRAM_H

namespace dpcontact
{
  /// Runs the command line of `dpcontact` and returns the exit code (meshing/errors.h). Results go
  /// to standard output, messages and progress to standard error. Never throws.
  int run_program(int argc, const char *const *argv);
} // namespace dpcontact

#endif
