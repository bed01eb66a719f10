#ifndef DPCONTACT_SOLVER_OUTPUT_FIELD_SINK_H
#define DPCONTACT_SOLVER_OUTPUT_FIELD_SINK_H

#include <functional>
#include <string>

namespace dpcontact
{
  /// Takes a file of fields: its name, without directory, and its content. Each process gives its
  /// own.
  using FieldSink = std::function<void(const std::string &name, const std::string &content)>;
} // namespace dpcontact

#endif
