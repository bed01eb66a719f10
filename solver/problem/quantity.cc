#include "solver/problem/quantity.h"

#include "meshing/errors.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

namespace dpcontact
{
  namespace
  {
    /// SI value = number × multiplier / divisor; one of the two is 1, so that "100mm" is 0.1
    /// exactly.
    struct Unit
    {
      const char *symbol;
      double      multiplier;
      double      divisor;
    };

    struct UnitSystem
    {
      const char       *name;
      std::vector<Unit> units;   ///< the first `printed` from small to large, then other spellings
      std::size_t       printed; ///< how many are used for printing
    };

    const UnitSystem &unit_system(const Dimension dimension)
    {
      static const UnitSystem pressure{
        "pressure", {{"Pa", 1, 1}, {"kPa", 1e3, 1}, {"MPa", 1e6, 1}, {"GPa", 1e9, 1}}, 4};
      static const UnitSystem length{"length",
                                     {{"nm", 1, 1e9},
                                      {"um", 1, 1e6},
                                      {"mm", 1, 1e3},
                                      {"m", 1, 1},
                                      {"km", 1e3, 1},
                                      {"cm", 1, 1e2},
                                      {"\u00b5m", 1, 1e6},  // micro sign
                                      {"\u03bcm", 1, 1e6}}, // Greek mu
                                     5};
      static const UnitSystem force{
        "force", {{"mN", 1, 1e3}, {"N", 1, 1}, {"kN", 1e3, 1}, {"MN", 1e6, 1}}, 4};
      static const UnitSystem angle{"angle", {{"deg", 1, 1}, {"\u00b0", 1, 1}}, 0};
      static const UnitSystem number{"number", {}, 0};
      switch (dimension)
        {
          case Dimension::pressure:
            return pressure;
          case Dimension::length:
            return length;
          case Dimension::force:
            return force;
          case Dimension::angle:
            return angle;
          case Dimension::number:
            break;
        }
      return number;
    }

    std::string trimmed(const std::string &text)
    {
      const char *const blanks = " \t\r\n";
      const auto        first  = text.find_first_not_of(blanks);
      if (first == std::string::npos)
        return {};
      return text.substr(first, text.find_last_not_of(blanks) - first + 1);
    }

    /// What would have been right: "a pressure in Pa, kPa, MPa or GPa".
    std::string expected(const UnitSystem &system)
    {
      std::string result =
        std::string(system.name == std::string("angle") ? "an " : "a ") + system.name;
      if (system.units.empty())
        return result + " without unit";
      for (std::size_t i = 0; i < system.units.size(); ++i)
        result += (i == 0                         ? " in "
                   : i + 1 == system.units.size() ? " or "
                                                  : ", ") +
                  std::string(system.units[i].symbol);
      return result;
    }

    /// Splits a leading floating-point number off `text`, independent of the locale.
    bool split_number(const std::string &text, double &value, std::string &rest)
    {
      const char *const begin  = text.data() + (!text.empty() && text.front() == '+' ? 1 : 0);
      const char *const end    = text.data() + text.size();
      const auto        result = std::from_chars(begin, end, value);
      if (result.ec == std::errc::invalid_argument)
        return false;
      if (result.ec == std::errc::result_out_of_range)
        value = std::numeric_limits<double>::infinity();
      rest = trimmed(std::string(result.ptr, end));
      return true;
    }
  } // namespace

  double parse_quantity(const std::string &name, const std::string &text, const Dimension dimension)
  {
    const UnitSystem &system = unit_system(dimension);
    const std::string prefix = name + ": '" + text + "' is not " + expected(system);

    double      value = std::numeric_limits<double>::quiet_NaN();
    std::string suffix;
    if (!split_number(trimmed(text), value, suffix))
      throw InputError(prefix);
    if (!std::isfinite(value))
      throw InputError(name + ": '" + text + "' is not a finite number");
    if (suffix.empty())
      return value;
    for (const Unit &unit : system.units)
      if (suffix == unit.symbol)
        {
          const double si = value * unit.multiplier / unit.divisor;
          if (!std::isfinite(si))
            throw InputError(name + ": '" + text + "' is not a finite number");
          return si;
        }
    throw InputError(prefix);
  }

  unsigned int parse_count(const std::string &name, const std::string &text)
  {
    const std::string word   = trimmed(text);
    unsigned int      value  = 0;
    const auto        result = std::from_chars(word.data(), word.data() + word.size(), value);
    if (result.ec != std::errc() || result.ptr != word.data() + word.size())
      throw InputError(name + ": '" + text + "' is not a non-negative integer");
    return value;
  }

  std::string format_quantity(const double value, const Dimension dimension)
  {
    const UnitSystem &system    = unit_system(dimension);
    double            magnitude = value;
    std::string       symbol;
    if (dimension == Dimension::angle)
      symbol = "\u00b0";
    else if (system.printed > 0)
      {
        // The largest unit that leaves at least one; the SI unit itself for zero and NaN.
        const auto size = [](const Unit &unit) { return unit.multiplier / unit.divisor; };
        Unit       best = system.units.front();
        for (std::size_t i = 0; i < system.printed; ++i)
          if (const Unit &unit = system.units[i]; std::abs(value) >= size(unit) * (1 - 1e-12) ||
                                                  (!(std::abs(value) > 0) && size(unit) == 1))
            best = unit;
        magnitude = value * best.divisor / best.multiplier;
        symbol    = std::string(" ") + best.symbol;
      }
    char buffer[32];
    std::snprintf(buffer, sizeof(buffer), "%.5g", magnitude);
    return buffer + symbol;
  }
} // namespace dpcontact
