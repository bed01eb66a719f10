#include "database/files/files.h"
#include "meshing/errors.h"
#include "runs/commands/commands.h"
#include "runs/commands/options.h"
#include "runs/commands/solver_parts.h"
#include "runs/interface/case_input.h"
#include "runs/interface/lookup_documents.h"
#include "runs/interface/outputs.h"
#include "runs/interface/warnings.h"
#include "solver/closed_form/plausibility.h"
#include "solver/problem/quantity.h"

#include <iostream>
#include <memory>

namespace dpcontact::commands
{
  namespace
  {
    struct LookupOptions
    {
      SettingTexts texts;
      std::string  parameter_file;
      std::string  method = "similarity";
      std::string  database;
      std::string  curve, csv;
      bool         extrapolate = false;
      bool         json        = false;
    };

    Outside outside_of(const LookupOptions &options)
    {
      return options.extrapolate ? Outside::extrapolate : Outside::refuse;
    }

    /// Every combination of the lists given, one line each, also those that have no answer.
    ExitCode write_grid(const LookupOptions &options, const LookupTable &table)
    {
      if (!options.curve.empty())
        throw InputError("lookup: a curve is of one scene; leave --curve or --csv out");
      std::vector<LookupAnswer> answers;
      std::size_t               refused = 0, doubtful = 0;
      std::string               first_refused, first_doubtful;
      for (const Case &input :
           read_grid(merged(options.parameter_file, scene_settings(), options.texts)))
        {
          answers.push_back({input, {}, ""});
          LookupAnswer &answer = answers.back();
          try
            {
              answer.result         = table.at(input, outside_of(options));
              answer.result.loading = {}; // not in the table, and by far the most of an answer
              if (!answer.result.warnings.empty() && doubtful++ == 0)
                first_doubtful = label(input) + ": " + joined(answer.result.warnings);
            }
          catch (const InputError &error)
            {
              answer.refused           = error.what();
              answer.result            = {};
              answer.result.method     = parse_enum<LookupMethod>(options.method);
              answer.result.yield      = first_yield(input.material, input.scene);
              answer.result.load_level = input.scene.force_max / answer.result.yield.force;
              if (refused++ == 0)
                first_refused = label(input) + ": " + answer.refused;
            }
        }
      const std::string of_all = " of " + std::to_string(answers.size()) + " cases ";
      if (refused == answers.size())
        throw InputError("lookup: none of the cases is answered; the first, " + first_refused);
      if (doubtful > 0)
        print_warnings({std::to_string(doubtful) + of_all + "are doubtful, as " + first_doubtful});
      if (refused > 0)
        print_warnings({std::to_string(refused) + of_all + "are not answered, as " + first_refused +
                        " (see the column status)"});
      write_file(options.csv, lookup_csv(answers));
      if (options.json)
        print_document({{"csv", options.csv},
                        {"rows", answers.size()},
                        {"answered", answers.size() - refused},
                        {"refused", refused},
                        {"doubtful", doubtful}});
      else
        std::cout << options.csv << ": " << answers.size() << " rows, " << answers.size() - refused
                  << " answered\n";
      return refused > 0 ? ExitCode::incomplete : ExitCode::success;
    }

    ExitCode run(const LookupOptions &options)
    {
      const LookupMethod method = parse_enum<LookupMethod>(options.method);
      const bool estimates = method != LookupMethod::similarity && method != LookupMethod::table_2;
      const EstimatorMaker make =
        estimates ? solver_parts("method " + options.method).make_estimator : nullptr;
      const unsigned int points = options.curve.empty() ? 0 : parse_count("curve", options.curve);
      if (points > 100000)
        throw InputError("curve is " + options.curve + "; it must be at most 100000 points");
      const std::filesystem::path database = options.database.empty()
                                               ? default_database(method)
                                               : std::filesystem::path(options.database);
      check_files({{database, options.parameter_file}, {options.csv}});
      const LookupTable table(method, database, make);
      if (!options.csv.empty())
        return write_grid(options, table);
      const Case input = read_case(merged(options.parameter_file, scene_settings(), options.texts));
      const LookupResult result =
        with_case(input, [&] { return table.at(input, outside_of(options)); });
      print_warnings(result.warnings);
      if (options.json)
        print_document(lookup_json(input, result, points));
      else
        {
          std::cout << describe(input, result);
          if (points > 0)
            {
              const Json curve = lookup_curve_json(result, points);
              std::cout << "branch,approach_m,force_N\n";
              for (const char *const branch : {"loading", "unloading"})
                for (const Json &point : curve[branch])
                  std::cout << branch << ',' << point["approach"] << ',' << point["force"] << '\n';
            }
        }
      return ExitCode::success;
    }
  } // namespace

  void add_lookup(CLI::App &command, Action &action)
  {
    const auto options = std::make_shared<LookupOptions>();
    add_settings(
      command, scene_settings(), options->texts, "Material and scene", [](const Setting &setting) {
        for (const CaseParameter &parameter : case_parameters()) // what the tables hold
          if (parameter.option() == setting.name)
            return parameter.owners.empty();
        return false;
      });
    command
      .add_option("--method",
                  options->method,
                  "similarity (any R, E, sigma-c, F_max); over the paper's 162 rows kriging, "
                  "natural-neighbour, regression or table-2 (eq 19 as printed) [similarity]")
      ->type_name("");
    command.add_option("--database", options->database, "table, as table or export wrote it")
      ->type_name("FILE");
    command.add_option("--curve", options->curve, "print N points of either branch as well")
      ->type_name("N");
    command
      .add_option(
        "--csv", options->csv, "table to write, one line for every combination of the lists given")
      ->type_name("FILE");
    command.add_flag("--extrapolate", options->extrapolate, "answer outside the data as well");
    add_parameter_file(command, options->parameter_file);
    add_json_flag(command, options->json);
    command.callback([options, &action] { action = [options] { return run(*options); }; });
  }
} // namespace dpcontact::commands
