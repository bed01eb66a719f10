#ifndef DPCONTACT_RUNS_QUANTITY_H
#define DPCONTACT_RUNS_QUANTITY_H

#include <string>

namespace dpcontact
{
  /// What a number typed by a person measures.
  enum class Dimension
  {
    pressure, ///< Pa kPa MPa GPa
    length,   ///< nm um µm mm cm m km
    force,    ///< mN N kN MN
    angle,    ///< degrees (deg, °)
    number    ///< no unit
  };

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

  double radians(double degrees);
} // namespace dpcontact

#endif
