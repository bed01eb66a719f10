#ifndef DPCONTACT_DATABASE_FILES_FILES_H
#define DPCONTACT_DATABASE_FILES_FILES_H

#include <filesystem>
#include <string>

namespace dpcontact
{
  /// A new file beside @p target, `.<name>.<16 random hexadecimal digits>.tmp`, which no link and no
  /// other process's file can stand for. It is removed with the object unless it was published, so
  /// a failure leaves nothing behind. While the object lives it holds a lock (flock) on the file,
  /// by which remove_leftovers() knows that somebody is at work.
  class TemporaryFile
  {
  public:
    /// Creates the file. @throws FileError with the system's reason, or where the target is a
    /// directory or a device.
    explicit TemporaryFile(const std::filesystem::path &target);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile &)            = delete;
    TemporaryFile &operator=(const TemporaryFile &) = delete;

    const std::filesystem::path &path() const { return temporary; }

    /// Fills it, waits until the content is on disk, and reads it back.
    /// @throws FileError where one of these fails or other bytes come back.
    void write(const std::string &content) const;

    /// Waits until what others wrote to path() is on disk. @throws FileError.
    void sync() const;

    /// Renames it to the target, atomically, and syncs the directory. @throws FileError.
    void publish();
    bool is_published() const { return temporary.empty(); }

    /// Removes what killed processes left of the target, or of any target in @p directory. What a
    /// living process holds stays, and so does all of it on a file system without locks.
    static void remove_leftovers(const std::filesystem::path &target);
    static void remove_all_leftovers(const std::filesystem::path &directory);

  private:
    std::filesystem::path target;
    std::filesystem::path temporary;
    int                   descriptor = -1;
  };

  /// Keeps others that ask for it from the files of a directory while it lives. It does nothing
  /// where the directory or its file system cannot be locked.
  class DirectoryLock
  {
  public:
    explicit DirectoryLock(const std::filesystem::path &directory);
    ~DirectoryLock();
    DirectoryLock(const DirectoryLock &)            = delete;
    DirectoryLock &operator=(const DirectoryLock &) = delete;

  private:
    int descriptor;
  };

  /// The directory that lists a file's name; "." for a bare name.
  std::filesystem::path parent_of(const std::filesystem::path &file);

  /// Writes a file so that afterwards it holds @p content or, after a failure, what it held before.
  /// @throws FileError.
  void write_file(const std::filesystem::path &file, const std::string &content);

  /// The bytes of a file. @throws FileError if it is missing, no regular file, or cannot be read.
  std::string read_file(const std::filesystem::path &file);

  /// Makes renames and new names in a directory durable. @throws FileError.
  void sync_directory(const std::filesystem::path &directory);
} // namespace dpcontact

#endif
