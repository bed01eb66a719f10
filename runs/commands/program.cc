#include "runs/commands/program.h"

#include "runs/commands/solver_parts.h"
#include "runs/interface/spelling.h"
#include "runs/interface/version.h"
#include "solver/parallel/launcher.h"

#include <algorithm>
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

    struct Command
    {
      const char          *name, *help;
      commands::AddOptions add_options; ///< null: SolverParts has it
    };

    /// In the order of --help.
    const Command all_commands[] = {
      {"yield", "First yield in closed form, on the axis and on the ring", commands::add_yield},
      {"yield-surface", "Points of the yield surface as it is implemented, as CSV", nullptr},
      {"solve", "One loading-unloading curve by finite elements, and its fit", nullptr},
      {"converge",
       "The error of each coefficient by source, from at least three levels of each",
       nullptr},
      {"sweep",
       "A grid of materials and scenes over worker processes, or the ranks of mpirun; resumes "
       "where it stopped. Lists are separated by commas.",
       nullptr},
      {"merge",
       "The database of a grid from the rows of its shards (sweep --shard). Options must be those "
       "of the sweep.",
       nullptr},
      {"fit", "Fits the curves of a database again and compares", commands::add_fit},
      {"lookup", "The force law of a material and scene, from a table", commands::add_lookup},
      {"evaluate",
       "The paper's evaluation: regression, table 4, and how wrong every method is",
       nullptr},
      {"check",
       "Checks the data of a database; exit code 8 where a row is wrong",
       commands::add_check},
      {"table",
       "The universal table from a sweep over nu, phi and load levels",
       commands::add_table},
      {"export", "The table of a database in other formats", commands::add_export},
      {"hard-cases",
       "Scenes at the edge of what the solver is for, and what became of each",
       nullptr},
      {"compare",
       "Coefficients of one database against those of another, row by row",
       commands::add_compare},
      {"validate",
       "The contact law against finite elements: stored rows, unseen materials and paths",
       nullptr},
      {"collide",
       "Two spheres meet head on: the contact law integrated from touch to separation",
       commands::add_collide}};

    const commands::SolverParts *parts_of_program = nullptr;

    /// Takes whatever is said to the command, for the program that knows its options.
    void leave_to_solver(CLI::App &command, commands::Action &action)
    {
      command.prefix_command();
      command.set_help_flag();
      command.callback([&action, name = command.get_name()] {
        action = [name]() -> ExitCode { throw commands::SolverNeeded{name}; };
      });
    }

    /// "--sigma_c" of "--sigma_c=3".
    std::string name_of(const std::string &argument)
    {
      return argument.substr(0, argument.find('='));
    }

    /// What was wrong with the command line, in one line, and what may have been meant.
    std::string message_of(const CLI::ParseError &error, const CLI::App &program)
    {
      const auto        used = program.get_subcommands();
      const std::string name = used.empty() ? "" : used.front()->get_name();
      const std::string more =
        "; `dpcontact " + name + (name.empty() ? "" : " ") + "--help` says what there is";
      if (used.empty())
        return "a command is missing" + more;
      std::vector<std::string> options;
      for (const CLI::Option *const option : used.front()->get_options())
        for (const std::string &known : option->get_lnames())
          options.push_back("--" + known);
      for (const std::string &argument : used.front()->remaining(true))
        if (argument.rfind("--", 0) == 0)
          return name + " has no option " + name_of(argument) +
                 suggestion(name_of(argument), options) + more;
      std::string what = error.what();
      std::replace(what.begin(), what.end(), '\n', ' ');
      // CLI11's own words for two common slips
      for (const auto &[words, plain] :
           {std::pair{": At Most 1 required but received", " is given more than once:"},
            std::pair{": 1 required  missing", " needs a value"}})
        if (const auto at = what.find(words); at != std::string::npos)
          what.replace(at, std::string(words).size(), plain);
      return name + ": " + what + more;
    }

    std::vector<std::string> command_names()
    {
      std::vector<std::string> names;
      for (const Command &one : all_commands)
        names.emplace_back(one.name);
      return names;
    }

    void require_command(const std::string &word)
    {
      const auto names = command_names();
      if (std::find(names.begin(), names.end(), word) == names.end())
        throw UsageError("there is no command '" + word + "'" + suggestion(word, names) +
                         "; `dpcontact --help` lists them");
    }

    ExitCode run(int argc, const char *const *argv);

    /// `dpcontact help` and `dpcontact help COMMAND`, as people try them.
    ExitCode help(const int argc, const char *const *const argv)
    {
      std::vector<const char *> words{argv[0]};
      if (argc > 2)
        {
          require_command(argv[2]);
          words.push_back(argv[2]);
        }
      words.push_back("--help");
      return run(static_cast<int>(words.size()), words.data());
    }

    ExitCode run(const int argc, const char *const *argv)
    {
      if (argc > 1 && std::string(argv[1]) == "help")
        return help(argc, argv);
      if (argc > 1 && argv[1][0] != '-')
        require_command(argv[1]);
      CLI::App program(
        "Force laws of the elastic-plastic contact of two Drucker-Prager spheres.\n"
        "Quantities are SI; suffixes such as 10GPa, 15MPa, 100mm, 100N are understood; "
        "angles are in degrees.",
        "dpcontact");
      program.set_version_flag("--version", version_text);
      program.require_subcommand(1);

      commands::Action action;
      for (const Command &one : all_commands)
        {
          CLI::App *const command = program.add_subcommand(one.name, one.help);
          if (one.add_options != nullptr)
            one.add_options(*command, action);
          else if (parts_of_program != nullptr)
            parts_of_program->commands.at(one.name)(*command, action);
          else
            leave_to_solver(*command, action);
        }

      try
        {
          program.parse(argc, argv);
        }
      catch (const CLI::ParseError &error)
        {
          // Help and version are parse "errors" that succeed and go to standard output.
          if (error.get_exit_code() == 0)
            return static_cast<ExitCode>(program.exit(error));
          throw UsageError(message_of(error, program));
        }
      return action();
    }

    ExitCode run_or_leave(const int argc, const char *const *argv)
    {
      try
        {
          return run(argc, argv);
        }
      catch (const commands::SolverNeeded &needed)
        {
          commands::continue_in_solver(argv, needed);
        }
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

  const commands::SolverParts &commands::solver_parts(const std::string &what)
  {
    if (parts_of_program == nullptr)
      throw SolverNeeded{what};
    return *parts_of_program;
  }

  int run_program(const int argc, const char *const *argv, const commands::SolverParts *const parts)
  {
    parts_of_program = parts;
    open_standard_streams();
    std::signal(SIGXFSZ, SIG_IGN); // a file that gets too large is an error of that file
    try
      {
        const ExitCode code = run_or_leave(argc, argv);
        std::cout.flush();
        if (!std::cout)
          throw FileError("cannot write standard output");
        return static_cast<int>(code);
      }
    catch (const SolverError &error)
      {
        const int code = report("error", error.what(), error.code());
        if (!error.log.empty())
          std::cerr << "dpcontact: log: " << error.log << std::endl;
        return code;
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
