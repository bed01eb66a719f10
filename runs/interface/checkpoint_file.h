#ifndef DPCONTACT_RUNS_INTERFACE_CHECKPOINT_FILE_H
#define DPCONTACT_RUNS_INTERFACE_CHECKPOINT_FILE_H

#include "runs/interface/documents.h"
#include "solver/system/arrays.h"

#include <filesystem>

namespace dpcontact
{
  /// Writes the state of a computation and what it is a computation of; the file is as before or
  /// complete, however the process ends. A line that names the format, the SHA-256 of what follows,
  /// a line of JSON with settings and sizes, then the numbers as they are in memory.
  /// @throws FileError where it cannot be written.
  void
  write_checkpoint(const std::filesystem::path &file, const Json &settings, const Arrays &state);

  /// The state in the file.
  /// @throws FileError where it cannot be read, CorruptData where it is damaged or no checkpoint,
  /// SettingsMismatch naming what differs where it was written with other settings.
  Arrays read_checkpoint(const std::filesystem::path &file, const Json &settings);
} // namespace dpcontact

#endif
