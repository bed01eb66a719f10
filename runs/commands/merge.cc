#include "runs/sweep/merge.h"

#include "runs/commands/commands.h"
#include "runs/commands/options.h"
#include "runs/commands/sweep_options.h"
#include "runs/interface/case_input.h"
#include "runs/interface/documents.h"

#include <memory>

namespace dpcontact::commands
{
  namespace
  {
    struct MergeOptions
    {
      SettingTexts             texts;
      std::string              parameter_file;
      std::vector<std::string> shards;
      bool                     replace = false;
      bool                     json    = false;
    };

    ExitCode run(const MergeOptions &options)
    {
      Sweep sweep = read_sweep(options.parameter_file, options.texts);
      if (options.replace)
        sweep.other_rows = OtherRows::drop;
      const MergeSummary summary =
        merge_shards(sweep, {options.shards.begin(), options.shards.end()});
      if (options.json)
        print_document({{"database", sweep.database.string()},
                        {"rows", summary.rows},
                        {"duplicates", summary.duplicates},
                        {"converged", summary.converged},
                        {"failed", summary.failed},
                        {"kept", summary.kept}});
      return summary.failed == 0 ? ExitCode::success : ExitCode::incomplete;
    }
  } // namespace

  void add_merge(CLI::App &command, Action &action)
  {
    const auto options = std::make_shared<MergeOptions>();
    command.add_option("FILE", options->parameter_file, "parameter file with the grid (FILE.prm)")
      ->required();
    command
      .add_option(
        "SHARDS", options->shards, "the shards' row directories (NAME.shard-1-of-4.h5.rows ...)")
      ->required();
    add_settings(command,
                 sweep_settings() + scene_settings() + solver_settings(),
                 options->texts,
                 "Sweep",
                 [](const Setting &setting) { return setting.name == "database"; });
    command.footer("Where the sweep was given options beside its file (material, scene, solver), "
                   "merge is given the same.");
    add_replace_flag(command, options->replace);
    add_json_flag(command, options->json);
    command.callback([options, &action] { action = [options] { return run(*options); }; });
  }
} // namespace dpcontact::commands
