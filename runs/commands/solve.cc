#include "solver/path/solve.h"

#include "database/files/files.h"
#include "database/rows/row.h"
#include "runs/commands/commands.h"
#include "runs/commands/options.h"
#include "runs/interface/agreement.h"
#include "runs/interface/case_input.h"
#include "runs/interface/checkpoint_file.h"
#include "runs/interface/documents.h"
#include "runs/interface/interruption.h"
#include "runs/interface/outputs.h"
#include "runs/interface/result_files.h"
#include "runs/interface/version.h"
#include "runs/interface/warnings.h"
#include "solver/closed_form/plausibility.h"
#include "solver/parallel/environment.h"
#include "solver/path/solution.h"
#include "solver/problem/quantity.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <set>
#include <system_error>
#include <unistd.h>

namespace dpcontact::commands
{
  namespace
  {
    struct SolveOptions
    {
      SettingTexts texts;
      std::string  parameter_file;
      bool         overwrite = false;
      bool         json      = false;
    };

    const char *const output_name     = "output";
    const char *const checkpoint_name = "checkpoint";

    std::vector<Setting> own_settings()
    {
      return {text_setting(output_name,
                           "directory for fields (VTU), curve, profile and points (CSV) and the "
                           "result (JSON)"),
              text_setting(checkpoint_name,
                           "file that keeps the state after every step; a run that was stopped "
                           "goes on from it")};
    }

    /// Says on a terminal how far the solver is.
    void report_step(const char *stage, const double fraction, const int newton_iterations)
    {
      std::cerr << "\r\033[K" << stage << ' ' << std::lround(100 * fraction) << " %, "
                << newton_iterations << " Newton iterations" << std::flush;
    }

    /// Says it where the terminal's last line cannot be written over: in a batch job's log.
    void log_step(const char *stage, const double fraction, const int newton_iterations)
    {
      std::cerr << "dpcontact: " << stage << ' ' << std::lround(100 * fraction) << " %, "
                << newton_iterations << " Newton iterations" << std::endl;
    }

    Json document_of(const Case          &input,
                     const SolverOptions &used,
                     const Solution      &solution,
                     const Record        &row)
    {
      Json document = {{"material", material_json(input)},
                       {"scene", scene_json(input)},
                       {"yield", yield_json(solution.yield)},
                       {"fit", fit_json(row)},
                       {"error", error_json(row)},
                       {"published_convention", published_json(row.fit.published)},
                       {"peak",
                        {{"force", row.curve.loading.back().force},
                         {"approach", row.state.approach_peak},
                         {"contact_radius", row.state.contact_radius_peak},
                         {"pressure", row.state.pressure_peak},
                         {"plastic_strain", row.state.plastic_strain_max}}},
                       {"residual_approach", row.state.approach_residual},
                       {"plastic_zone", plastic_zone_json(solution.plastic_zone)},
                       {"flow_zone", plastic_zone_json(solution.flow_zone)},
                       {"second_plastic_zone", plastic_zone_json(solution.second_plastic_zone)},
                       {"second_flow_zone", plastic_zone_json(solution.second_flow_zone)},
                       {"plastic_volume", row.state.plastic_volume},
                       {"dissipated_energy", row.state.dissipated_energy},
                       {"apex_points", row.state.apex_points},
                       {"step_error", solution.step_error},
                       {"checks", checks_json(solution.checks)},
                       {"cost", cost_json(row)},
                       {"axisymmetry_deviation", solution.axisymmetry_deviation},
                       {"linear_solver",
                        {{"solves", solution.cost.linear_solves},
                         {"iterations", solution.cost.linear_iterations},
                         {"processes", solution.cost.processes}}},
                       {"elastic", !(row.state.plastic_volume > 0)},
                       {"status", row.status},
                       {"reason", row.reason},
                       {"warnings", row.warnings},
                       {"options", options_json(used)},
                       {"used",
                        {{"surface-halvings", solution.used.surface_halvings.value_or(0)},
                         {"loading-steps", solution.used.loading_steps}}},
                       {"versions", versions()}};
      if (!input.scene.second || !input.scene.second->material)
        for (const char *const key : {"second_plastic_zone", "second_flow_zone"})
          document.erase(key);
      return document;
    }

