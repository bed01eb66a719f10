// A process of its own ends: by itself, at its bounds, and with the process that started it.
#include "database/files/bounded_process.h"
#include "meshing/errors.h"
#include "tests/support/records.h"

#include <chrono>
#include <csignal>
#include <sys/wait.h>
#include <thread>

using namespace dpcontact;
using namespace dpcontact::testing_database;

namespace
{
  constexpr ProcessBounds wide{100, 100, std::uint64_t(1) << 40};

  using Clock = std::chrono::steady_clock;

  void sleep_for_ever()
  {
    while (true)
      ::pause();
  }

  /// Whether the process runs; a dead one that nobody has asked about yet does not.
  bool runs(const pid_t process)
  {
    const std::string status = slurp("/proc/" + std::to_string(process) + "/status");
    return !status.empty() && status.find("State:\tZ") == std::string::npos &&
           status.find("State:\tX") == std::string::npos;
  }
} // namespace

TEST(BoundedProcess, GivesItsCodeAndText)
{
  int              value = 0;
  const ProcessEnd end   = in_process_of_its_own("try", wide, [&value] {
    value = 1;
    return ProcessEnd{7, std::string(100000, 'x'), 0};
  });
  EXPECT_EQ(end.code, 7);
  EXPECT_EQ(end.text, std::string(100000, 'x'));
  EXPECT_EQ(end.signal, 0);
  EXPECT_EQ(value, 0);
}

TEST(BoundedProcess, SaysTheSignalThatItBroughtUponItself)
{
  const ProcessEnd crash = in_process_of_its_own("try", wide, []() -> ProcessEnd {
    std::raise(SIGSEGV);
    return {};
  });
  EXPECT_EQ(crash.signal, SIGSEGV);
  const ProcessEnd loop = in_process_of_its_own("try", {1, 100, wide.bytes}, []() -> ProcessEnd {
    for (volatile int i = 0;; i = i + 1)
      {}
  });
  EXPECT_EQ(loop.signal, SIGXCPU);
}

TEST(BoundedProcess, WaitsNoLongerThanItsWallTime)
{
  const auto        start   = Clock::now();
  const std::string message = message_of<FileError>([] {
    in_process_of_its_own("read a.h5", {100, 1, wide.bytes}, []() -> ProcessEnd {
      sleep_for_ever();
      return {};
    });
  });
  EXPECT_NE(message.find("cannot read a.h5: the process that does it did not end within 1 s"),
            std::string::npos)
    << message;
  EXPECT_LT(Clock::now() - start, std::chrono::seconds(20));
}

TEST(BoundedProcess, SaysThatSomebodyEndedIt)
{
  EXPECT_NE(message_of<FileError>([] {
              in_process_of_its_own("try", wide, []() -> ProcessEnd {
                ::kill(::getpid(), SIGTERM);
                sleep_for_ever();
                return {};
              });
            }).find("was ended"),
            std::string::npos);
}

TEST(BoundedProcess, DiesWithItsParent)
{
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const pid_t parent = ::fork();
  if (parent == 0)
    {
      in_process_of_its_own("try", wide, [&ends]() -> ProcessEnd {
        const pid_t self = ::getpid();
        if (::write(ends[1], &self, sizeof self) == sizeof self)
          sleep_for_ever();
        return {};
      });
      ::_exit(0);
    }
  pid_t process = 0;
  ASSERT_EQ(::read(ends[0], &process, sizeof process), static_cast<ssize_t>(sizeof process));
  EXPECT_TRUE(runs(process));
  ::kill(parent, SIGKILL);
  ASSERT_EQ(::waitpid(parent, nullptr, 0), parent);
  for (const auto deadline = Clock::now() + std::chrono::seconds(20);
       runs(process) && Clock::now() < deadline;)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_FALSE(runs(process));
  ::close(ends[0]);
  ::close(ends[1]);
}
