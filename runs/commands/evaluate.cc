#include "database/tables/universal_checks.h"
#include "runs/commands/commands.h"
#include "runs/commands/options.h"
#include "runs/interface/outputs.h"
#include "runs/studies/evaluation.h"

#include <iostream>
#include <memory>

namespace dpcontact::commands
{
  namespace
  {
    struct EvaluateOptions
    {
      std::string rows          = default_database(LookupMethod::kriging).string();
      std::string universal     = default_database(LookupMethod::similarity).string();
      std::string held_out      = DPCONTACT_DATABASE_DIRECTORY "/../runs/studies/held_out.json";
      bool        held_out_only = false;
      bool        json          = false;
    };

    ExitCode run(const EvaluateOptions &options)
    {
      check_files({{options.rows, options.universal, options.held_out}, {}});
      Json document;
      if (options.held_out_only)
        {
          document = compare_held_out(read_checked_universal(options.universal),
                                      read_held_out(options.held_out));
        }
      else
        document =
          evaluate({options.rows, options.universal, options.held_out},
                   [](const std::string &what) { std::cerr << "evaluate: " << what << std::endl; });
      if (options.json || options.held_out_only)
        print_document(document);
      else
        std::cout << describe_evaluation(document);
      return ExitCode::success;
    }
  } // namespace

  void add_evaluate(CLI::App &command, Action &action)
  {
    const auto options = std::make_shared<EvaluateOptions>();
    command.add_option("--rows", options->rows, "the paper's 162 rows")->type_name("FILE");
    command.add_option("--universal", options->universal, "the universal table")->type_name("FILE");
    command
      .add_option("--held-out", options->held_out, "curves that runs/studies/held_out computed")
      ->type_name("FILE");
    command.add_flag("--held-out-only",
                     options->held_out_only,
                     "only the universal table on the held-out materials, as JSON with every row");
    add_json_flag(command, options->json);
    command.callback([options, &action] { action = [options] { return run(*options); }; });
  }
} // namespace dpcontact::commands
