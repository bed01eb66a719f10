#ifndef DPCONTACT_SOLVER_PATH_METHOD_VERSION_H
#define DPCONTACT_SOLVER_PATH_METHOD_VERSION_H

namespace dpcontact
{
  /// Raised by one with every change that moves computed numbers: rows of different methods do not
  /// mix in one database.
  constexpr int method_version = 2;
} // namespace dpcontact

#endif
