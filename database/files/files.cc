#include "database/files/files.h"

#include "meshing/errors.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <random>
#include <regex>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace dpcontact
{
  namespace
  {
    [[noreturn]] void fail(const std::string &what, const std::filesystem::path &path)
    {
      throw FileError("cannot " + what + " " + path.string() + ": " + std::strerror(errno));
    }

    /// An open file or directory.
    class Descriptor
    {
    public:
      /// @param blamed the path that the user knows, for the message of a failure.
      Descriptor(const std::filesystem::path &path,
                 const int                    flags,
                 const std::string           &what,
                 const std::filesystem::path &blamed)
        : descriptor(::open(path.c_str(), flags | O_CLOEXEC, 0666))
      {
        if (descriptor < 0)
          fail(what, blamed);
      }
      ~Descriptor() { ::close(descriptor); }
      Descriptor(const Descriptor &)            = delete;
      Descriptor &operator=(const Descriptor &) = delete;

      int get() const { return descriptor; }

    private:
      int descriptor;
    };

  } // namespace

  std::filesystem::path parent_of(const std::filesystem::path &file)
  {
    return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  }

  namespace
  {
    constexpr std::size_t random_digits = 16;

    std::string random_hexadecimal()
    {
      std::random_device source;
      std::string        text;
      while (text.size() < random_digits)
        text += "0123456789abcdef"[source() % 16];
      return text;
    }

    bool still_listed(const int descriptor)
    {
      struct stat state = {};
      return ::fstat(descriptor, &state) == 0 && state.st_nlink > 0;
    }

    /// Whether a name in a directory is that of a temporary file, of @p target or of any.
    bool is_temporary(const std::string &name, const std::string &target)
    {
      static const std::regex form("\\.(.+)\\.[0-9a-f]{" + std::to_string(random_digits) +
                                   "}\\.tmp");
      std::smatch             parts;
      return std::regex_match(name, parts, form) && (target.empty() || parts[1] == target);
    }

    void remove_unheld(const std::filesystem::path &directory, const std::string &target)
    {
      std::error_code ignored; // a leftover that cannot be removed does no harm
      for (const auto &entry : std::filesystem::directory_iterator(directory, ignored))
        if (is_temporary(entry.path().filename().string(), target))
          {
            const int file =
              ::open(entry.path().c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
            if (file < 0)
              continue;
            if (::flock(file, LOCK_EX | LOCK_NB) == 0)
              ::unlink(entry.path().c_str());
            ::close(file);
          }
    }
  } // namespace

  TemporaryFile::TemporaryFile(const std::filesystem::path &file)
    : target(file)
  {
    std::error_code unknown;
    const auto      state = std::filesystem::status(target, unknown);
    if (std::filesystem::exists(state) && !std::filesystem::is_regular_file(state))
      throw FileError(
        "cannot write " + target.string() + ": " +
        (std::filesystem::is_directory(state) ? "it is a directory" : "it is no regular file"));
    while (descriptor < 0)
      {
        temporary =
          parent_of(file) / ("." + file.filename().string() + "." + random_hexadecimal() + ".tmp");
        descriptor = ::open(temporary.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor < 0)
          {
            if (errno != EEXIST)
              fail("write", target);
            continue;
          }
        // Somebody who removes leftovers may have been faster than the lock.
        ::flock(descriptor, LOCK_EX);
        if (!still_listed(descriptor))
          ::close(std::exchange(descriptor, -1));
      }
  }

  TemporaryFile::~TemporaryFile()
  {
    if (!temporary.empty())
      ::unlink(temporary.c_str());
    ::close(descriptor);
  }

  namespace
  {
    /// Makes a file that becomes larger than the process may write (RLIMIT_FSIZE) an error of the
    /// call; the signal would end the process.
    class FileSizeErrors
    {
    public:
      FileSizeErrors()
        : previous(std::signal(SIGXFSZ, SIG_IGN))
      {}
      ~FileSizeErrors() { std::signal(SIGXFSZ, previous); }
      FileSizeErrors(const FileSizeErrors &)            = delete;
      FileSizeErrors &operator=(const FileSizeErrors &) = delete;

    private:
      void (*previous)(int);
    };
  } // namespace

  void TemporaryFile::write(const std::string &content) const
  {
    const FileSizeErrors guard;
    std::size_t          done = 0;
    while (done < content.size())
      {
        const ssize_t count = ::write(descriptor, content.data() + done, content.size() - done);
        if (count > 0)
          done += static_cast<std::size_t>(count);
        else if (count == 0 || errno != EINTR)
          fail("write", target);
      }
    sync();
    if (read_file(temporary) != content)
      throw FileError("cannot write " + target.string() +
                      ": other bytes come back than were written");
  }

  void TemporaryFile::sync() const
  {
    if (::fsync(descriptor) != 0)
      fail("sync", target);
    // Some file systems tell only a close that bytes were lost; the lock must outlive it.
    const int copy = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
    if (copy < 0 || ::close(copy) != 0)
      fail("write", target);
  }

  void TemporaryFile::publish()
  {
    if (::rename(temporary.c_str(), target.c_str()) != 0)
      fail("write", target);
    temporary.clear();
    sync_directory(parent_of(target));
  }

  void TemporaryFile::remove_leftovers(const std::filesystem::path &file)
  {
    remove_unheld(parent_of(file), file.filename().string());
  }

  void TemporaryFile::remove_all_leftovers(const std::filesystem::path &directory)
  {
    remove_unheld(directory, "");
  }

  DirectoryLock::DirectoryLock(const std::filesystem::path &directory)
    : descriptor(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC))
  {
    while (descriptor >= 0 && ::flock(descriptor, LOCK_EX) != 0 && errno == EINTR)
      {}
  }

  DirectoryLock::~DirectoryLock()
  {
    if (descriptor >= 0)
      ::close(descriptor);
  }

  void write_file(const std::filesystem::path &file, const std::string &content)
  {
    TemporaryFile temporary(file);
    temporary.write(content);
    temporary.publish();
  }

  std::string read_file(const std::filesystem::path &path)
  {
    const Descriptor file(path, O_RDONLY | O_NONBLOCK, "read", path); // no waiting for a pipe
    struct stat      status = {};
    if (::fstat(file.get(), &status) != 0)
      fail("read", path);
    if (S_ISDIR(status.st_mode))
      throw FileError("cannot read " + path.string() + ": it is a directory");
    if (!S_ISREG(status.st_mode))
      throw FileError("cannot read " + path.string() +
                      ": it is no regular file (a pipe, a socket or a device)");
    std::string content;
    std::string buffer(1 << 16, '\0');
    while (true)
      {
        const ssize_t count = ::read(file.get(), buffer.data(), buffer.size());
        if (count > 0)
          content.append(buffer, 0, static_cast<std::size_t>(count));
        else if (count == 0)
          return content;
        else if (errno != EINTR)
          fail("read", path);
      }
  }

  void sync_directory(const std::filesystem::path &directory)
  {
    const Descriptor descriptor(directory, O_RDONLY | O_DIRECTORY, "open", directory);
    if (::fsync(descriptor.get()) != 0)
      fail("sync", directory);
  }
} // namespace dpcontact