    void print_for_people(const Case &input, const Solution &solution, const Record &row)
    {
      const auto number = [](const double value) {
        return format_quantity(value, Dimension::number);
      };
      const auto length = [](const double value) {
        return format_quantity(value, Dimension::length);
      };
      std::cout << label(input) << '\n'
                << describe(solution.yield) << '\n'
                << describe_fit(row) << '\n'
                << "peak      F = "
                << format_quantity(row.curve.loading.back().force, Dimension::force)
                << ", approach " << length(row.state.approach_peak) << ", contact radius "
                << length(row.state.contact_radius_peak) << ", largest pressure "
                << format_quantity(row.state.pressure_peak, Dimension::pressure) << '\n'
                << "released  residual approach " << length(row.state.approach_residual)
                << ", plastic strain up to "
                << format_quantity(row.state.plastic_strain_max, Dimension::number) << '\n'
                << "cost      " << row.cost.dofs << " degrees of freedom, " << row.cost.steps
                << " steps, " << row.cost.newton_iterations << " Newton iterations, "
                << format_quantity(row.cost.wall_seconds, Dimension::number) << " s, "
                << row.cost.peak_memory_bytes / 1000000 << " MB\n"
                << "error     a " << number(row.error[0].total) << ", b "
                << number(row.error[1].total) << ", m " << number(row.error[2].total) << ", n "
                << number(row.error[3].total)
                << " (mesh, load step, contact, far field, finite radius, fit; --json by source)\n"
                << "accuracy  load step " << format_quantity(solution.step_error, Dimension::number)
                << " of the peak force\n"
                << describe_checks(solution.checks)
                << (row.state.plastic_volume > 0 ? "" : "elastic   nothing yields: Hertz\n")
                << "status    " << row.status << (row.reason.empty() ? "" : ": ") << row.reason
                << '\n';
    }

    /// Where results and state go; empty: nowhere.
    struct Places
    {
      std::filesystem::path directory, checkpoint;
    };

    /// Tries the places before anything is computed, and clears the directory where that is asked.
    void prepare(const Places &places, const SolveOptions &options)
    {
      CommandFiles files{{options.parameter_file}, {places.checkpoint}};
      if (!places.checkpoint.empty())
        TemporaryFile::remove_leftovers(places.checkpoint);
      if (places.directory.empty())
        return check_files(files);
      make_result_directory(places.directory);
      std::set<std::filesystem::path> results;
      for (const auto &names :
           {result_files_of(places.directory), result_files_in(places.directory)})
        results.insert(names.begin(), names.end());
      files.outputs.insert(files.outputs.end(), results.begin(), results.end());
      check_files(files);
      std::error_code ignored;
      const bool      goes_on =
        !places.checkpoint.empty() && std::filesystem::exists(places.checkpoint, ignored);
      see_to_old_results(places.directory,
                         options.overwrite ? OldResults::remove
                         : goes_on         ? OldResults::keep
                                           : OldResults::refuse);
    }

    Checkpoint
    checkpoint_in(const std::filesystem::path &file, const Json &inputs, const bool first)
    {
      Checkpoint checkpoint;
      if (file.empty())
        return checkpoint;
      if (std::filesystem::exists(file))
        {
          checkpoint.found = read_checkpoint(file, inputs);
          if (first)
            std::cerr << "dpcontact: going on from " << file.string() << std::endl;
        }
      checkpoint.keep = [file, inputs, first](const Arrays &state) {
        if (first)
          write_checkpoint(file, inputs, state);
      };
      return checkpoint;
    }

    /// What is to be solved, and where that goes.
    struct Task
    {
      Case          input;
      SolverOptions options;
      Places        places;
      Json          inputs; ///< input and options, for checkpoints and failed results
    };

    struct Result
    {
      Solution solution;
      Record   row;
      Json     document;
    };

