#ifndef DPCONTACT_SOLVER_ENVIRONMENT_H
#define DPCONTACT_SOLVER_ENVIRONMENT_H

namespace dpcontact
{
  /// Starts what the solver's libraries need once a process (gmsh, threads) and ends it. Keep one
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
