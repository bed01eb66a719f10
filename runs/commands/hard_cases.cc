#include "runs/studies/hard_cases.h"

#include "meshing/errors.h"
#include "runs/commands/commands.h"
#include "runs/commands/options.h"
#include "runs/interface/documents.h"
#include "solver/parallel/environment.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>

namespace dpcontact::commands
{
  namespace
  {
    struct HardCasesOptions
    {
      std::vector<std::string> names;
      bool                     list = false;
      bool                     json = false;
    };

    std::vector<HardCase> chosen(const std::vector<std::string> &names)
    {
      if (names.empty())
        return hard_cases();
      std::vector<HardCase> result;
      for (const std::string &name : names)
        {
          const auto found =
            std::find_if(hard_cases().begin(), hard_cases().end(), [&](const HardCase &hard_case) {
              return hard_case.name == name;
            });
          if (found == hard_cases().end())
            throw InputError("hard-cases: there is no case '" + name + "'; --list shows them");
          result.push_back(*found);
        }
      return result;
    }

    void print_row(const char *const cells[9])
    {
      std::printf("%-24s %-10s %7s %5s %9s %9s %9s %9s  %s\n",
                  cells[0],
                  cells[1],
                  cells[2],
                  cells[3],
                  cells[4],
                  cells[5],
                  cells[6],
                  cells[7],
                  cells[8]);
      std::fflush(stdout);
    }

    std::string scientific(const double value)
    {
      char buffer[32];
      std::snprintf(buffer, sizeof buffer, "%.1e", value);
      return buffer;
    }

    void print_row(const HardCase &hard_case, const HardCaseOutcome &result)
    {
      const PathChecks &c         = result.run.checks;
      const bool        converged = result.outcome == "converged";
      const std::string newton    = std::to_string(result.run.newton_iterations);
      const std::string cut_backs = std::to_string(result.run.cut_backs);
      const std::string residual = scientific(c.residual), yield = scientific(c.yield_excess);
      const std::string penetration = scientific(c.penetration);
      const std::string energy =
        c.largest_work > 0 ? scientific(c.energy_error / c.largest_work) : "-";
      const std::string note =
        std::string(result.as_expected ? "" : "NOT AS EXPECTED: ") +
        (converged ? result.run.found : result.outcome.substr(0, 60) + "...");
      const char *const cells[9] = {hard_case.name.c_str(),
                                    converged ? "converged" : "error",
                                    converged ? newton.c_str() : "-",
                                    converged ? cut_backs.c_str() : "-",
                                    converged ? residual.c_str() : "-",
                                    converged ? yield.c_str() : "-",
                                    converged ? penetration.c_str() : "-",
                                    converged ? energy.c_str() : "-",
                                    note.c_str()};
      print_row(cells);
    }

    Json json_of(const HardCase &hard_case, const HardCaseOutcome &result)
    {
      return {{"case", hard_case.name},
              {"about", hard_case.about},
              {"outcome", result.outcome},
              {"as_expected", result.as_expected},
              {"expected_error", hard_case.error},
              {"found", result.run.found},
              {"newton_iterations", result.run.newton_iterations},
              {"cut_backs", result.run.cut_backs},
              {"checks", checks_json(result.run.checks)},
              {"wall_seconds", result.seconds}};
    }

    ExitCode run(const HardCasesOptions &options)
    {
      const std::vector<HardCase> cases = chosen(options.names);
      if (options.list)
        {
          for (const HardCase &hard_case : cases)
            std::cout << hard_case.name << ": " << hard_case.about << '\n';
          return ExitCode::success;
        }
      const Environment environment;
      Json              document   = Json::array();
      std::size_t       unexpected = 0;
      const char *const head[9]    = {
           "case", "outcome", "Newton", "cuts", "residual", "yield", "contact", "energy", "found"};
      if (!options.json)
        print_row(head);
      for (const HardCase &hard_case : cases)
        {
          if (options.json)
            std::cerr << "hard-cases: " << hard_case.name << std::endl;
          const HardCaseOutcome result = run_hard_case(hard_case);
          unexpected += !result.as_expected;
          if (options.json)
            document.push_back(json_of(hard_case, result));
          else
            print_row(hard_case, result);
        }
      if (options.json)
        print_document(document);
      else
        std::cout
          << cases.size() - unexpected << " of " << cases.size()
          << " cases as expected. Largest residual, yield excess over the strength, contact "
             "violation over the approach, energy imbalance over the work.\n";
      return unexpected == 0 ? ExitCode::success : ExitCode::incomplete;
    }
  } // namespace

  void add_hard_cases(CLI::App &command, Action &action)
  {
    const auto options = std::make_shared<HardCasesOptions>();
    command.add_option("NAME", options->names, "cases to run; none: all");
    command.add_flag("--list", options->list, "say what the cases are, and do nothing");
    add_json_flag(command, options->json);
    command.callback([options, &action] { action = [options] { return run(*options); }; });
  }
} // namespace dpcontact::commands