    /// Solves and writes the results. What fails leaves a result that says so.
    Result solve(const Task &task, const Communicator &processes)
    {
      const bool first    = processes.rank() == 0;
      const bool terminal = first && isatty(STDERR_FILENO) == 1;
      const bool writes   = first && !task.places.directory.empty();
      // A step in space takes seconds to minutes, an axisymmetric curve less than that.
      const StepObserver observer = terminal                                   ? report_step
                                    : first && in_space(task.options.geometry) ? log_step
                                                                               : StepObserver();
      const FieldSink    fields =
        task.places.directory.empty() ? FieldSink() : fields_into(task.places.directory);
      const auto end_line = [terminal] {
        if (terminal)
          std::cerr << "\r\033[K" << std::flush;
      };
      try
        {
          const Checkpoint checkpoint = checkpoint_in(task.places.checkpoint, task.inputs, first);
          Result           result;
          result.solution = solve_contact(task.input.material,
                                          task.input.scene,
                                          task.options,
                                          fields,
                                          observer,
                                          processes,
                                          checkpoint);
          end_line();
          result.row      = row_of(task.input, result.solution);
          result.document = document_of(task.input, task.options, result.solution, result.row);
          if (writes)
            write_result_files(task.places.directory, result.solution, result.document);
          return result;
        }
      catch (const std::exception &error)
        {
          end_line();
          if (writes)
            write_failed_result(task.places.directory, task.inputs, error.what());
          throw;
        }
    }

    void report(const SolveOptions &options, const Task &task, const Result &result)
    {
      const std::vector<std::string> said = doubts_about(task.input);
      for (const std::string &warning : result.solution.warnings)
        if (std::find(said.begin(), said.end(), warning) == said.end())
          print_warnings({warning});
      if (options.json)
        return print_document(result.document);
      print_for_people(task.input, result.solution, result.row);
      if (!task.places.directory.empty())
        for (const Json &file : result.document.at("files"))
          std::cout << "written   " << file.get<std::string>() << '\n';
    }

    ExitCode run(const SolveOptions &options)
    {
      const SettingTexts texts =
        merged(options.parameter_file,
               scene_settings() + second_body_settings() + solver_settings() + own_settings(),
               options.texts);
      Task task{read_case(texts),
                read_solver_options(texts),
                {find(texts, output_name).value_or(""), find(texts, checkpoint_name).value_or("")},
                {}};
      task.inputs = {{"material", material_json(task.input)},
                     {"scene", scene_json(task.input)},
                     {"options", options_json(task.options)}};

      const Environment  environment;
      const Communicator processes = environment.world();
      check_agreement(processes,
                      {{"inputs", task.inputs},
                       {output_name, task.places.directory.string()},
                       {checkpoint_name, task.places.checkpoint.string()},
                       {"revision", git_revision()}});
      const bool first = processes.rank() == 0;
      if (first)
        {
          prepare(task.places, options);
          print_doubts({task.input});
        }
      const Result result = with_case(task.input, [&] {
        const InterruptionMessage interruption(
          task.places.checkpoint.empty()
            ? "nothing of the curve is kept; with --checkpoint FILE a run goes on where it was "
              "stopped"
            : "the state is kept in " + task.places.checkpoint.string() +
                ", and the same command goes on from it");
        return solve(task, processes);
      });
      if (!first)
        return ExitCode::success;
      if (!task.places.checkpoint.empty())
        std::filesystem::remove(task.places.checkpoint);
      report(options, task, result);
      if (!result.row.converged())
        with_case(task.input, [&] { throw SolverError(result.row.reason); });
      return ExitCode::success;
    }
  } // namespace

  void add_solve(CLI::App &command, Action &action)
  {
    const auto options = std::make_shared<SolveOptions>();
    add_settings(command, scene_settings(), options->texts, "Material and scene");
    add_settings(command,
                 second_body_settings(),
                 options->texts,
                 "Second body (identical to the first unless one is given)");
    add_settings(command, solver_settings(), options->texts, "Solver");
    add_settings(command, own_settings(), options->texts, "Output");
    command.add_flag("--overwrite",
                     options->overwrite,
                     "remove the results that the directory of --output holds already");
    add_parameter_file(command, options->parameter_file);
    add_json_flag(command, options->json);
    command.callback([options, &action] { action = [options] { return run(*options); }; });
  }
} // namespace dpcontact::commands
