#include "runs/commands/solver_parts.h"

#include "meshing/errors.h"

#include <cerrno>
#include <cstring>
#include <unistd.h>

namespace dpcontact::commands
{
  void continue_in_solver(const char *const *argv, const SolverNeeded &needed)
  {
    std::error_code             unknown;
    const std::filesystem::path own    = std::filesystem::read_symlink("/proc/self/exe", unknown);
    const std::filesystem::path solver = own.parent_path() / "dpcontact-solver";
    ::execv(solver.c_str(), const_cast<char *const *>(argv));
    throw FileError(needed.what + " needs the solver, but " + solver.string() +
                    " cannot be started: " + std::strerror(errno));
  }
} // namespace dpcontact::commands
