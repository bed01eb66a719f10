#ifndef DPCONTACT_FITTING_NUMBER_TEXT_H
#define DPCONTACT_FITTING_NUMBER_TEXT_H

#include <sstream>
#include <string>

namespace dpcontact
{
  /// A number for a message, with ten digits and an exponent where it needs one.
  inline std::string number_text(const double value)
  {
    std::ostringstream stream;
    stream.precision(10);
    stream << value;
    return stream.str();
  }
} // namespace dpcontact

#endif
