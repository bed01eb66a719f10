#ifndef DPCONTACT_RUNS_INTERFACE_PARAMETER_FILE_H
#define DPCONTACT_RUNS_INTERFACE_PARAMETER_FILE_H

#include "runs/interface/settings.h"

#include <filesystem>

namespace dpcontact
{
  /// Reads a parameter file ("set E = 10GPa, 20GPa", one entry a line, # begins a comment) whose
  /// entries are named like the options and are checked like them.
  /// @param allowed the entries that may stand in it
  /// @return what the file sets
  /// @throws FileError if it cannot be read, InputError naming file and line of an unknown or
  /// ill-typed entry, or of a line that is no entry.
  SettingTexts read_parameter_file(const std::filesystem::path &file,
                                   const std::vector<Setting>  &allowed);
} // namespace dpcontact

#endif
