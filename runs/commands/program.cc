#include "runs/commands/program.h"

#include "runs/commands/commands.h"
#include "runs/interface/version.h"
#include "solver/parallel/environment.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <iostream>
#include <new>
#include <thread>
#include <unistd.h>

namespace dpcontact
{
  namespace
  {
    std::string version_text()
    {
      std::string text = "dpcontact " + versions().at("dpcontact") + " (" + git_revision() + ")";
      for (const auto &[name, version] : versions())
        if (name != "dpcontact" && name != "git_revision")
          text += "\n  " + name + " " + version;
      return text;
    }

    ExitCode run(const int argc, const char *const *argv)
    {
      CLI::App program(
        "Force laws of the elastic-plastic contact of two Drucker-Prager spheres.\n"
        "Quantities are SI; suffixes such as 10GPa, 15MPa, 100mm, 100N are understood; "
        "angles are in degrees.",
        "dpcontact");
      program.set_version_flag("--version", version_text);
      program.require_subcommand(1);

      commands::Action action;
      commands::add_yield(program, action);
      commands::add_yield_surface(program, action);
      commands::add_solve(program, action);
      commands::add_converge(program, action);
      commands::add_sweep(program, action);
      commands::add_merge(program, action);
      commands::add_fit(program, action);
      commands::add_lookup(program, action);
      commands::add_evaluate(program, action);
      commands::add_check(program, action);
      commands::add_table(program, action);
      commands::add_export(program, action);
      commands::add_hard_cases(program, action);
      commands::add_compare(program, action);
      commands::add_validate(program, action);
      commands::add_collide(program, action);

      try
        {
          program.parse(argc, argv);
        }
      catch (const CLI::ParseError &error)
        {
          // Help and version are parse "errors" that succeed and go to standard output.
          return program.exit(error) == 0 ? ExitCode::success : ExitCode::usage;
        }
      return action();
    }

    /// Files that are opened later must not get the numbers of standard streams that were closed,
    /// or messages would land in them. Output to a stream that was closed still fails; messages go
    /// nowhere.
    void open_standard_streams()
    {
      for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(stream, F_GETFD) < 0 && errno == EBADF)
          (void)!::open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY);
    }

    int report(const std::string &kind, const std::string &message, const ExitCode code)
    {
      // What all processes of an MPI run see, one of them says: mpirun ends the others meanwhile.
      const char *const rank = std::getenv("OMPI_COMM_WORLD_RANK");
      if (launched_ranks() > 1 && rank != nullptr && std::string(rank) != "0")
        std::this_thread::sleep_for(std::chrono::seconds(1));
      std::cerr << "dpcontact: " << kind << ": " << message << std::endl;
      return static_cast<int>(code);
    }
  } // namespace

  int run_program(const int argc, const char *const *argv)
  {
    open_standard_streams();
    std::signal(SIGXFSZ, SIG_IGN); // a file that gets too large is an error of that file
    try
      {
        const ExitCode code = run(argc, argv);
        std::cout.flush();
        if (!std::cout)
          throw FileError("cannot write standard output");
        return static_cast<int>(code);
      }
    catch (const Error &error)
      {
        return report("error", error.what(), error.code());
      }
    catch (const std::bad_alloc &)
      {
        return report("error",
                      "there is not enough memory: see `ulimit -v`, or take a coarser mesh",
                      ExitCode::internal);
      }
    catch (const std::exception &error)
      {
        return report("internal error", error.what(), ExitCode::internal);
      }
    catch (...)
      {
        return report("internal error", "an exception of unknown type", ExitCode::internal);
      }
  }
} // namespace dpcontact
