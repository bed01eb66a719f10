#ifndef DPCONTACT_TESTS_SUPPORT_FAULTS_H
#define DPCONTACT_TESTS_SUPPORT_FAULTS_H

#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <dlfcn.h>
#include <fcntl.h>
#include <string>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

/// Makes calls of the C library fail in the test that includes it: its functions stand before the
/// library's. One source of a program may include it, or of a library that is loaded before a
/// program (failing_calls.cc).
namespace dpcontact::testing_faults
{
  inline std::string armed;
  inline int         first = 0, seen = 0, reason = 0;

  /// @param call "open" (of new files), "write" (to files), "fsync", "close", "flock" or "rename".
  /// @param when the first call that fails, counted from 1; every later one fails as well.
  /// @param error the value of errno; 0 ends the process with code 99 instead of the call.
  inline void arm(const std::string &call, const int when, const int error)
  {
    armed  = call;
    first  = when;
    reason = error;
    seen   = 0;
  }

  /// Calls work again.
  inline void disarm() { armed.clear(); }

  /// Whether this call is to fail.
  inline bool fails(const char *const call)
  {
    if (armed != call || ++seen < first)
      return false;
    if (reason == 0)
      _exit(99);
    errno = reason;
    return true;
  }

  inline bool is_regular_file(const int descriptor)
  {
    struct stat state = {};
    return ::fstat(descriptor, &state) == 0 && S_ISREG(state.st_mode);
  }

  /// The library's own function.
  template <typename Function>
  Function *next(const char *const name)
  {
    return reinterpret_cast<Function *>(dlsym(RTLD_NEXT, name));
  }
} // namespace dpcontact::testing_faults

extern "C"
{
  ssize_t write(const int descriptor, const void *data, const size_t size)
  {
    using namespace dpcontact::testing_faults;
    static const auto call = next<ssize_t(int, const void *, size_t)>("write");
    return descriptor > 2 && is_regular_file(descriptor) && fails("write")
             ? -1
             : call(descriptor, data, size);
  }

  int fsync(const int descriptor)
  {
    using namespace dpcontact::testing_faults;
    static const auto call = next<int(int)>("fsync");
    return fails("fsync") ? -1 : call(descriptor);
  }

  int close(const int descriptor)
  {
    using namespace dpcontact::testing_faults;
    static const auto call   = next<int(int)>("close");
    const bool        failed = fails("close");
    const int         error  = errno;
    const int         result = call(descriptor);
    if (!failed)
      return result;
    errno = error;
    return -1;
  }

  int flock(const int descriptor, const int operation) noexcept
  {
    using namespace dpcontact::testing_faults;
    static const auto call = next<int(int, int)>("flock");
    return fails("flock") ? -1 : call(descriptor, operation);
  }

  int rename(const char *const from, const char *const to) noexcept
  {
    using namespace dpcontact::testing_faults;
    static const auto call = next<int(const char *, const char *)>("rename");
    return fails("rename") ? -1 : call(from, to);
  }

  int open(const char *const path, const int flags, ...)
  {
    using namespace dpcontact::testing_faults;
    static const auto call = next<int(const char *, int, ...)>("open");
    va_list           arguments;
    va_start(arguments, flags);
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(arguments, mode_t) : 0;
    va_end(arguments);
    return (flags & O_CREAT) != 0 && fails("open") ? -1 : call(path, flags, mode);
  }
}

#endif
