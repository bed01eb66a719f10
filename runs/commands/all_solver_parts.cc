#include "database/tables/estimators.h"
#include "runs/commands/solver_parts.h"
#include "runs/interface/parameter_file.h"

namespace dpcontact::commands
{
  const SolverParts &all_solver_parts()
  {
    static const SolverParts parts{{{"yield-surface", add_yield_surface},
                                    {"solve", add_solve},
                                    {"converge", add_converge},
                                    {"sweep", add_sweep},
                                    {"merge", add_merge},
                                    {"evaluate", add_evaluate},
                                    {"hard-cases", add_hard_cases},
                                    {"validate", add_validate}},
                                   read_parameter_file,
                                   make_estimator};
    return parts;
  }
} // namespace dpcontact::commands
