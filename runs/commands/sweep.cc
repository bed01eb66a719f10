#include "runs/sweep.h"

#include "runs/commands/commands.h"
#include "runs/commands/options.h"
#include "runs/documents.h"
#include "solver/families.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <thread>

namespace dpcontact::commands
{
  namespace
  {
    struct Options
    {
      SettingTexts texts;
      std::string  parameter_file;
      bool         dry_run      = false;
      bool         retry_failed = false;
      bool         json         = false;
    };

    std::vector<Setting> sweep_settings()
    {
      return {{"jobs", Setting::Kind::count, "worker processes [all cores]"},
              {"mode",
               Setting::Kind::choice,
               "direct: every row for itself; families: one loading path for rows of equal nu and "
               "phi [direct]",
               Dimension::number,
               {"direct", "families"}},
              {"database",
               Setting::Kind::text,
               "HDF5 file; finished rows are kept in FILE.rows beside it "
               "[the parameter file's name with .h5, here]"}};
    }

    Sweep read_sweep(const Options &options)
    {
      const SettingTexts texts = merged(options.parameter_file,
                                        scene_settings() + solver_settings() + sweep_settings(),
                                        options.texts);
      Sweep              sweep;
      sweep.cases        = read_grid(texts);
      sweep.solver       = read_solver_options(texts);
      sweep.retry_failed = options.retry_failed;

      const auto database = texts.find("database");
      if (database == texts.end())
        sweep.database =
          std::filesystem::path(options.parameter_file).filename().replace_extension(".h5");
      else if (database->second.empty())
        throw InputError("database: is empty");
      else
        sweep.database = database->second;

      const auto mode = texts.find("mode");
      if (mode != texts.end())
        {
          for (const Setting &setting : sweep_settings())
            if (setting.name == mode->first)
              setting.check(mode->second);
          sweep.mode = mode->second == "families" ? SweepMode::families : SweepMode::direct;
          if (sweep.mode == SweepMode::families)
            for (const Case &input : sweep.cases)
              check_similar(input.material);
        }

      const auto jobs = texts.find("jobs");
      sweep.jobs      = jobs == texts.end() ? std::max(1U, std::thread::hardware_concurrency())
                                            : parse_count("jobs", jobs->second);
      if (sweep.jobs == 0)
        throw InputError("jobs: '0' is too few; there must be at least 1");
      return sweep;
    }

    const char *text_of(const RowState state, const bool retry_failed)
    {
      switch (state)
        {
          case RowState::missing:
            return "to compute";
          case RowState::converged:
            return "done";
          case RowState::failed:
            break;
        }
      return retry_failed ? "to compute again" : "failed before";
    }

    ExitCode list(const Sweep &sweep, const bool json)
    {
      const std::vector<RowState> states = row_states(sweep);
      Json                        rows   = Json::array();
      std::size_t                 to_do  = 0;
      for (std::size_t i = 0; i < states.size(); ++i)
        {
          const Case &input = sweep.cases[i];
          const char *state = text_of(states[i], sweep.retry_failed);
          to_do +=
            states[i] == RowState::missing || (states[i] == RowState::failed && sweep.retry_failed);
          if (json)
            rows.push_back(
              {{"material", material_json(input)}, {"scene", scene_json(input)}, {"state", state}});
          else
            std::cout << i + 1 << "  " << label(input) << ": " << state << '\n';
        }
      if (json)
        print_document({{"database", sweep.database.string()},
                        {"jobs", sweep.jobs},
                        {"options", options_json(sweep.solver)},
                        {"to_compute", to_do},
                        {"rows", rows}});
      else
        std::cout << to_do << " of " << states.size() << " rows to compute by " << sweep.jobs
                  << " processes into " << sweep.database.string() << '\n';
      return ExitCode::success;
    }

    ExitCode run(const Options &options)
    {
      const Sweep sweep = read_sweep(options);
      if (options.dry_run)
        return list(sweep, options.json);

      const SweepSummary summary = run_sweep(sweep);
      if (options.json)
        print_document({{"database", sweep.database.string()},
                        {"rows", sweep.cases.size()},
                        {"computed", summary.computed},
                        {"converged", summary.converged},
                        {"failed", summary.failed},
                        {"wall_seconds", summary.seconds}});
      return summary.failed == 0 ? ExitCode::success : ExitCode::incomplete;
    }
  } // namespace

  void add_sweep(CLI::App &program, Action &action)
  {
    const auto      options = std::make_shared<Options>();
    CLI::App *const command =
      program.add_subcommand("sweep",
                             "A grid of materials and scenes over worker processes; resumes where "
                             "it stopped. Lists are separated by commas.");
    command->add_option("FILE", options->parameter_file, "parameter file with the grid (FILE.prm)")
      ->required();
    add_settings(*command, sweep_settings(), options->texts, "Options");
    add_settings(*command, scene_settings(), options->texts, "Material and scene");
    add_settings(*command, solver_settings(), options->texts, "Solver");
    command->add_flag("--dry-run", options->dry_run, "list what would be done, and do nothing");
    command->add_flag("--retry-failed", options->retry_failed, "compute failed rows again");
    add_json_flag(*command, options->json);
    command->callback([options, &action] { action = [options] { return run(*options); }; });
  }
} // namespace dpcontact::commands
