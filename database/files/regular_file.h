#ifndef DPCONTACT_DATABASE_FILES_REGULAR_FILE_H
#define DPCONTACT_DATABASE_FILES_REGULAR_FILE_H

#include <cstdint>
#include <filesystem>
#include <limits>

namespace dpcontact
{
  /// Refuses what would not end or does not belong to one content when it is read: directories,
  /// pipes, sockets and devices. A link counts as what it leads to. It opens nothing.
  /// @param largest number of bytes that the file may have.
  /// @throws FileError with the system's reason where the file is missing or cannot be reached, or
  /// saying what it is; InputError naming both sizes where it is larger.
  void require_regular_file(const std::filesystem::path &file,
                            std::uintmax_t largest = std::numeric_limits<std::uintmax_t>::max());
} // namespace dpcontact

#endif
