#include "database/contact_law/law_of_case.h"
#include "meshing/errors.h"
#include "runs/commands/commands.h"
#include "runs/commands/options.h"
#include "runs/interface/documents.h"
#include "runs/interface/outputs.h"
#include "runs/studies/validation_entries.h"
#include "runs/studies/validation_report.h"

#include <iomanip>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>

namespace dpcontact::commands
{
  namespace
  {
    /// Errors that the judged law may have at most.
    struct Bounds
    {
      static constexpr double none = std::numeric_limits<double>::infinity();

      double loading = none, unloading = none, residual = none, restitution = none;

      bool hold(const ValidationSummary &summary) const
      {
        return summary.loading_rms <= loading && summary.unloading_rms <= unloading &&
               summary.residual <= residual && summary.restitution <= restitution;
      }
    };

    struct ValidateOptions
    {
      std::string  database, table, csv;
      HistoryStudy histories;
      Bounds       bounds;
      bool         json = false;
      SettingTexts texts;
    };

    void print_json(const ValidateOptions                &options,
                    const std::vector<ValidationEntry>   &entries,
                    const std::vector<ValidationSummary> &summaries,
                    const std::vector<std::string>       &failures,
                    const bool                            holds)
    {
      Json document{{"database", options.database}, {"table", options.table}};
      for (const ValidationSummary &summary : summaries)
        document["summary"].push_back(json_of(summary));
      for (const ValidationEntry &entry : entries)
        document["rows"].push_back(json_of(entry));
      document["failures"]      = failures;
      document["within_bounds"] = holds;
      print_document(document);
    }

    void print_for_people(const std::vector<ValidationSummary> &summaries)
    {
      std::cout
        << "largest (median) error over       force rms, % of the peak           delta_res  "
           "energy   restitution\n"
           "path     law        count     loading       unloading   anywhere   % of peak  "
           "% put in\n";
      for (const ValidationSummary &s : summaries)
        {
          std::ostringstream line;
          line << std::fixed << std::setprecision(3) << std::left << std::setw(9)
               << to_string(s.path) << std::setw(10) << to_string(s.law) << std::right
               << std::setw(6) << s.count << std::setw(8) << 100 * s.loading_rms << " ("
               << 100 * s.median_loading_rms << ")" << std::setw(8) << 100 * s.unloading_rms << " ("
               << 100 * s.median_unloading_rms << ")" << std::setw(9) << 100 * s.force_max
               << std::setw(11) << 100 * s.residual << std::setw(9) << 100 * s.energy_loss
               << std::setprecision(4) << std::setw(9) << s.restitution << " ("
               << s.median_restitution << ")";
          std::cout << line.str() << '\n';
        }
    }

    HistoryEntries compute(const HistoryStudy &study, const std::optional<ContactTable> &table)
    {
      if (study.count == 0)
        return {};
      return entries_of_histories(study, table, [&study](const std::size_t history) {
        std::cerr << "validate: history " << history + 1 << " of " << study.count << " is done\n";
      });
    }

    ExitCode run(const ValidateOptions &options)
    {
      if (options.database.empty() && options.histories.count == 0)
        throw InputError("validate: give a DATABASE, --histories, or both");
      check_files({{options.database, options.table}, {options.csv}});
      std::optional<ContactTable> table;
      if (!options.table.empty())
        table = read_universal_table(options.table);
      HistoryStudy study = options.histories;
      study.options      = read_solver_options(options.texts);
      std::vector<ValidationEntry> entries;
      if (!options.database.empty())
        entries = entries_of_rows(options.database, table);
      const HistoryEntries computed = compute(study, table);
      entries.insert(entries.end(), computed.entries.begin(), computed.entries.end());

      const auto    summaries = summaries_of(entries);
      const LawKind judged    = table ? LawKind::universal : LawKind::row;
      bool          holds     = true;
      for (const ValidationSummary &summary : summaries)
        if (summary.law == judged)
          holds = holds && options.bounds.hold(summary);

      if (!options.csv.empty())
        write_validation_csv(options.csv, entries);
      if (options.json)
        print_json(options, entries, summaries, computed.failures, holds);
      else
        print_for_people(summaries);
      for (const std::string &failure : computed.failures)
        std::cerr << "dpcontact: validate: " << failure << '\n';
      if (!holds)
        std::cerr << "dpcontact: validate: the " << to_string(judged) << " law exceeds a bound\n";
      return holds && computed.failures.empty() ? ExitCode::success : ExitCode::incomplete;
    }
  } // namespace

  void add_validate(CLI::App &command, Action &action)
  {
    const auto options = std::make_shared<ValidateOptions>();
    command.add_option(
      "DATABASE", options->database, "HDF5 file of a sweep, whose rows are compared");
    command.add_option("--table", options->table, "universal table, for the universal law")
      ->type_name("FILE.csv");
    command
      .add_option("--histories",
                  options->histories.count,
                  "how many random materials and paths within the table to compute")
      ->type_name("N");
    command.add_option("--seed", options->histories.seed, "seed of the random histories [1]")
      ->type_name("N");
    command
      .add_option("--load-level-max",
                  options->histories.largest_load_level,
                  "largest F/F_y of the random histories [1000]")
      ->type_name("");
    command
      .add_option("--jobs", options->histories.processes, "processes that compute histories [1]")
      ->check(CLI::Range(1u, 1024u))
      ->type_name("N");
    const auto bound = [&](const char *name, double &value, const char *help) {
      command.add_option(name, value, help)->type_name("")->group("Bounds (exit code 8 beyond)");
    };
    bound("--loading-bound",
          options->bounds.loading,
          "rms force error over loading, of the peak force");
    bound("--unloading-bound",
          options->bounds.unloading,
          "rms force error over unloading and reloading, of the peak force");
    bound("--residual-bound", options->bounds.residual, "residual overlap, of the peak overlap");
    bound("--restitution-bound", options->bounds.restitution, "coefficient of restitution");
    command.add_option("--csv", options->csv, "report to write, one line a row and law")
      ->type_name("FILE");
    add_settings(command, solver_settings(), options->texts, "Solver");
    add_json_flag(command, options->json);
    command.callback([options, &action] { action = [options] { return run(*options); }; });
  }
} // namespace dpcontact::commands
