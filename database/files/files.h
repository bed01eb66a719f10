#ifndef DPCONTACT_DATABASE_FILES_FILES_H
#define DPCONTACT_DATABASE_FILES_FILES_H

#include <filesystem>
#include <string>

namespace dpcontact
{
  /// A file beside @p target under a name that no other process uses, `.<name>.<pid>.<count>.tmp`.
  /// It is removed with the object unless it was published, so a failure leaves nothing
  /// behind.
  class TemporaryFile
  {
  public:
    explicit TemporaryFile(const std::filesystem::path &target);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile &)            = delete;
    TemporaryFile &operator=(const TemporaryFile &) = delete;

    const std::filesystem::path &path() const { return temporary; }

    /// Creates the file and fills it. @throws FileError.
    void write(const std::string &content) const;

    /// Waits until the content is on disk. @throws FileError.
    void sync() const;

    /// Renames it to the target, atomically, and syncs the directory. @throws FileError.
    void publish();

    /// Removes what killed processes left in @p directory for targets whose names begin with
    /// @p prefix. Call it only while nobody else can be writing those.
    static void remove_leftovers(const std::filesystem::path &directory, const std::string &prefix);

  private:
    std::filesystem::path target;
    std::filesystem::path temporary;
  };

  /// The directory that lists a file's name; "." for a bare name.
  std::filesystem::path parent_of(const std::filesystem::path &file);

  /// Writes a file so that afterwards it holds @p content or, after a failure, what it held before.
  /// @throws FileError.
  void write_file(const std::filesystem::path &file, const std::string &content);

  /// The bytes of a file. @throws FileError if it is missing or cannot be read.
  std::string read_file(const std::filesystem::path &file);

  /// Makes renames and new names in a directory durable. @throws FileError.
  void sync_directory(const std::filesystem::path &directory);
} // namespace dpcontact

#endif
