#ifndef DPCONTACT_RUNS_COMMANDS_SOLVER_PARTS_H
#define DPCONTACT_RUNS_COMMANDS_SOLVER_PARTS_H

#include "database/tables/lookup.h"
#include "runs/commands/commands.h"
#include "runs/interface/settings.h"

#include <map>
#include <string>

namespace dpcontact::commands
{
  /// What takes deal.II, PETSc, gmsh, OpenTURNS or CGAL, which load for half a second. The program
  /// `dpcontact` does without them and so starts at once; `dpcontact-solver` has them.
  struct SolverParts
  {
    std::map<std::string, AddOptions> commands; ///< by their names
    SettingTexts (*read_parameter_file)(const std::filesystem::path &,
                                        const std::vector<Setting> &);
    EstimatorMaker make_estimator;
  };

  /// Thrown where a program without these parts needs one: run_program() then leaves its whole
  /// command line to `dpcontact-solver`. So nothing may have been written or printed before.
  struct SolverNeeded
  {
    std::string what; ///< needs it
  };

  /// The parts of this program. @throws SolverNeeded where it has none.
  const SolverParts &solver_parts(const std::string &what);

  /// Those of `dpcontact-solver`.
  const SolverParts &all_solver_parts();

  /// Replaces this process by `dpcontact-solver`, beside this program, with the same arguments.
  /// @throws FileError where there is none.
  [[noreturn]] void continue_in_solver(const char *const *argv, const SolverNeeded &needed);
} // namespace dpcontact::commands

#endif
