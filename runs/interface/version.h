#ifndef DPCONTACT_RUNS_INTERFACE_VERSION_H
#define DPCONTACT_RUNS_INTERFACE_VERSION_H

#include <map>
#include <string>

namespace dpcontact
{
  /// `git describe` of the sources when they were built, "unknown" outside git.
  std::string git_revision();

  /// The program and the libraries that its numbers depend on, by name.
  std::map<std::string, std::string> versions();
} // namespace dpcontact

#endif
