#include "runs/sweep/sweep.h"

#include "database/rows/row_store.h"
#include "runs/commands/commands.h"
#include "runs/commands/options.h"
#include "runs/commands/sweep_options.h"
#include "runs/interface/case_input.h"
#include "runs/interface/documents.h"
#include "runs/interface/interruption.h"
#include "runs/interface/warnings.h"
#include "runs/sweep/rank_pool.h"
#include "runs/sweep/sweep_jobs.h"
#include "solver/parallel/environment.h"
#include "solver/parallel/launcher.h"
#include "solver/problem/quantity.h"

#include <iostream>
#include <memory>
#include <optional>

namespace dpcontact::commands
{
  namespace
  {
    struct SweepOptions
    {
      SettingTexts               texts;
      std::string                parameter_file;
      std::optional<std::string> shard;
      bool                       dry_run      = false;
      bool                       retry_failed = false;
      bool                       replace      = false;
      bool                       json         = false;
    };

    /// "2/4". @throws InputError.
    Shard read_shard(const std::string &text)
    {
      const auto slash = text.find('/');
      if (slash == std::string::npos)
        throw InputError("shard: '" + text + "' must be NUMBER/COUNT, for instance 2/4");
      const Shard shard{parse_count("shard", text.substr(0, slash)),
                        parse_count("shard", text.substr(slash + 1))};
      if (shard.number < 1 || shard.number > shard.count)
        throw InputError("shard: '" + text + "' is not there; the number goes from 1 to the count");
      return shard;
    }

    Sweep sweep_of(const SweepOptions &options)
    {
      Sweep sweep        = read_sweep(options.parameter_file, options.texts);
      sweep.retry_failed = options.retry_failed;
      if (options.replace)
        sweep.other_rows = OtherRows::drop;
      if (options.shard)
        sweep.shard = read_shard(*options.shard);
      return sweep;
    }

    /// Where the rows go; the beginning of a JSON document.
    Json place_json(const Sweep &sweep)
    {
      Json place{{"database", sweep.database.string()}};
      if (sweep.shard)
        {
          place["shard"]         = to_string(*sweep.shard);
          place["row_directory"] = RowStore::directory_of(database_of_share(sweep)).string();
        }
      return place;
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
      const std::vector<std::size_t> share  = rows_of_share(sweep);
      const std::vector<RowState>    states = row_states(sweep);
      Json                           rows   = Json::array();
      std::size_t                    to_do  = 0;
      for (std::size_t i = 0; i < share.size(); ++i)
        {
          const Case &input = sweep.cases[share[i]];
          const char *state = text_of(states[i], sweep.retry_failed);
          to_do +=
            states[i] == RowState::missing || (states[i] == RowState::failed && sweep.retry_failed);
          if (json)
            rows.push_back(
              {{"material", material_json(input)}, {"scene", scene_json(input)}, {"state", state}});
          else
            std::cout << share[i] + 1 << "  " << label(input) << ": " << state << '\n';
        }
      if (json)
        {
          Json document = place_json(sweep);
          document.update({{"jobs", sweep.jobs},
                           {"options", options_json(sweep.solver)},
                           {"to_compute", to_do},
                           {"rows", rows}});
          print_document(document);
        }
      else
        std::cout << to_do << " of " << share.size() << " rows to compute by " << sweep.jobs
                  << " processes into " << database_of_share(sweep).string() << '\n';
      return ExitCode::success;
    }

    ExitCode run(const SweepOptions &options, RankPool *const ranks)
    {
      const Sweep sweep = sweep_of(options);
      print_doubts(sweep.cases);
      if (options.dry_run)
        return list(sweep, options.json);

      const InterruptionMessage interruption(
        "the rows finished so far are kept in " +
        RowStore::directory_of(database_of_share(sweep)).string() +
        ", and the same command computes the others");
      const SweepSummary summary = run_sweep(sweep, ranks);
      if (options.json)
        {
          Json document = place_json(sweep);
          document.update({{"rows", summary.rows},
                           {"computed", summary.computed},
                           {"converged", summary.converged},
                           {"failed", summary.failed},
                           {"kept", summary.kept},
                           {"wall_seconds", summary.seconds}});
          print_document(document);
        }
      return summary.failed == 0 ? ExitCode::success : ExitCode::incomplete;
    }

    /// Under MPI rank 0 does what the one process does without it, all output included, and the
    /// others compute for it. Its exit code is the launcher's.
    ExitCode run_anyhow(const SweepOptions &options)
    {
      if (launched_ranks() == 1)
        return run(options, nullptr);
      const MpiSession session;
      if (session.rank() == 0)
        {
          RankPool pool(session); // lets the others go, whatever happens here
          return run(options, &pool);
        }
      serve_sweep([&] { return sweep_of(options); });
      return ExitCode::success;
    }
  } // namespace

  void add_sweep(CLI::App &command, Action &action)
  {
    const auto options = std::make_shared<SweepOptions>();
    command.add_option("FILE", options->parameter_file, "parameter file with the grid (FILE.prm)")
      ->required();
    add_settings(command, sweep_settings(), options->texts, "Sweep");
    add_settings(command, scene_settings(), options->texts, "Material and scene");
    add_settings(command, solver_settings(), options->texts, "Solver");
    command
      .add_option("--shard",
                  options->shard,
                  "NUMBER/COUNT: compute this part of the grid only; its rows are kept in "
                  "NAME.shard-NUMBER-of-COUNT.h5.rows for dpcontact merge")
      ->type_name("K/N");
    command.add_flag("--dry-run", options->dry_run, "list what would be done, and do nothing");
    command.add_flag("--retry-failed", options->retry_failed, "compute failed rows again");
    add_replace_flag(command, options->replace);
    add_json_flag(command, options->json);
    command.callback([options, &action] { action = [options] { return run_anyhow(*options); }; });
  }
} // namespace dpcontact::commands
