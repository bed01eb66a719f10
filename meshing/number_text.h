#ifndef DPCONTACT_MESHING_NUMBER_TEXT_H
#define DPCONTACT_MESHING_NUMBER_TEXT_H

#include <charconv>
#include <cmath>
#include <string>

namespace dpcontact
{
  /// A number in the fewest digits that give the same double back, with a decimal point whatever
  /// the locale. NaN and the infinities are `nan`, `inf` and `-inf`.
  inline std::string number_text(const double value)
  {
    if (std::isnan(value))
      return "nan"; // without the sign that some systems print
    char       digits[32];
    const auto end = std::to_chars(digits, digits + sizeof(digits), value).ptr;
    return {digits, end};
  }
} // namespace dpcontact

#endif
