#include "runs/commands/commands.h"
#include "runs/commands/options.h"
#include "runs/interface/case_input.h"
#include "runs/interface/documents.h"
#include "runs/interface/interruption.h"
#include "runs/interface/version.h"
#include "runs/interface/warnings.h"
#include "runs/studies/convergence.h"
#include "solver/parallel/environment.h"
#include "solver/problem/quantity.h"

#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>

namespace dpcontact::commands
{
  namespace
  {
    struct ConvergeOptions
    {
      SettingTexts texts;
      std::string  parameter_file;
      bool         json = false;
    };

    Json by_coefficient(const std::array<double, 4> &values)
    {
      return by_name(Coefficients::from(values));
    }

    Json errors_json(const CoefficientErrors &errors)
    {
      Json result;
      for (std::size_t c = 0; c < coefficient_names.size(); ++c)
        result[coefficient_names[c]] = error_json(errors[c], errors[c].total());
      return result;
    }

    Json document_of(const Case &input, const SolverOptions &options, const Convergence &found)
    {
      Json studies = Json::array();
      for (const ErrorStudy &study : found.studies)
        {
          Json levels = Json::array();
          for (const auto &level : study.levels)
            {
              Json entry     = by_coefficient(level.values);
              entry["level"] = level.label;
              levels.push_back(entry);
            }
          studies.push_back({{"source", study.source},
                             {"varied", study.varied},
                             {"levels", levels},
                             {"order", by_coefficient(study.order)},
                             {"limit", by_coefficient(study.limit)},
                             {"error", by_coefficient(study.error)}});
        }
      return {{"material", material_json(input)},
              {"scene", scene_json(input)},
              {"load_level", input.scene.force_max / found.solution.yield.force},
              {"approach_ratio",
               found.solution.curve.loading.back().approach /
                 (found.solution.yield.approach *
                  std::pow(input.scene.force_max / found.solution.yield.force, 2. / 3))},
              {"contact_radius", found.solution.curve.loading.back().contact_radius},
              {"coefficients", by_coefficient(found.values)},
              {"estimate", errors_json(found.estimate)},
              {"studied", errors_json(found.studied)},
              {"studies", studies},
              {"used",
               {{"surface-halvings", found.solution.used.surface_halvings.value_or(0)},
                {"loading-steps", found.solution.used.loading_steps}}},
              {"options", options_json(options)},
              {"versions", versions()}};
    }

    std::string digits(const double value)
    {
      std::ostringstream text;
      text << std::setprecision(7) << value;
      return text.str();
    }

    void print_row(const std::string &head, const std::array<double, 4> &values)
    {
      std::cout << std::left << std::setw(34) << head << std::right;
      for (const double value : values)
        std::cout << std::setw(14) << (std::isnan(value) ? "-" : digits(value));
      std::cout << '\n';
    }

    void print_for_people(const Case &input, const Convergence &found)
    {
      std::cout << label(input) << "\n\n" << std::setw(34) << "";
      for (const char *name : coefficient_names)
        std::cout << std::setw(14) << name;
      std::cout << '\n';
      print_row("as asked for", found.values);
      for (const ErrorStudy &study : found.studies)
        {
          std::cout << '\n';
          for (const auto &level : study.levels)
            print_row(study.source + ", " + study.varied + " " + level.label, level.values);
          print_row("  order", study.order);
          print_row("  limit", study.limit);
          print_row("  error", study.error);
        }
      std::cout << "\nstudied (above) and estimated (what solve and the database state) errors\n";
      const std::pair<const char *, double ErrorParts::*> parts[] = {
        {"mesh", &ErrorParts::mesh},
        {"step", &ErrorParts::step},
        {"contact", &ErrorParts::contact},
        {"far_field", &ErrorParts::far_field},
        {"finite_radius", &ErrorParts::finite_radius},
        {"fit", &ErrorParts::fit}};
      const auto all = [](const CoefficientErrors &errors, const auto &of) {
        return std::array<double, 4>{of(errors[0]), of(errors[1]), of(errors[2]), of(errors[3])};
      };
      for (const auto &[name, part] : parts)
        for (const bool studied : {true, false})
          print_row(std::string(name) + (studied ? ", studied" : ", estimated"),
                    all(studied ? found.studied : found.estimate,
                        [part = part](const ErrorParts &e) { return e.*part; }));
      for (const bool studied : {true, false})
        print_row(std::string("total") + (studied ? ", studied" : ", estimated"),
                  all(studied ? found.studied : found.estimate,
                      [](const ErrorParts &e) { return e.total(); }));
    }

    ExitCode run(const ConvergeOptions &options)
    {
      const SettingTexts texts =
        merged(options.parameter_file, scene_settings() + solver_settings(), options.texts);
      const Case          input = read_case(texts);
      const SolverOptions used  = read_solver_options(texts);
      const Environment   environment;
      print_doubts({input});
      const InterruptionMessage interruption("nothing is kept, and the same command begins again");
      const Convergence         found = with_case(input, [&] {
        return study_convergence(input, used, [](const std::string &text) {
          std::cerr << "converge: " << text << std::endl;
        });
      });
      if (options.json)
        print_document(document_of(input, used, found));
      else
        print_for_people(input, found);
      return ExitCode::success;
    }
  } // namespace

  void add_converge(CLI::App &command, Action &action)
  {
    const auto options = std::make_shared<ConvergeOptions>();
    add_settings(command, scene_settings(), options->texts, "Material and scene");
    add_settings(command, solver_settings(), options->texts, "Solver");
    add_parameter_file(command, options->parameter_file);
    add_json_flag(command, options->json);
    command.callback([options, &action] { action = [options] { return run(*options); }; });
  }
} // namespace dpcontact::commands
