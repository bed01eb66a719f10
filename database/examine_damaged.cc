#include "database/checks.h"
#include "meshing/errors.h"

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
    constexpr rlim_t most_seconds = 20;
    constexpr rlim_t most_bytes   = rlim_t(4) << 30;

    void limit(const int resource, const rlim_t value)
    {
      const rlimit bounds{value, value};
      setrlimit(static_cast<__rlimit_resource>(resource), &bounds);
    }

    std::string try_reading(const std::filesystem::path &file)
    {
      try
        {
          const Database database = read_store_unchecked(file);
          return "it can still be read as " + std::to_string(database.records.size()) +
                 " rows, which may be wrong";
        }
      catch (const std::exception &error)
        {
          return error.what();
        }
    }
  } // namespace

  std::string examine_damaged(const std::filesystem::path &file)
  {
    int ends[2];
    if (::pipe(ends) != 0)
      throw FileError(std::string("cannot make a pipe: ") + std::strerror(errno));
    const pid_t child = ::fork();
    if (child < 0)
      throw FileError(std::string("cannot start a process: ") + std::strerror(errno));
    if (child == 0)
      {
        for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL})
          std::signal(signal, SIG_DFL);
        ::close(ends[0]);
        limit(RLIMIT_CPU, most_seconds);
        limit(RLIMIT_AS, most_bytes);
        limit(RLIMIT_CORE, 0);
        const std::string text    = try_reading(file);
        const ssize_t     ignored = ::write(ends[1], text.data(), text.size());
        ::_exit(ignored < 0);
      }
    ::close(ends[1]);
    std::string text;
    char        buffer[4096];
    for (ssize_t count; (count = ::read(ends[0], buffer, sizeof(buffer))) != 0;)
      if (count > 0)
        text.append(buffer, static_cast<std::size_t>(count));
      else if (errno != EINTR)
        break;
    ::close(ends[0]);
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR)
      {}
    if (WIFSIGNALED(status))
      return std::string("reading it crashes HDF5 (") + strsignal(WTERMSIG(status)) + ")";
    return text;
  }
} // namespace dpcontact
