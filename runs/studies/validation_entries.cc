#include "runs/studies/validation_entries.h"

#include "database/contact_law/law_of_case.h"
#include "database/rows/checks.h"
#include "database/rows/row.h"
#include "database/rows/store.h"
#include "meshing/errors.h"
#include "runs/studies/validation_report.h"
#include "runs/sweep/worker_pool.h"
#include "solver/closed_form/first_yield.h"
#include "solver/parallel/environment.h"
#include "solver/path/force_history.h"

#include <algorithm>
#include <memory>
#include <numeric>

namespace dpcontact
{
  namespace
  {
    constexpr const char *error_mark = "error: "; // before the message in a worker's text

    HistoryRanges ranges_of(const std::optional<ContactTable> &table,
                            const double                       largest_load_level)
    {
      if (!table)
        return {{0, 0.45}, {0, 50}, {2, largest_load_level}};
      return {{table->nu.front(), table->nu.back()},
              {table->phi.front(), table->phi.back()},
              {2, std::min(table->load_level.back(), largest_load_level)}};
    }

    /// Both laws against one history, as JSON text from a worker.
    std::string run_history(const RandomHistory               &history,
                            const std::optional<ContactTable> &table,
                            const SolverOptions               &options)
    {
      const Case        &input = history.input;
      const double       half  = input.scene.radius / 2;
      const ForceHistory computed =
        solve_force_history(input.material, input.scene.radius, history.turning_points, options);
      const auto add = [&](Json &result, const LawKind kind, const ContactLaw &law) {
        result[to_string(kind)] = json_of(law_errors(law.pair(half), computed.legs));
      };
      Json result;
      add(result,
          LawKind::row,
          ContactLaw::from_row(row_of_history(computed.legs, computed.yield, input.scene.radius)));
      if (table)
        add(result, LawKind::universal, contact_law(input, *table));
      result["load_level"] = input.scene.force_max / computed.yield.force;
      return result.dump();
    }

    /// The entries of a worker's text.
    std::vector<ValidationEntry> parse_history(const Case &input, const std::string &text)
    {
      const Json                   document = Json::parse(text);
      std::vector<ValidationEntry> result;
      for (const auto &[law, name] : EnumNames<LawKind>::values)
        if (document.contains(name))
          result.push_back({input,
                            ValidationPath::history,
                            law,
                            document.at("load_level").get<double>(),
                            law_errors_of(document.at(name))});
      return result;
    }
  } // namespace

  std::vector<ValidationEntry> entries_of_rows(const std::filesystem::path       &database,
                                               const std::optional<ContactTable> &table)
  {
    std::vector<ValidationEntry> result;
    const Database               checked = read_checked_store(database);
    for (const Record &row : checked.records)
      {
        if (!row.converged())
          continue;
        const Case  &input = row.input;
        const double half  = input.scene.radius / 2;
        const Legs   legs{row.curve.loading, row.curve.unloading};
        const auto   add = [&](const LawKind kind, const ContactLaw &law) {
          result.push_back(
            {input, ValidationPath::row, kind, row.load_level, law_errors(law.pair(half), legs)});
        };
        add(LawKind::row,
            ContactLaw::from_row({row.law.a,
                                  row.law.b,
                                  row.law.m,
                                  row.law.n,
                                  row.yield.force,
                                  row.yield.approach,
                                  half}));
        if (table && covers(*table, input))
          add(LawKind::universal, contact_law(input, *table));
      }
    return result;
  }

  HistoryEntries entries_of_histories(const HistoryStudy                     &study,
                                      const std::optional<ContactTable>      &table,
                                      const std::function<void(std::size_t)> &on_end)
  {
    const auto histories =
      random_histories(study.count, study.seed, ranges_of(table, study.largest_load_level));
    std::vector<std::size_t> jobs(histories.size());
    std::iota(jobs.begin(), jobs.end(), std::size_t(0));
    std::vector<JobResult> results(histories.size());
    run_jobs(
      jobs,
      study.processes,
      [&]() -> Worker {
        const auto environment = std::make_shared<Environment>();
        return [&, environment](const std::size_t i) -> std::string {
          try
            {
              return run_history(histories[i], table, study.options);
            }
          catch (const Error &error)
            {
              return std::string(error_mark) + error.what();
            }
        };
      },
      [](std::size_t) {},
      [&](const JobResult &result) {
        results[result.job] = result;
        on_end(result.job);
      });

    HistoryEntries done;
    for (std::size_t i = 0; i < histories.size(); ++i)
      {
        const Case        &input = histories[i].input;
        const std::string &text  = results[i].text;
        if (results[i].died || text.rfind(error_mark, 0) == 0)
          done.failures.push_back(label(input) + ": " + one_line(text));
        else
          for (const ValidationEntry &entry : parse_history(input, text))
            done.entries.push_back(entry);
      }
    return done;
  }
} // namespace dpcontact
