#ifndef DPCONTACT_RUNS_INTERFACE_OUTPUTS_H
#define DPCONTACT_RUNS_INTERFACE_OUTPUTS_H

#include <filesystem>
#include <vector>

namespace dpcontact
{
  /// The files that a command reads and those that it will write, as they were given. Empty paths
  /// stand for options that were not given.
  struct CommandFiles
  {
    std::vector<std::filesystem::path> inputs, outputs;
  };

  /// Every command calls this before it computes anything.
  /// A file that is read must be a regular one. A file that is written must be no other one's, with
  /// the digest (`.sha256`) beside either, also through links, and must have a place: a directory
  /// that can be written into, and a name that is short enough for the temporary files that stand
  /// beside it while it is written.
  /// @throws InputError naming both files where an output is an input or another output, FileError
  /// with the system's reason where a file cannot be read or has no place.
  void check_files(const CommandFiles &files);
} // namespace dpcontact

#endif
