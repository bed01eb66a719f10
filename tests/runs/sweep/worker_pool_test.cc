#include "runs/sweep/worker_pool.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <set>
#include <signal.h>
#include <stdexcept>
#include <stdlib.h>
#include <unistd.h>

namespace
{
  using namespace dpcontact;

  std::vector<std::size_t> first_jobs(const std::size_t n)
  {
    std::vector<std::size_t> jobs(n);
    std::iota(jobs.begin(), jobs.end(), 0);
    return jobs;
  }

  std::map<std::size_t, JobResult>
  run(const std::size_t n, const unsigned int processes, const Worker &worker)
  {
    std::map<std::size_t, JobResult> results;
    run_jobs(
      first_jobs(n),
      processes,
      [&] { return worker; },
      [](std::size_t) {},
      [&](const JobResult &result) {
        EXPECT_TRUE(results.emplace(result.job, result).second) << "job ended twice";
      });
    return results;
  }

  TEST(WorkerPool, every_job_runs_once_in_a_process_of_its_own)
  {
    for (const unsigned int processes : {1U, 3U, 20U})
      {
        const auto results = run(8, processes, [](const std::size_t job) {
          return std::to_string(getpid()) + std::string(job * 40000, 'x'); // more than a pipe holds
        });
        ASSERT_EQ(results.size(), 8U);
        std::set<std::string> children;
        for (const auto &[job, result] : results)
          {
            EXPECT_FALSE(result.died);
            const auto end = std::min(result.text.find('x'), result.text.size());
            EXPECT_EQ(result.text.size() - end, job * 40000);
            children.insert(result.text.substr(0, end));
          }
        EXPECT_EQ(children.count(std::to_string(getpid())), 0U);
        EXPECT_LE(children.size(), processes);
      }
  }

  TEST(WorkerPool, no_jobs_start_no_process)
  {
    EXPECT_TRUE(run(0, 4, [](std::size_t) { return std::string(); }).empty());
  }

  TEST(WorkerPool, a_job_whose_child_dies_is_tried_once_more)
  {
    std::string name(::testing::TempDir() + "dpcontact-worker-XXXXXX");
    const int   tries   = mkstemp(name.data());
    const auto  results = run(4, 2, [&](const std::size_t job) -> std::string {
      if (job == 2 && lseek(tries, 0, SEEK_END) == 0)
        {
          EXPECT_EQ(write(tries, "x", 1), 1);
          raise(SIGKILL);
        }
      return "done";
    });
    close(tries);
    unlink(name.c_str());
    ASSERT_EQ(results.size(), 4U);
    for (const auto &[job, result] : results)
      EXPECT_FALSE(result.died) << job;
  }

  TEST(WorkerPool, a_child_that_dies_twice_loses_only_its_job)
  {
    const auto results = run(9, 2, [](const std::size_t job) -> std::string {
      if (job == 3)
        raise(SIGKILL);
      if (job == 5)
        _exit(9);
      if (job == 7)
        throw std::runtime_error("expected by the test");
      return "done";
    });
    ASSERT_EQ(results.size(), 9U);
    for (const auto &[job, result] : results)
      {
        EXPECT_EQ(result.died, job == 3 || job == 5 || job == 7) << job;
        if (!result.died)
          {
            EXPECT_EQ(result.text, "done");
          }
      }
    EXPECT_NE(results.at(3).text.find("signal 9"), std::string::npos) << results.at(3).text;
    EXPECT_NE(results.at(5).text.find("exit code 9"), std::string::npos) << results.at(5).text;
  }

  TEST(WorkerPool, workers_that_cannot_start_lose_every_job_but_do_not_hang)
  {
    std::size_t died = 0;
    run_jobs(
      first_jobs(3),
      2,
      []() -> Worker { throw std::runtime_error("expected by the test"); },
      [](std::size_t) {},
      [&](const JobResult &result) { died += result.died; });
    EXPECT_EQ(died, 3U);
  }

  TEST(WorkerPool, an_exception_of_the_parent_ends_the_children)
  {
    const Worker endless = [](const std::size_t job) -> std::string {
      while (job > 0)
        pause();
      return "first";
    };
    EXPECT_THROW(run_jobs(
                   first_jobs(4),
                   3,
                   [&] { return endless; },
                   [](std::size_t) {},
                   [](const JobResult &) { throw std::runtime_error("stop"); }),
                 std::runtime_error);
  }
} // namespace
