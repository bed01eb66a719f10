#include "runs/sweep.h"

#include "database/row_json.h"
#include "database/row_store.h"
#include "database/store.h"
#include "meshing/errors.h"
#include "runs/documents.h"
#include "runs/progress.h"
#include "runs/row.h"
#include "runs/version.h"
#include "runs/worker_pool.h"
#include "solver/environment.h"

#include <cstdlib>
#include <iostream>
#include <memory>
#include <optional>

namespace dpcontact
{
  namespace
  {
    /// What every row depends on besides its inputs.
    nlohmann::json row_settings(const SolverOptions &options)
    {
      auto settings              = nlohmann::json::parse(options_json(options).dump());
      settings["method_version"] = method_version;
      return settings;
    }

    void log(const std::string &message) { std::cerr << "sweep: " << message << std::endl; }

    RowState state_of(const std::optional<Record> &row)
    {
      if (!row)
        return RowState::missing;
      return row->status == "converged" ? RowState::converged : RowState::failed;
    }

    std::vector<RowState> states(const Sweep &sweep, const RowStore &rows)
    {
      std::vector<RowState> result;
      for (const Case &input : sweep.cases)
        result.push_back(state_of(rows.find(row_inputs(input))));
      return result;
    }

    /// A database without its rows cannot be resumed, but it must not be overwritten by rows of
    /// other settings either.
    void check_database(const Sweep &sweep)
    {
      if (std::filesystem::is_directory(sweep.database))
        throw FileError("cannot write the database " + sweep.database.string() +
                        ": it is a directory");
      if (!std::filesystem::exists(sweep.database) ||
          RowStore::stored_settings(sweep.database).has_value())
        return;
      const Database    stored = read_store(sweep.database);
      const auto        found  = stored.provenance.find("solver_settings");
      const std::string given  = row_settings(sweep.solver).dump();
      if (found == stored.provenance.end() || found->second != given)
        throw SettingsMismatch(
          sweep.database.string() + " was made with other settings:\n  stored " +
          (found == stored.provenance.end() ? "(absent)" : found->second) + "\n  now    " + given +
          "\nUse these settings again, or another database.");
    }

    /// What a worker tells the parent about a row that it has stored, in one line.
    nlohmann::json row_message(const Record &row)
    {
      return {{"status", row.status},
              {"reason", row.reason},
              {"warnings", row.warnings},
              {"wall_seconds", row.wall_seconds}};
    }

    Worker make_worker(const Sweep &sweep, const RowStore &rows)
    {
      setenv("DEAL_II_NUM_THREADS", "1", 1); // the processes share the cores already
      const auto environment = std::make_shared<Environment>();
      return [&sweep, &rows, environment](const std::size_t job) {
        const Case &input = sweep.cases[job];
        Record      row;
        try
          {
            row = row_of(input, solve_contact(input.material, input.scene, sweep.solver));
          }
        catch (const std::exception &error)
          {
            row = failed_row(input, error.what());
          }
        try
          {
            rows.write(row);
          }
        catch (const Error &error)
          {
            return nlohmann::json{{"error", error.what()}}.dump();
          }
        return row_message(row).dump();
      };
    }

    void compute(const Sweep                    &sweep,
                 const RowStore                 &rows,
                 const std::vector<std::size_t> &jobs,
                 Progress                       &progress)
    {
      const auto on_end = [&](const JobResult &result) {
        const Case    &input = sweep.cases[result.job];
        nlohmann::json message;
        if (result.died)
          {
            const Record row = failed_row(input, result.text);
            rows.write(row);
            message = row_message(row);
          }
        else
          message = nlohmann::json::parse(result.text);
        if (message.contains("error"))
          throw FileError(message["error"].get<std::string>());

        const std::string status   = message["status"];
        const std::string warnings = message["warnings"];
        std::string       text     = label(input) + ": " + status;
        if (status != "converged")
          text += ": " + message["reason"].get<std::string>();
        else if (message["wall_seconds"].is_number())
          text += " in " + format_quantity(message["wall_seconds"], Dimension::number) + " s";
        if (!warnings.empty())
          text += "; warning: " + warnings;
        progress.row_done(text, status != "converged" || !warnings.empty());
      };
      run_jobs(
        jobs, sweep.jobs, [&] { return make_worker(sweep, rows); }, [](std::size_t) {}, on_end);
    }

