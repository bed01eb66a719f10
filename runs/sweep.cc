#include "runs/sweep.h"

#include "database/digest.h"
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
#include "solver/families.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <map>
#include <memory>
#include <numeric>
#include <optional>

namespace dpcontact
{
  namespace
  {
    const char *to_string(const SweepMode mode)
    {
      return mode == SweepMode::families ? "families" : "direct";
    }

    /// What every row depends on besides its inputs. In a family a row depends on the others: their
    /// load levels are where the common path stops.
    nlohmann::json row_settings(const Sweep &sweep)
    {
      auto settings              = nlohmann::json::parse(options_json(sweep.solver).dump());
      settings["method_version"] = method_version;
      settings["mode"]           = to_string(sweep.mode);
      if (sweep.mode == SweepMode::families)
        {
          nlohmann::json grid;
          for (const Case &input : sweep.cases)
            grid.push_back(row_inputs(input).key());
          settings["grid_sha256"] = sha256(grid.dump());
        }
      return settings;
    }

    /// Cases that are computed together, and those of them whose rows are wanted.
    struct Job
    {
      std::vector<std::size_t> members, wanted;
    };

    std::vector<Job> make_jobs(const Sweep &sweep, const std::vector<std::size_t> &wanted)
    {
      std::vector<Job> jobs;
      if (sweep.mode == SweepMode::direct)
        {
          for (const std::size_t i : wanted)
            jobs.push_back({{i}, {i}});
          return jobs;
        }
      // The largest φ last: it is the cheapest.
      std::map<std::tuple<double, double, double, double>, Job> families;

      const auto family = [&](const std::size_t i) -> Job & {
        const Case &input = sweep.cases[i];
        return families[{input.friction_angle_degrees,
                         input.material.poisson_ratio,
                         input.material.flow_stress_ratio,
                         input.dilation_angle_degrees}];
      };
      for (std::size_t i = 0; i < sweep.cases.size(); ++i)
        family(i).members.push_back(i);
      for (const std::size_t i : wanted)
        family(i).wanted.push_back(i);
      for (auto &[key, job] : families)
        if (!job.wanted.empty())
          jobs.push_back(std::move(job));
      return jobs;
    }

    /// The solutions of a job's members.
    std::vector<Solution> solve_job(const Sweep &sweep, const Job &job)
    {
      if (sweep.mode == SweepMode::direct)
        {
          const Case &input = sweep.cases[job.members.front()];
          return {solve_contact(input.material, input.scene, sweep.solver)};
        }
      std::vector<FamilyMember> members;
      for (const std::size_t i : job.members)
        members.push_back({sweep.cases[i].material, sweep.cases[i].scene});
      return solve_family(members, sweep.solver);
    }

    /// The wanted rows of a job; they are failed ones where it fails.
    std::vector<Record> compute_rows(const Sweep &sweep, const Job &job)
    {
      std::vector<Record> rows;
      try
        {
          const std::vector<Solution> solutions = solve_job(sweep, job);
          for (const std::size_t i : job.wanted)
            {
              const auto position =
                std::find(job.members.begin(), job.members.end(), i) - job.members.begin();
              rows.push_back(row_of(sweep.cases[i], solutions[static_cast<std::size_t>(position)]));
            }
        }
      catch (const std::exception &error)
        {
          rows.clear();
          for (const std::size_t i : job.wanted)
            rows.push_back(failed_row(sweep.cases[i], error.what()));
        }
      return rows;
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
      const std::string given  = row_settings(sweep).dump();
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

    Worker make_worker(const Sweep &sweep, const std::vector<Job> &jobs, const RowStore &rows)
    {
      setenv("DEAL_II_NUM_THREADS", "1", 1); // the processes share the cores already
      const auto environment = std::make_shared<Environment>();
      return [&sweep, &jobs, &rows, environment](const std::size_t job) {
        nlohmann::json messages = nlohmann::json::array();
        for (const Record &row : compute_rows(sweep, jobs[job]))
          try
            {
              rows.write(row);
              messages.push_back(row_message(row));
            }
          catch (const Error &error)
            {
              messages.push_back({{"error", error.what()}});
            }
        return messages.dump();
      };
    }

    void report(const Case &input, const nlohmann::json &message, Progress &progress)
    {
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
    }

    void compute(const Sweep                    &sweep,
                 const RowStore                 &rows,
                 const std::vector<std::size_t> &wanted,
                 Progress                       &progress)
    {
      const std::vector<Job>   jobs = make_jobs(sweep, wanted);
      std::vector<std::size_t> numbers(jobs.size());
      std::iota(numbers.begin(), numbers.end(), std::size_t(0));
      const auto on_end = [&](const JobResult &result) {
        const Job     &job      = jobs[result.job];
        nlohmann::json messages = nlohmann::json::array();
        if (!result.died)
          messages = nlohmann::json::parse(result.text);
        else
          for (const std::size_t i : job.wanted)
            {
              const Record row = failed_row(sweep.cases[i], result.text);
              rows.write(row);
              messages.push_back(row_message(row));
            }
        for (std::size_t k = 0; k < job.wanted.size(); ++k)
          report(sweep.cases[job.wanted[k]], messages[k], progress);
      };
      run_jobs(
        numbers,
        sweep.jobs,
        [&] { return make_worker(sweep, jobs, rows); },
        [](std::size_t) {},
        on_end);
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
      database.provenance["solver_settings"] = row_settings(sweep).dump();
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
    RowStore::check_settings(sweep.database, row_settings(sweep));
    return states(sweep, RowStore(sweep.database, row_settings(sweep), log));
  }

  SweepSummary run_sweep(const Sweep &sweep)
  {
    check_database(sweep);
    const RowStore       rows(sweep.database, row_settings(sweep), log);
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
