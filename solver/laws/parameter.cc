#include "solver/laws/parameter.h"

#include "meshing/errors.h"

#include <cmath>
#include <sstream>

namespace dpcontact
{
  namespace
  {
    /// How a message writes the unit behind a number.
    std::string unit_in_message(const Dimension dimension)
    {
      if (dimension == Dimension::number)
        return "";
      return dimension == Dimension::angle ? " degrees" : std::string(" ") + unit_of(dimension);
    }

    std::string plain(const double value)
    {
      std::ostringstream text;
      text.precision(12);
      text << value;
      return text.str();
    }
  } // namespace

  const char *unit_of(const Dimension dimension)
  {
    switch (dimension)
      {
        case Dimension::pressure:
          return "Pa";
        case Dimension::length:
          return "m";
        case Dimension::force:
          return "N";
        case Dimension::density:
          return "kg/m3";
        case Dimension::velocity:
          return "m/s";
        case Dimension::angle:
          return "deg";
        case Dimension::number:
          break;
      }
    return "1";
  }

  bool Range::contains(const double value) const
  {
    // Finiteness is asked first: an ordered comparison with NaN raises a floating-point exception.
    return std::isfinite(value) && value >= low && value <= high && !(open_low && value == low) &&
           !(open_high && value == high);
  }

  std::string Range::text(const Dimension dimension) const
  {
    const bool  bounded = std::isfinite(high);
    std::string text    = bounded ? "" : "finite and ";
    text += (open_low ? "greater than " : "at least ") + plain(low);
    if (bounded)
      text += std::string(" and ") + (open_high ? "less than " : "at most ") + plain(high);
    // a zero needs no unit
    return text + (bounded ? unit_in_message(dimension) : "");
  }

  std::string option_name(const std::string &name)
  {
    std::string option = name;
    for (char &c : option)
      if (c == '_')
        c = '-';
    return option;
  }

  std::string key_name(const std::string &name, const Dimension dimension)
  {
    return dimension == Dimension::angle ? name + "_deg" : name;
  }

  std::string column_name(const std::string &name, const Dimension dimension)
  {
    return dimension == Dimension::number ? name : name + "_" + unit_of(dimension);
  }

  void check_range(const std::string &title,
                   const double       value,
                   const Dimension    dimension,
                   const Range       &range)
  {
    if (!range.contains(value))
      refuse_value(title, value, dimension, range.text(dimension));
  }

  void refuse_value(const std::string &title,
                    const double       value,
                    const Dimension    dimension,
                    const std::string &range)
  {
    throw InputError(title + " is " + plain(value) + unit_in_message(dimension) + "; it must be " +
                     range + ".");
  }
} // namespace dpcontact
