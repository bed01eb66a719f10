#ifndef DPCONTACT_SOLVER_PROBLEM_QUANTITY_H
#define DPCONTACT_SOLVER_PROBLEM_QUANTITY_H

#include "solver/laws/parameter.h"

#include <string>
#include <vector>

namespace dpcontact
{
  /// Reads "10GPa", "15 MPa" or "1e7" (no suffix: Pa, m, N, degrees) and returns SI, angles in
  /// degrees.
  /// @param name the option or entry, for the message
  /// @throws InputError naming option and text, for garbage, another dimension's unit or a number
  /// that is not finite.
  double parse_quantity(const std::string &name, const std::string &text, Dimension dimension);

  /// How many values a list may have.
  constexpr std::size_t longest_list = 100000;

  /// Reads a list, "10GPa, 20GPa", "1e10, 2e10" or "(10, 20)GPa", as parse_quantity() its parts.
  /// @return the values in SI units, angles in degrees; at least one.
  /// @throws InputError as parse_quantity(), for a list of more than `longest_list` values, for a
  /// value that stands twice, and with both readings where some values have a unit and others have
  /// none, and of "35,5", which may be one number with a decimal comma ("35, 5" is not).
  std::vector<double>
  parse_quantities(const std::string &name, const std::string &text, Dimension dimension);

  /// Reads a non-negative integer.
  /// @throws InputError naming option and text.
  unsigned int parse_count(const std::string &name, const std::string &text);

  /// A quantity for a person to read: five significant digits and a fitting unit ("3.279 um").
  /// Angles are taken in degrees.
  std::string format_quantity(double value, Dimension dimension);

  /// The same with its uncertainty, "1.015 ± 0.005", "(3.28 ± 0.02) um": the uncertainty rounded up
  /// to two digits at most, the value to the last of them. Where the uncertainty is not known (NaN)
  /// the value alone.
  std::string format_uncertain(double value, double uncertainty, Dimension dimension);
} // namespace dpcontact

#endif
