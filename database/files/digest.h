#ifndef DPCONTACT_DATABASE_FILES_DIGEST_H
#define DPCONTACT_DATABASE_FILES_DIGEST_H

#include <filesystem>
#include <string>

namespace dpcontact
{
  /// SHA-256 as 64 lower-case hexadecimal digits.
  std::string sha256(const std::string &text);

  /// SHA-256 of the bytes of a file. @throws FileError if it cannot be read.
  std::string sha256_of_file(const std::filesystem::path &file);

  /// The file `<file>.sha256`, which holds the digest of a file in the form of the program
  /// sha256sum.
  std::filesystem::path digest_path_of(const std::filesystem::path &file);

  /// Writes a file and its digest, in one step for whoever reads them with read_with_digest():
  /// first the digest file lists the digests of the new content and of the present one, then the
  /// file is renamed into place, then the digest of the new content stands alone. A process that
  /// ends at any moment leaves a pair that agrees. Each file is complete on disk, and was read
  /// back, before it replaces an older one.
  /// @throws FileError where one of them cannot be written; an earlier pair then stays as it was.
  void write_with_digest(const std::filesystem::path &file, const std::string &content);

  /// The content of a file that agrees with its digest.
  /// @throws FileError if it cannot be read, CorruptData as check_digest() does.
  std::string read_with_digest(const std::filesystem::path &file);

  /// @throws CorruptData where the digest of the file is missing, damaged or that of other content,
  /// FileError if it cannot be read.
  void check_digest(const std::filesystem::path &file);

  /// Whether the content is that of an HDF5 file, by its first bytes.
  bool begins_as_hdf5(const std::string &content);
} // namespace dpcontact

#endif
