#ifndef DPCONTACT_DATABASE_DIGEST_H
#define DPCONTACT_DATABASE_DIGEST_H

#include <filesystem>
#include <string>

namespace dpcontact
{
  /// SHA-256 as 64 lower-case hexadecimal digits.
  std::string sha256(const std::string &text);

  /// SHA-256 of the bytes of a file. @throws FileError if it cannot be read.
  std::string sha256_of_file(const std::filesystem::path &file);
} // namespace dpcontact

#endif
