#ifndef DPCONTACT_RUNS_INTERFACE_PARAMETER_FILE_H
#define DPCONTACT_RUNS_INTERFACE_PARAMETER_FILE_H

#include "runs/interface/settings.h"

#include <filesystem>

namespace dpcontact
{
  /// Reads a parameter file ("set E = 10GPa, 20GPa", one entry a line, # begins a comment) whose
  /// entries are named like the options and are checked like them.
  /// A line "include other.prm" stands for what is in that file, at most eight files deep.
  /// @param allowed the entries that may stand in it
  /// @return what the file sets
  /// @throws FileError if it, or what it includes, cannot be read or is no regular file; InputError
  /// where one is larger than 16 MiB or includes itself, and naming file and line of an unknown or
  /// ill-typed entry, or of a line that is no entry.
  SettingTexts read_parameter_file(const std::filesystem::path &file,
                                   const std::vector<Setting>  &allowed);
} // namespace dpcontact

#endif
