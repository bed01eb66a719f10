#include "database/rows/read_in_child.h"

#include "database/rows/store.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace dpcontact
{
  namespace
  {
    // A database reads at tens of MB a second; the address space holds the program as well.
    constexpr rlim_t                  least_seconds = 2, bytes_a_second = 1 << 20;
    [[maybe_unused]] constexpr rlim_t least_bytes = rlim_t(4) << 30, times_its_size = 16;

    void limit(const int resource, const rlim_t value)
    {
      const rlimit bounds{value, value + 1}; // at the first a signal that tells its reason
      setrlimit(static_cast<__rlimit_resource>(resource), &bounds);
    }

    void limit_resources(const std::size_t size)
    {
      [[maybe_unused]] const rlim_t bytes = size;
      limit(RLIMIT_CPU, least_seconds + bytes / bytes_a_second);
#ifndef __SANITIZE_ADDRESS__ // which reserves terabytes
      limit(RLIMIT_AS, least_bytes + times_its_size * bytes);
#endif
      limit(RLIMIT_CORE, 0);
    }

    ChildReading read(const std::filesystem::path &file, const std::string &bytes)
    {
      try
        {
          return {ExitCode::success,
                  std::to_string(read_store_unchecked(file, bytes).records.size()) + " rows"};
        }
      catch (const Error &error)
        {
          return {error.code(), error.what()};
        }
      catch (const std::exception &error)
        {
          return {ExitCode::corrupt_data,
                  file.string() + " is not a database of this program: " + error.what()};
        }
    }

    [[noreturn]] void
    child(const std::filesystem::path &file, const std::string &bytes, const int out)
    {
      for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL})
        std::signal(signal, SIG_DFL);
      limit_resources(bytes.size());
      const ChildReading result  = read(file, bytes);
      const ssize_t      written = ::write(out, result.text.data(), result.text.size());
      ::_exit(written < 0 ? static_cast<int>(ExitCode::internal) : static_cast<int>(result.code));
    }

    /// Signals that a process does not bring upon itself.
    bool is_from_outside(const int signal)
    {
      return signal == SIGKILL || signal == SIGTERM || signal == SIGINT || signal == SIGHUP;
    }

    std::string read_all(const int in)
    {
      std::string text;
      char        buffer[4096];
      for (ssize_t count; (count = ::read(in, buffer, sizeof(buffer))) != 0;)
        if (count > 0)
          text.append(buffer, static_cast<std::size_t>(count));
        else if (errno != EINTR)
          break;
      return text;
    }
  } // namespace

  ChildReading read_in_child(const std::filesystem::path &file, const std::string &bytes)
  {
    int ends[2];
    if (::pipe(ends) != 0)
      throw FileError(std::string("cannot make a pipe: ") + std::strerror(errno));
    const pid_t process = ::fork();
    if (process == 0)
      {
        ::close(ends[0]);
        child(file, bytes, ends[1]);
      }
    const int failure = errno;
    ::close(ends[1]);
    if (process < 0)
      {
        ::close(ends[0]);
        throw FileError(std::string("cannot start a process: ") + std::strerror(failure));
      }
    const std::string text = read_all(ends[0]);
    ::close(ends[0]);
    int status = 0;
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR)
      {}
    if (WIFSIGNALED(status) && is_from_outside(WTERMSIG(status)))
      throw FileError("cannot read " + file.string() + ": the process that reads it was ended (" +
                      strsignal(WTERMSIG(status)) + ")");
    if (WIFSIGNALED(status))
      return {ExitCode::corrupt_data,
              file.string() + " cannot be read: HDF5 ended with '" + strsignal(WTERMSIG(status)) +
                "' in a process of its own"};
    return {static_cast<ExitCode>(WEXITSTATUS(status)), text};
  }
} // namespace dpcontact
