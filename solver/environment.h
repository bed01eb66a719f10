#ifndef DPCONTACT_SOLVER_ENVIRONMENT_H
#define DPCONTACT_SOLVER_ENVIRONMENT_H

namespace dpcontact
{
  /// Keeps the solver's libraries to one thread a process. Keep one
  /// alive while solving. Construct it after any fork, never before.
  class Environment
  {
  public:
    Environment();
    ~Environment();
    Environment(const Environment &)            = delete;
    Environment &operator=(const Environment &) = delete;
  };
} // namespace dpcontact

#endif
