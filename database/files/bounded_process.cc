#include "database/files/bounded_process.h"

#include "meshing/errors.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace dpcontact
{
  namespace
  {
    void limit(const int resource, const rlim_t value)
    {
      const rlimit values{value, value + 1}; // at the first a signal that tells its reason
      setrlimit(static_cast<__rlimit_resource>(resource), &values);
    }

    void limit_resources(const ProcessBounds &bounds)
    {
      limit(RLIMIT_CPU, bounds.processor_seconds);
#ifndef __SANITIZE_ADDRESS__ // which reserves terabytes
      limit(RLIMIT_AS, bounds.bytes);
#endif
      limit(RLIMIT_CORE, 0);
    }

    [[noreturn]] void child(const ProcessBounds               &bounds,
                            const std::function<ProcessEnd()> &work,
                            const int                          out,
                            const pid_t                        parent)
    {
      // The parent may have died before the signal was asked for.
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      if (::getppid() != parent)
        ::_exit(static_cast<int>(ExitCode::internal));
      for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL})
        std::signal(signal, SIG_DFL);
      limit_resources(bounds);
      const ProcessEnd result  = work();
      const ssize_t    written = ::write(out, result.text.data(), result.text.size());
      ::_exit(written < 0 ? static_cast<int>(ExitCode::internal) : result.code);
    }

    /// Signals that a process does not bring upon itself.
    bool is_from_outside(const int signal)
    {
      return signal == SIGKILL || signal == SIGTERM || signal == SIGINT || signal == SIGHUP;
    }

    /// All that the other end writes until it is closed. @return whether that was in time.
    bool read_all(const int in, const std::uint64_t seconds, std::string &text)
    {
      using Clock           = std::chrono::steady_clock;
      const auto deadline   = Clock::now() + std::chrono::seconds(seconds);
      const auto left_in_ms = [&deadline] {
        const auto left =
          std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
        return static_cast<int>(std::clamp<std::int64_t>(left, 0, 1000));
      };
      pollfd polled{in, POLLIN, 0};
      while (Clock::now() < deadline)
        {
          if (::poll(&polled, 1, left_in_ms()) <= 0)
            continue;
          char          buffer[4096];
          const ssize_t count = ::read(in, buffer, sizeof(buffer));
          if (count > 0)
            text.append(buffer, static_cast<std::size_t>(count));
          else if (count == 0 || errno != EINTR)
            return true;
        }
      return false;
    }
  } // namespace

  ProcessEnd in_process_of_its_own(const std::string                 &what,
                                   const ProcessBounds               &bounds,
                                   const std::function<ProcessEnd()> &work)
  {
    int ends[2];
    if (::pipe(ends) != 0)
      throw FileError(std::string("cannot make a pipe: ") + std::strerror(errno));
    const pid_t parent  = ::getpid();
    const pid_t process = ::fork();
    if (process == 0)
      {
        ::close(ends[0]);
        child(bounds, work, ends[1], parent);
      }
    const int failure = errno;
    ::close(ends[1]);
    if (process < 0)
      {
        ::close(ends[0]);
        throw FileError(std::string("cannot start a process: ") + std::strerror(failure));
      }
    ProcessEnd end;
    const bool in_time = read_all(ends[0], bounds.wall_seconds, end.text);
    ::close(ends[0]);
    if (!in_time)
      ::kill(process, SIGKILL);
    int status = 0;
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR)
      {}
    if (!in_time)
      throw FileError("cannot " + what + ": the process that does it did not end within " +
                      std::to_string(bounds.wall_seconds) + " s");
    if (WIFEXITED(status))
      end.code = WEXITSTATUS(status);
    else
      end.signal = WTERMSIG(status);
    if (is_from_outside(end.signal))
      throw FileError("cannot " + what + ": the process that does it was ended (" +
                      strsignal(end.signal) + ")");
    return end;
  }
} // namespace dpcontact
