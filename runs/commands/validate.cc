#include "database/files.h"
#include "database/store.h"
#include "meshing/errors.h"
#include "runs/commands/commands.h"
#include "runs/commands/options.h"
#include "runs/contact_law_input.h"
#include "runs/documents.h"
#include "runs/row.h"
#include "runs/validation.h"
#include "runs/worker_pool.h"
#include "solver/environment.h"
#include "solver/force_history.h"

#include <algorithm>
#include <cmath>
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
    constexpr double unset = std::numeric_limits<double>::infinity();

    struct Options
    {
      std::string  database, table, csv;
      unsigned int histories = 0, seed = 1, jobs = 1;
      double       largest_load_level = 1000;
      double       loading = unset, unloading = unset, residual = unset, restitution = unset;
      bool         json = false;
      SettingTexts texts;
    };

    /// One law against one computed history.
    struct Entry
    {
      Case        input;
      const char *path; ///< "row": to the peak and back; "history"
      const char *law;  ///< "row" or "universal"
      double      load_level;
      LawErrors   errors;
    };

    constexpr std::pair<const char *, double LawErrors::*> numbers[] = {
      {"loading_rms", &LawErrors::loading_rms},
      {"loading_max", &LawErrors::loading_max},
      {"unloading_rms", &LawErrors::unloading_rms},
      {"unloading_max", &LawErrors::unloading_max},
      {"residual_approach", &LawErrors::residual},
      {"energy_loss", &LawErrors::energy_loss},
      {"restitution", &LawErrors::restitution},
      {"law_restitution", &LawErrors::law_restitution}};

    double restitution_error(const LawErrors &errors)
    {
      return std::abs(errors.law_restitution - errors.restitution);
    }

    Json json_of(const LawErrors &errors)
    {
      Json document;
      for (const auto &[name, number] : numbers)
        document[name] = errors.*number;
      for (const auto &[end, mean, rms] : errors.legs)
        document["legs"].push_back({{"end_force", end}, {"mean", mean}, {"rms", rms}});
      return document;
    }

    LawErrors errors_from(const Json &document)
    {
      LawErrors errors;
      for (const auto &[name, number] : numbers)
        errors.*number = document.at(name).get<double>();
      for (const Json &leg : document.at("legs"))
        errors.legs.push_back({leg.at("end_force").get<double>(),
                               leg.at("mean").get<double>(),
                               leg.at("rms").get<double>()});
      return errors;
    }

    void add_rows(const Options                       &options,
                  const std::optional<ContactTable> &table,
                  std::vector<Entry>                  &entries)
    {
      for (const Record &row : read_store(options.database).records)
        {
          if (row.status != "converged")
            continue;
          const Case   input = case_of(row);
          const double half  = row.radius_m / 2;
          const Legs   legs{row.curve.loading, row.curve.unloading};
          const auto   add = [&](const char *name, const ContactLaw &law) {
            entries.push_back(
              {input, "row", name, row.load_level, law_errors(law.pair(half), legs)});
          };
          add("row",
              ContactLaw::from_row(
                {row.a, row.b, row.m, row.n, row.force_yield_N, row.approach_yield_m, half}));
          if (table && covers(*table, input))
            add("universal", contact_law(input, *table));
        }
    }

    /// Both laws against one history, as JSON text from a worker.
    std::string run_history(const RandomHistory                 &history,
                            const std::optional<ContactTable> &table,
                            const SolverOptions                 &used)
    {
      const Case        &input = history.input;
      const double       half  = input.scene.radius / 2;
      const ForceHistory computed =
        solve_force_history(input.material, input.scene.radius, history.turning_points, used);
      Json       result;
      const auto row = row_of_history(computed.legs, computed.yield, input.scene.radius);
      result["row"]  = json_of(law_errors(ContactLaw::from_row(row).pair(half), computed.legs));
      if (table)
        result["universal"] =
          json_of(law_errors(contact_law(input, *table).pair(half), computed.legs));
      result["load_level"] = input.scene.force_max / computed.yield.force;
      return result.dump();
    }

    void add_histories(const Options                       &options,
                       const std::optional<ContactTable> &table,
                       const SolverOptions                 &used,
                       std::vector<Entry>                  &entries,
                       std::vector<std::string>            &failures)
    {
      HistoryRanges ranges{{0, .45}, {0, 50}, {2, options.largest_load_level}};
      if (table)
        ranges = {{table->nu.front(), table->nu.back()},
                  {table->phi.front(), table->phi.back()},
                  {2, std::min(table->load_level.back(), options.largest_load_level)}};
      const auto histories = random_histories(options.histories, options.seed, ranges);

      std::vector<std::size_t> jobs(histories.size());
      for (std::size_t i = 0; i < jobs.size(); ++i)
        jobs[i] = i;
      std::vector<JobResult> results(histories.size());
      run_jobs(
        jobs,
        options.jobs,
        [&]() -> Worker {
          const auto environment = std::make_shared<Environment>();
          return [&, environment](const std::size_t i) -> std::string {
            try
              {
                return run_history(histories[i], table, used);
              }
            catch (const Error &error)
              {
                return std::string("error: ") + error.what();
              }
          };
        },
        [](std::size_t) {},
        [&](const JobResult &result) {
          results[result.job] = result;
          std::cerr << "validate: history " << result.job + 1 << " of " << histories.size()
                    << " is done\n";
        });
      for (std::size_t i = 0; i < histories.size(); ++i)
        {
          const std::string &text = results[i].text;
          if (results[i].died || text.rfind("error: ", 0) == 0)
            {
              failures.push_back(label(histories[i].input) + ": " + one_line(text));
              continue;
            }
          const Json document = Json::parse(text);
          for (const char *law : {"row", "universal"})
            if (document.contains(law))
              entries.push_back({histories[i].input,
                                 "history",
                                 law,
                                 document.at("load_level").get<double>(),
                                 errors_from(document.at(law))});
        }
    }

    /// Largest and median of each error over the entries of one law and kind of path.
    struct Summary
    {
      const char *path, *law;
      std::size_t count;
      double      loading_rms, unloading_rms, force_max, residual, energy_loss, restitution;
      double      median_loading_rms, median_unloading_rms, median_restitution;
    };

    std::optional<Summary>
    summary_of(const std::vector<Entry> &entries, const char *path, const char *law)
    {
      std::vector<LawErrors> chosen;
      for (const Entry &entry : entries)
        if (entry.path == std::string(path) && entry.law == std::string(law))
          chosen.push_back(entry.errors);
      if (chosen.empty())
        return std::nullopt;
      const auto sorted = [&](const auto &number) {
        std::vector<double> values;
        for (const LawErrors &errors : chosen)
          values.push_back(number(errors));
        std::sort(values.begin(), values.end());
        return values;
      };
      const auto loading   = sorted([](const LawErrors &e) { return e.loading_rms; });
      const auto unloading = sorted([](const LawErrors &e) { return e.unloading_rms; });
      const auto bounce    = sorted(restitution_error);
      const auto most      = [&](const auto &number) { return sorted(number).back(); };
      return Summary{
        path,
        law,
        chosen.size(),
        loading.back(),
        unloading.back(),
        most([](const LawErrors &e) { return std::max(e.loading_max, e.unloading_max); }),
        most([](const LawErrors &e) { return e.residual; }),
        most([](const LawErrors &e) { return std::abs(e.energy_loss); }),
        bounce.back(),
        loading[loading.size() / 2],
        unloading[unloading.size() / 2],
        bounce[bounce.size() / 2]};
    }

    std::vector<Summary> summaries_of(const std::vector<Entry> &entries)
    {
      std::vector<Summary> result;
      for (const char *path : {"row", "history"})
        for (const char *law : {"row", "universal"})
          if (const auto summary = summary_of(entries, path, law))
            result.push_back(*summary);
      return result;
    }

    Json json_of(const Summary &s)
    {
      return {{"path", s.path},
              {"law", s.law},
              {"count", s.count},
              {"largest",
               {{"loading_rms", s.loading_rms},
                {"unloading_rms", s.unloading_rms},
                {"force_max", s.force_max},
                {"residual_approach", s.residual},
                {"energy_loss", s.energy_loss},
                {"restitution", s.restitution}}},
              {"median",
               {{"loading_rms", s.median_loading_rms},
                {"unloading_rms", s.median_unloading_rms},
                {"restitution", s.median_restitution}}}};
    }

    void write_csv(const std::string &file, const std::vector<Entry> &entries)
    {
      std::ostringstream text;
      text
        << std::setprecision(10)
        << "# Contact law against finite elements at equal overlaps. Forces over the largest "
           "force,\n"
           "# residual_approach over the largest approach, energy_loss (law - computed) over the\n"
           "# work put in, restitution the root of work given back over work put in.\n"
           "path,law,E_Pa,nu,phi_deg,sigma_c_Pa,radius_m,force_max_N,load_level";
      for (const auto &[name, number] : numbers)
        text << ',' << name;
      text << '\n';
      for (const Entry &entry : entries)
        {
          const Material &m = entry.input.material;
          text << entry.path << ',' << entry.law << ',' << m.youngs_modulus << ','
               << m.poisson_ratio << ',' << entry.input.friction_angle_degrees << ','
               << m.compressive_strength << ',' << entry.input.scene.radius << ','
               << entry.input.scene.force_max << ',' << entry.load_level;
          for (const auto &[name, number] : numbers)
            text << ',' << entry.errors.*number;
          text << '\n';
        }
      write_file(file, text.str());
    }

    void print_for_people(const std::vector<Summary> &summaries)
    {
      std::cout
        << "largest (median) error over       force rms, % of the peak           delta_res  "
           "energy   restitution\n"
           "path     law        count     loading       unloading   anywhere   % of peak  "
           "% put in\n";
      for (const Summary &s : summaries)
        {
          std::ostringstream line;
          line << std::fixed << std::setprecision(3) << std::left << std::setw(9) << s.path
               << std::setw(10) << s.law << std::right << std::setw(6) << s.count << std::setw(8)
               << 100 * s.loading_rms << " (" << 100 * s.median_loading_rms << ")" << std::setw(8)
               << 100 * s.unloading_rms << " (" << 100 * s.median_unloading_rms << ")"
               << std::setw(9) << 100 * s.force_max << std::setw(11) << 100 * s.residual
               << std::setw(9) << 100 * s.energy_loss << std::setprecision(4) << std::setw(9)
               << s.restitution << " (" << s.median_restitution << ")";
          std::cout << line.str() << '\n';
        }
    }

    ExitCode run(const Options &options)
    {
      if (options.database.empty() && options.histories == 0)
        throw InputError("validate: give a DATABASE, --histories, or both");
      std::optional<ContactTable> table;
      if (!options.table.empty())
        table = read_universal_table(options.table);
      const SolverOptions      used = read_solver_options(options.texts);
      std::vector<Entry>       entries;
      std::vector<std::string> failures;
      if (!options.database.empty())
        add_rows(options, table, entries);
      if (options.histories > 0)
        add_histories(options, table, used, entries, failures);

      const auto  summaries = summaries_of(entries);
      const char *judged    = table ? "universal" : "row";
      bool        holds     = true;
      for (const Summary &s : summaries)
        if (s.law == std::string(judged))
          holds = holds && s.loading_rms <= options.loading &&
                  s.unloading_rms <= options.unloading && s.residual <= options.residual &&
                  s.restitution <= options.restitution;

      if (!options.csv.empty())
        write_csv(options.csv, entries);
      if (options.json)
        {
          Json document{{"database", options.database}, {"table", options.table}};
          for (const Summary &s : summaries)
            document["summary"].push_back(json_of(s));
          for (const Entry &entry : entries)
            document["rows"].push_back({{"path", entry.path},
                                        {"law", entry.law},
                                        {"material", material_json(entry.input)},
                                        {"scene", scene_json(entry.input)},
                                        {"load_level", entry.load_level},
                                        {"errors", json_of(entry.errors)}});
          document["failures"]      = failures;
          document["within_bounds"] = holds;
          print_document(document);
        }
      else
        print_for_people(summaries);
      for (const std::string &failure : failures)
        std::cerr << "dpcontact: validate: " << failure << '\n';
      if (!holds)
        std::cerr << "dpcontact: validate: the " << judged << " law exceeds a bound\n";
      return holds && failures.empty() ? ExitCode::success : ExitCode::incomplete;
    }
  } // namespace

  void add_validate(CLI::App &program, Action &action)
  {
    const auto      options = std::make_shared<Options>();
    CLI::App *const command = program.add_subcommand(
      "validate",
      "The contact law against finite elements: stored rows, unseen materials and paths");
    command->add_option(
      "DATABASE", options->database, "HDF5 file of a sweep, whose rows are compared");
    command->add_option("--table", options->table, "universal table, for the universal law")
      ->type_name("FILE.csv");
    command
      ->add_option("--histories",
                   options->histories,
                   "computes so many random materials and paths within the table")
      ->type_name("N");
    command->add_option("--seed", options->seed, "of the random histories [1]")->type_name("N");
    command
      ->add_option("--load-level-max",
                   options->largest_load_level,
                   "largest F/F_y of the random histories [1000]")
      ->type_name("");
    command->add_option("--jobs", options->jobs, "processes that compute histories [1]")
      ->check(CLI::Range(1u, 1024u))
      ->type_name("N");
    const auto bound = [&](const char *name, double &value, const char *help) {
      command->add_option(name, value, help)->type_name("")->group("Bounds (exit code 8 beyond)");
    };
    bound("--loading-bound", options->loading, "rms force error over loading, of the peak force");
    bound("--unloading-bound", options->unloading, "likewise over unloading and reloading");
    bound("--residual-bound", options->residual, "residual overlap, of the peak overlap");
    bound("--restitution-bound", options->restitution, "coefficient of restitution");
    command->add_option("--csv", options->csv, "report to write, one line a row and law")
      ->type_name("FILE");
    add_settings(*command, solver_settings(), options->texts, "Solver");
    add_json_flag(*command, options->json);
    command->callback([options, &action] { action = [options] { return run(*options); }; });
  }
} // namespace dpcontact::commands
