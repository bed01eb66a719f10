#ifndef DPCONTACT_DATABASE_ROWS_READ_IN_CHILD_H
#define DPCONTACT_DATABASE_ROWS_READ_IN_CHILD_H

#include "meshing/errors.h"

#include <filesystem>
#include <string>

namespace dpcontact
{
  /// How an HDF5 file reads in a process of its own, with bounded time and memory: HDF5 can crash
  /// or loop on content that is not what it wrote.
  struct ChildReading
  {
    ExitCode    code; ///< success where every number of the file could be read
    std::string text; ///< rows, or the reason
  };

  /// @param file its name, for messages.
  /// @param bytes its content.
  /// @throws FileError if no process can be started, or somebody ended it.
  ChildReading read_in_child(const std::filesystem::path &file, const std::string &bytes);
} // namespace dpcontact

#endif
