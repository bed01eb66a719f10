#include "runs/sweep/sweep.h"

#include "database/rows/identity.h"
#include "database/rows/row.h"
#include "database/rows/row_json.h"
#include "database/rows/row_store.h"
#include "meshing/errors.h"
#include "runs/interface/agreement.h"
#include "runs/interface/documents.h"
#include "runs/interface/version.h"
#include "runs/sweep/assembly.h"
#include "runs/sweep/progress.h"
#include "runs/sweep/rank_pool.h"
#include "runs/sweep/sweep_jobs.h"
#include "runs/sweep/worker_pool.h"
#include "solver/parallel/environment.h"
#include "solver/problem/quantity.h"

#include <cstdlib>
#include <memory>
#include <new>
#include <numeric>
#include <optional>

namespace dpcontact
{
  namespace
  {
    RowState state_of(const std::optional<Record> &row)
    {
      if (!row)
        return RowState::missing;
      return row->converged() ? RowState::converged : RowState::failed;
    }

    std::vector<RowState>
    states(const Sweep &sweep, const std::vector<std::size_t> &share, const RowStore &rows)
    {
      std::vector<RowState> result;
      for (const std::size_t i : share)
        result.push_back(state_of(rows.find(sweep.cases[i])));
      return result;
    }

    /// Where no rows are beside the database, what a sweep will take up from the file itself.
    std::vector<RowState> states_in_file(const Sweep &sweep, const std::vector<std::size_t> &share)
    {
      std::vector<RowState> result(share.size(), RowState::missing);
      if (!sweep.shard)
        for (const Record &row : rows_in_file(sweep))
          for (std::size_t i = 0; i < share.size(); ++i)
            if (key_of(row.input) == key_of(sweep.cases[share[i]]))
              result[i] = state_of(row);
      return result;
    }

    /// What a worker tells the parent about a row that it has stored, in one line.
    nlohmann::json row_message(const Record &row)
    {
      return {{"status", row.status},
              {"reason", row.reason},
              {"warnings", row.warnings},
              {"wall_seconds", row.cost.wall_seconds}};
    }

    constexpr const char *resumable =
      "; the rows finished so far are kept, and the same command computes the others";

    /// What a worker tells the parent where it could not do its job, in one line.
    std::string stop_message(const ExitCode code, const std::string &reason)
    {
      return nlohmann::json{{"error", clean_text(one_line(reason))},
                            {"code", static_cast<int>(code)}}
        .dump();
    }

    /// Computes a job and stores its rows. @return a message a row, or why the sweep must stop.
    std::string work(const Sweep &sweep, const Job &job, const RowStore &rows)
    {
      try
        {
          nlohmann::json messages = nlohmann::json::array();
          for (const Record &row : compute_rows(sweep, job))
            {
              rows.write(row);
              messages.push_back(row_message(row));
            }
          return messages.dump();
        }
      catch (const Error &error)
        {
          return stop_message(error.code(), error.what());
        }
      catch (const std::bad_alloc &)
        {
          return stop_message(ExitCode::internal, "there is not enough memory");
        }
      catch (const std::filesystem::filesystem_error &error)
        {
          return stop_message(ExitCode::file, error.what());
        }
      catch (const std::exception &error)
        {
          return stop_message(ExitCode::internal, error.what());
        }
    }

    void report(const Case &input, const nlohmann::json &message, Progress &progress)
    {
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

    void
    report(const Sweep &sweep, const Job &job, const nlohmann::json &messages, Progress &progress)
    {
      if (messages.is_object())
        throw Error(static_cast<ExitCode>(messages.at("code").get<int>()),
                    label(sweep.cases[job.wanted.front()]) + ": " +
                      messages.at("error").get<std::string>() + resumable);
      for (std::size_t k = 0; k < job.wanted.size(); ++k)
        report(sweep.cases[job.wanted[k]], messages[k], progress);
    }

    void compute_by_processes(const Sweep            &sweep,
                              const RowStore         &rows,
                              const std::vector<Job> &jobs,
                              Progress               &progress)
    {
      std::vector<std::size_t> numbers(jobs.size());
      std::iota(numbers.begin(), numbers.end(), std::size_t(0));
      const auto make_worker = [&]() -> Worker {
        setenv("DEAL_II_NUM_THREADS", "1", 1); // the processes share the cores already
        const auto environment = std::make_shared<Environment>();
        return [&, environment](const std::size_t job) { return work(sweep, jobs[job], rows); };
      };
      const auto on_end = [&](const JobResult &result) {
        const Job &job = jobs[result.job];
        report(sweep,
               job,
               nlohmann::json::parse(
                 result.died
                   ? stop_message(ExitCode::internal, result.text + ", and a second one as well")
                   : result.text),
               progress);
      };
      run_jobs(
        numbers, sweep.jobs, make_worker, [](std::size_t) {}, on_end);
    }

    /// Does what an order says, in whatever thread.
    std::string work_at(const Sweep &sweep, const RowStore &rows, const std::string &order)
    {
      const Environment environment;
      const auto        given = nlohmann::json::parse(order);
      return work(sweep, {given.at("members"), given.at("wanted")}, rows);
    }

    /// What all ranks must have been given alike: their orders are numbers of cases.
    Json given_to(const Sweep &sweep)
    {
      Json cases = Json::array();
      for (const Case &input : sweep.cases)
        cases.push_back(Json(key_json(input)));
      return {{"database", database_of_share(sweep).string()},
              {"revision", git_revision()},
              {"settings", Json(row_settings(sweep))},
              {"cases", cases}};
    }

    void compute_by_ranks(const Sweep            &sweep,
                          const RowStore         &rows,
                          const std::vector<Job> &unsorted,
                          RankPool               &ranks,
                          Progress               &progress)
    {
      const std::vector<Job>   jobs = longest_first(sweep, unsorted); // short ones fill the end
      std::vector<std::string> orders;
      for (const Job &job : jobs)
        orders.push_back(nlohmann::json{{"members", job.members}, {"wanted", job.wanted}}.dump());
      ranks.run(
        orders,
        [&](const std::string &order) { return work_at(sweep, rows, order); },
        [given = given_to(sweep)](const std::size_t rank, const std::string &text) {
          check_agreement(Json::parse(text), rank, given);
        },
        [&](const std::size_t order, const std::string &text) {
          report(sweep, jobs[order], nlohmann::json::parse(text), progress);
        });
    }
  } // namespace

