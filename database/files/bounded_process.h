#ifndef DPCONTACT_DATABASE_FILES_BOUNDED_PROCESS_H
#define DPCONTACT_DATABASE_FILES_BOUNDED_PROCESS_H

#include <cstdint>
#include <functional>
#include <string>

namespace dpcontact
{
  /// What a process of its own may use before it is ended.
  struct ProcessBounds
  {
    std::uint64_t processor_seconds;
    std::uint64_t wall_seconds; ///< processors may be shared with others: many times the former
    std::uint64_t bytes;        ///< of address space, the program's own included
  };

  /// What is left of a process: a code and a text, or the signal that ended it.
  struct ProcessEnd
  {
    int         code = 0;
    std::string text;
    int         signal = 0; ///< 0 where it ended by itself
  };

  /// Does `work` in a process of its own, for what may crash, loop or wait for ever. It ends with
  /// the process that started it, leaves no core, and changes nothing here.
  /// @param what it does, for messages: "read FILE".
  /// @throws FileError if no process can be started, somebody else ended it, or it did not end
  /// within its wall time: faults of the machine, not of what was read.
  ProcessEnd in_process_of_its_own(const std::string                 &what,
                                   const ProcessBounds               &bounds,
                                   const std::function<ProcessEnd()> &work);
} // namespace dpcontact

#endif
