#include "runs/commands/commands.h"
#include "runs/commands/options.h"
#include "runs/interface/case_input.h"
#include "runs/interface/documents.h"
#include "runs/interface/warnings.h"
#include "solver/closed_form/first_yield.h"
#include "solver/closed_form/plausibility.h"

#include <iostream>
#include <memory>

namespace dpcontact::commands
{
  namespace
  {
    struct YieldOptions
    {
      SettingTexts texts;
      std::string  parameter_file;
      bool         json = false;
    };

    /// First yield depends on no force; one that is given is part of what is judged.
    Case read_input(const SettingTexts &texts)
    {
      if (find(texts, "force-max") || find(texts, "load-level"))
        {
          const Case input = read_case(texts);
          print_warnings(doubts_about(input));
          return input;
        }
      const Case input = read_body(texts);
      print_warnings(doubts_about(input.material, input.scene.radius));
      return input;
    }

    ExitCode run(const YieldOptions &options)
    {
      const Case input =
        read_input(merged(options.parameter_file, scene_settings(), options.texts));
      const FirstYield yield = first_yield(input.material, input.scene.radius);
      if (options.json)
        print_document({{"material", material_json(input)},
                        {"scene", scene_json(input)},
                        {"yield", yield_json(yield)}});
      else
        std::cout << label(input) << '\n' << describe(yield) << '\n';
      return ExitCode::success;
    }
  } // namespace

  void add_yield(CLI::App &command, Action &action)
  {
    const auto options = std::make_shared<YieldOptions>();
    add_settings(command, scene_settings(), options->texts, "Material and scene");
    add_parameter_file(command, options->parameter_file);
    add_json_flag(command, options->json);
    command.callback([options, &action] { action = [options] { return run(*options); }; });
  }
} // namespace dpcontact::commands
