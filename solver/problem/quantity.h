#ifndef DPCONTACT_SOLVER_PROBLEM_QUANTITY_H
#define DPCONTACT_SOLVER_PROBLEM_QUANTITY_H

#include "solver/laws/parameter.h"

#include <string>

namespace dpcontact
{
  /// Reads "10GPa", "15 MPa" or "1e7" (no suffix: Pa, m, N, degrees) and returns SI, angles in
  /// degrees.
  /// @param name the option or entry, for the message
  /// @throws InputError naming option and text, for garbage, another dimension's unit or a number
  /// that is not finite.
  double parse_quantity(const std::string &name, const std::string &text, Dimension dimension);

  /// Reads a non-negative integer.
  /// @throws InputError naming option and text.
  unsigned int parse_count(const std::string &name, const std::string &text);

  /// A quantity for a person to read: five significant digits and a fitting unit ("3.279 um").
  /// Angles are taken in degrees.
  std::string format_quantity(double value, Dimension dimension);
} // namespace dpcontact

#endif
