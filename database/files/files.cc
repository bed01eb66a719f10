#include "database/files/files.h"

#include "meshing/errors.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

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

  TemporaryFile::TemporaryFile(const std::filesystem::path &file)
    : target(file)
  {
    static std::atomic<unsigned int> count{0};
    temporary =
      parent_of(file) / ("." + file.filename().string() + "." + std::to_string(::getpid()) + "." +
                         std::to_string(count++) + ".tmp");
  }

  TemporaryFile::~TemporaryFile()
  {
    if (!temporary.empty())
      ::unlink(temporary.c_str());
  }

  void TemporaryFile::write(const std::string &content) const
  {
    const Descriptor file(temporary, O_WRONLY | O_CREAT | O_TRUNC, "write", target);
    std::size_t      done = 0;
    while (done < content.size())
      {
        const ssize_t count = ::write(file.get(), content.data() + done, content.size() - done);
        if (count >= 0)
          done += static_cast<std::size_t>(count);
        else if (errno != EINTR)
          fail("write", target);
      }
  }

  void TemporaryFile::sync() const
  {
    const Descriptor file(temporary, O_RDONLY, "sync", target);
    if (::fsync(file.get()) != 0)
      fail("sync", target);
  }

  void TemporaryFile::publish()
  {
    if (::rename(temporary.c_str(), target.c_str()) != 0)
      fail("write", target);
    temporary.clear();
    sync_directory(parent_of(target));
  }

  void TemporaryFile::remove_leftovers(const std::filesystem::path &directory,
                                       const std::string           &prefix)
  {
    std::error_code ignored; // a leftover that cannot be removed does no harm
    for (const auto &entry : std::filesystem::directory_iterator(directory, ignored))
      if (entry.path().extension() == ".tmp" &&
          entry.path().filename().string().rfind("." + prefix, 0) == 0)
        std::filesystem::remove(entry.path(), ignored);
  }

  void write_file(const std::filesystem::path &file, const std::string &content)
  {
    TemporaryFile temporary(file);
    temporary.write(content);
    temporary.sync();
    temporary.publish();
  }

  std::string read_file(const std::filesystem::path &path)
  {
    const Descriptor file(path, O_RDONLY, "read", path);
    std::string      content;
    std::string      buffer(1 << 16, '\0');
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
