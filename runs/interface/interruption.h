#ifndef DPCONTACT_RUNS_INTERFACE_INTERRUPTION_H
#define DPCONTACT_RUNS_INTERFACE_INTERRUPTION_H

#include <string>

namespace dpcontact
{
  /// While it lives, an interruption (Ctrl-C, SIGINT, SIGTERM) first says on standard error what is
  /// kept and how to go on, and then ends the process as it would without this. Processes that are
  /// forked meanwhile end without a word. There may be one at a time; under mpirun, whose signals
  /// are the launcher's own, it does nothing.
  class InterruptionMessage
  {
  public:
    explicit InterruptionMessage(const std::string &message);
    ~InterruptionMessage();
    InterruptionMessage(const InterruptionMessage &)            = delete;
    InterruptionMessage &operator=(const InterruptionMessage &) = delete;
  };
} // namespace dpcontact

#endif
