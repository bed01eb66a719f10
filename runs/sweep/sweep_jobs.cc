#include "runs/sweep/sweep_jobs.h"

#include "database/rows/row.h"
#include "meshing/errors.h"
#include "solver/closed_form/first_yield.h"
#include "solver/path/families.h"
#include "solver/path/solution.h"
#include "solver/path/solve.h"
#include "solver/problem/case.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <numeric>
#include <unistd.h>
#include <utility>
#include <vector>

namespace dpcontact
{
  namespace
  {
    /// The solutions of a job's members.
    std::vector<Solution> solve_job(const Sweep &sweep, const Job &job)
    {
      if (sweep.mode == SweepMode::direct)
        {
          const Case &input = sweep.cases[job.members.front()];
          return {solve_contact(input.material, input.scene, sweep.solver)};
        }
      std::vector<Case> members;
      for (const std::size_t i : job.members)
        members.push_back(sweep.cases[i]);
      return solve_family(members, sweep.solver);
    }

    /// Grows with the time that the job takes. Rounded, so that machines whose logarithms differ in
    /// the last bit put the jobs in the same order.
    long expected_cost(const Sweep &sweep, const Job &job)
    {
      double cost = 0; // steps and iterations grow like this; Hertz's scenes cost next to nothing
      for (const std::size_t i : job.members)
        {
          const Case &input = sweep.cases[i];
          cost += std::log1p(input.scene.force_max /
                             first_yield(input.material, input.scene.radius).force);
        }
      return std::lround(1e4 * cost);
    }
  } // namespace

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
    std::map<std::pair<double, std::vector<double>>, Job> families;

    const auto family = [&](const std::size_t i) -> Job & {
      const Case &input = sweep.cases[i];
      return families[{input.material.friction_angle.degrees(), similarity_group(input.material)}];
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

  std::vector<Job> longest_first(const Sweep &sweep, std::vector<Job> jobs)
  {
    std::vector<std::pair<long, std::size_t>> order;
    for (std::size_t i = 0; i < jobs.size(); ++i)
      order.emplace_back(-expected_cost(sweep, jobs[i]), i);
    std::sort(order.begin(), order.end());
    std::vector<Job> sorted;
    for (const auto &[cost, i] : order)
      sorted.push_back(std::move(jobs[i]));
    return sorted;
  }

  std::vector<std::size_t> rows_of_share(const Sweep &sweep)
  {
    std::vector<std::size_t> rows(sweep.cases.size());
    std::iota(rows.begin(), rows.end(), std::size_t(0));
    if (!sweep.shard)
      return rows;

    const std::vector<Job> jobs = longest_first(sweep, make_jobs(sweep, rows));
    const std::size_t      n    = sweep.shard->count;
    rows.clear();
    for (std::size_t i = 0; i < jobs.size(); ++i)
      {
        // there and back, so that no shard has the longest of every round
        const std::size_t position = i / n % 2 == 0 ? i % n : n - 1 - i % n;
        if (position + 1 == sweep.shard->number)
          rows.insert(rows.end(), jobs[i].wanted.begin(), jobs[i].wanted.end());
      }
    std::sort(rows.begin(), rows.end());
    return rows;
  }

  std::vector<Record> compute_rows(const Sweep &sweep, const Job &job)
  {
    std::vector<Record> rows;
    const auto          fail = [&](const Error &error) {
      rows.clear();
      for (const std::size_t i : job.wanted)
        rows.push_back(failed_row(sweep.cases[i], error.what()));
    };
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
    catch (const SolverError &error)
      {
        fail(error);
        if (!error.log.empty() && isatty(STDERR_FILENO) == 0)
          std::cerr << "sweep: " + label(sweep.cases[job.wanted.front()]) + ": " + error.log + "\n"
                    << std::flush;
      }
    catch (const InputError &error)
      {
        fail(error);
      }
    return rows;
  }
} // namespace dpcontact