    Database assemble(const Sweep &sweep, const RowStore &rows)
    {
      Database database;
      for (const Case &input : sweep.cases)
        {
          auto row = rows.find(row_inputs(input));
          if (!row)
            throw FileError("the row of " + label(input) + " has vanished; run the sweep again");
          database.records.push_back(std::move(*row));
        }
      for (const auto &[name, version] : versions())
        database.provenance["version_" + name] = version;
      database.provenance["solver_settings"] = row_settings(sweep.solver).dump();
      database.provenance["rows"]            = std::to_string(sweep.cases.size());
      return database;
    }

    /// Whether the file holds these rows already, whoever assembled it.
    bool up_to_date(const std::filesystem::path &file, const Database &database)
    {
      if (!std::filesystem::exists(file))
        return false;
      try
        {
          const Database stored = read_store(file);
          if (stored.records.size() != database.records.size())
            return false;
          for (std::size_t i = 0; i < stored.records.size(); ++i)
            if (to_json(stored.records[i]) != to_json(database.records[i]))
              return false;
          return stored.provenance.count("solver_settings") == 1 &&
                 stored.provenance.at("solver_settings") ==
                   database.provenance.at("solver_settings");
        }
      catch (const Error &error)
        {
          log(std::string(error.what()) + "; assembling it again from its rows");
          return false;
        }
    }
  } // namespace

  std::vector<RowState> row_states(const Sweep &sweep)
  {
    check_database(sweep);
    if (!RowStore::stored_settings(sweep.database).has_value())
      return std::vector<RowState>(sweep.cases.size(), RowState::missing);
    RowStore::check_settings(sweep.database, row_settings(sweep.solver));
    return states(sweep, RowStore(sweep.database, row_settings(sweep.solver), log));
  }

  SweepSummary run_sweep(const Sweep &sweep)
  {
    check_database(sweep);
    const RowStore       rows(sweep.database, row_settings(sweep.solver), log);
    const RowStore::Lock lock = rows.lock();

    std::vector<std::size_t>    jobs;
    std::size_t                 failed_before = 0;
    const std::vector<RowState> before        = states(sweep, rows);
    for (std::size_t i = 0; i < before.size(); ++i)
      {
        failed_before += before[i] == RowState::failed;
        if (before[i] == RowState::missing || (before[i] == RowState::failed && sweep.retry_failed))
          jobs.push_back(i);
      }
    log(std::to_string(sweep.cases.size()) + " rows, " +
        std::to_string(sweep.cases.size() - jobs.size()) + " done before, " +
        std::to_string(jobs.size()) + " to compute" +
        (jobs.empty() ? "" : " by " + std::to_string(sweep.jobs) + " processes"));
    if (failed_before > 0 && !sweep.retry_failed)
      log(std::to_string(failed_before) + " rows failed before; --retry-failed tries them again");

    SweepSummary summary;
    {
      Progress progress(sweep.cases.size(), sweep.cases.size() - jobs.size());
      compute(sweep, rows, jobs, progress);
      summary.computed = jobs.size();
      summary.seconds  = progress.seconds();
    }

    const Database database = assemble(sweep, rows);
    for (const Record &row : database.records)
      ++(state_of(row) == RowState::converged ? summary.converged : summary.failed);
    if (!up_to_date(sweep.database, database))
      {
        write_store(sweep.database, database);
        summary.assembled = true;
      }
    log(sweep.database.string() + (summary.assembled ? " was written" : " was up to date") + ": " +
        std::to_string(summary.converged) + " rows converged, " + std::to_string(summary.failed) +
        " failed");
    return summary;
  }
} // namespace dpcontact