  std::vector<RowState> row_states(const Sweep &sweep)
  {
    check_database(sweep);
    const std::filesystem::path    database = database_of_share(sweep);
    const std::vector<std::size_t> share    = rows_of_share(sweep);
    if (!RowStore::stored_settings(database).has_value())
      return states_in_file(sweep, share);
    RowStore::check_settings(database, row_settings(sweep));
    return states(sweep, share, RowStore(database, row_settings(sweep), log_sweep));
  }

  SweepSummary run_sweep(const Sweep &sweep, RankPool *const ranks)
  {
    check_database(sweep);
    const RowStore       rows(database_of_share(sweep), row_settings(sweep), log_sweep);
    const RowStore::Lock lock = rows.lock();
    if (!sweep.shard)
      take_up_rows(sweep, rows);

    const std::vector<std::size_t> share  = rows_of_share(sweep);
    const std::vector<RowState>    before = states(sweep, share, rows);
    std::vector<std::size_t>       wanted;
    std::size_t                    failed_before = 0;
    for (std::size_t i = 0; i < before.size(); ++i)
      {
        failed_before += before[i] == RowState::failed;
        if (before[i] == RowState::missing || (before[i] == RowState::failed && sweep.retry_failed))
          wanted.push_back(share[i]);
      }
    log_sweep(
      (sweep.shard ? "shard " + to_string(*sweep.shard) + ": " : std::string()) +
      std::to_string(share.size()) + " rows, " + std::to_string(share.size() - wanted.size()) +
      " done before, " + std::to_string(wanted.size()) + " to compute" +
      (wanted.empty()
         ? ""
         : " by " + std::to_string(sweep.jobs) + (ranks == nullptr ? " processes" : " MPI ranks")));
    if (failed_before > 0 && !sweep.retry_failed)
      log_sweep(std::to_string(failed_before) +
                " rows failed before; --retry-failed tries them again");

    SweepSummary summary;
    {
      Progress               progress(share.size(), share.size() - wanted.size());
      const std::vector<Job> jobs = make_jobs(sweep, wanted);
      if (ranks == nullptr)
        compute_by_processes(sweep, rows, jobs, progress);
      else
        compute_by_ranks(sweep, rows, jobs, *ranks, progress);
      summary.rows     = share.size();
      summary.computed = wanted.size();
      summary.seconds  = progress.seconds();
    }

    if (sweep.shard)
      {
        for (const RowState state : states(sweep, share, rows))
          ++(state == RowState::converged ? summary.converged : summary.failed);
        log_sweep(
          "shard " + to_string(*sweep.shard) + " is done, " + std::to_string(summary.converged) +
          " rows converged, " + std::to_string(summary.failed) + " failed; its rows are in " +
          RowStore::directory_of(database_of_share(sweep)).string() + " for dpcontact merge");
        return summary;
      }
    const Assembled assembled = assemble_database(sweep, rows);
    summary.converged         = assembled.converged;
    summary.failed            = assembled.failed;
    summary.kept              = assembled.kept;
    return summary;
  }

  void serve_sweep(const std::function<Sweep()> &read_sweep)
  {
    serve_ranks([&]() -> RankStart {
      const auto sweep  = std::make_shared<const Sweep>(read_sweep());
      const auto rows   = std::make_shared<std::optional<RowStore>>();
      const auto worker = [sweep, rows](const std::string &order) {
        if (!*rows) // only now is it certain that rank 0 has accepted the directory
          rows->emplace(database_of_share(*sweep), row_settings(*sweep), log_sweep);
        return work_at(*sweep, **rows, order);
      };
      return {worker, given_to(*sweep).dump()};
    });
  }

  std::filesystem::path database_of_share(const Sweep &sweep)
  {
    if (!sweep.shard)
      return sweep.database;
    std::filesystem::path path = sweep.database;
    path.replace_filename(sweep.database.stem().string() + ".shard-" +
                          std::to_string(sweep.shard->number) + "-of-" +
                          std::to_string(sweep.shard->count) + sweep.database.extension().string());
    return path;
  }

  std::string to_string(const Shard &shard)
  {
    return std::to_string(shard.number) + "/" + std::to_string(shard.count);
  }
} // namespace dpcontact
