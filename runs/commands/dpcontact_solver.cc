#include "runs/commands/program.h"
#include "runs/commands/solver_parts.h"
#include "solver/parallel/environment.h"

namespace
{
  void before_all(int, char **, char **environment)
  {
    dpcontact::set_aside_bad_threads(environment);
  }

  /// The loader calls what stands here before any library starts.
  [[maybe_unused,
    gnu::used,
    gnu::section(".preinit_array")]] void (*const first_call)(int, char **, char **) = before_all;
} // namespace

int main(const int argc, const char *const *argv)
{
  return dpcontact::run_program(argc, argv, &dpcontact::commands::all_solver_parts());
}
