#include "solver/problem/quantity.h"

#include "meshing/errors.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <set>
#include <sstream>

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
      static const UnitSystem density{
        "density", {{"kg/m3", 1, 1}, {"kg/m^3", 1, 1}, {"g/cm3", 1e3, 1}, {"t/m3", 1e3, 1}}, 1};
      static const UnitSystem velocity{
        "velocity", {{"mm/s", 1, 1e3}, {"m/s", 1, 1}, {"cm/s", 1, 1e2}, {"km/s", 1e3, 1}}, 2};
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
          case Dimension::density:
            return density;
          case Dimension::velocity:
            return velocity;
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

    /// A value in SI units and how its unit was written; empty: not at all.
    struct Part
    {
      double      value;
      std::string unit;
    };

    Part read_part(const std::string &name, const std::string &text, const Dimension dimension)
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
        return {value, suffix};
      for (const Unit &unit : system.units)
        if (suffix == unit.symbol)
          {
            const double si = value * unit.multiplier / unit.divisor;
            if (!std::isfinite(si))
              throw InputError(name + ": '" + text + "' is not a finite number");
            return {si, suffix};
          }
      throw InputError(prefix);
    }

    /// The parts of a list, which commas separate; at least one, and empty where nothing stands.
    std::vector<std::string> split_list(const std::string &text)
    {
      const auto commas = static_cast<std::size_t>(std::count(text.begin(), text.end(), ','));
      if (commas >= longest_list)
        throw InputError("a list has " + std::to_string(commas + 1) +
                         " values; it may have at most " + std::to_string(longest_list));
      std::vector<std::string> parts;
      std::istringstream       stream(text);
      for (std::string part; std::getline(stream, part, ',');)
        parts.push_back(part);
      if (text.empty() || text.back() == ',')
        parts.emplace_back();
      return parts;
    }

    std::string shortened(const std::string &text)
    {
      return text.size() > 200 ? text.substr(0, 200) + "…" : text;
    }

    /// "10 Pa, 20 Pa, 30 GPa"
    std::string reading(const std::vector<double> &values, const Dimension dimension)
    {
      constexpr std::size_t most = 5;
      std::string           text;
      for (std::size_t i = 0; i < std::min(most, values.size()); ++i)
        text += (i > 0 ? ", " : "") + format_quantity(values[i], dimension);
      return values.size() > most ? text + ", …" : text;
    }

    /// With what the text says and with what may have been meant: the last unit for all.
    [[noreturn]] void refuse_mixed_units(const std::string       &name,
                                         const std::string       &text,
                                         const std::vector<Part> &parts,
                                         const Dimension          dimension)
    {
      const auto with_unit =
        std::find_if(parts.rbegin(), parts.rend(), [](const Part &p) { return !p.unit.empty(); });
      const double        unit = read_part(name, "1" + with_unit->unit, dimension).value;
      std::vector<double> as_written, as_meant;
      for (const Part &part : parts)
        {
          as_written.push_back(part.value);
          as_meant.push_back(part.unit.empty() ? part.value * unit : part.value);
        }
      throw InputError(name + ": '" + shortened(text) +
                       "' gives some values a unit and others none, which may mean " +
                       reading(as_written, dimension) + " or " + reading(as_meant, dimension) +
                       ": give each its unit, or one behind a bracket, as in (1, 2)" +
                       with_unit->unit + "; decimals have a point");
    }

    /// How a value is printed: times the factor, with the unit behind it.
    struct Printed
    {
      double      factor = 1;
      std::string symbol = {}; ///< with the blank before it, where one stands
    };

    Printed printed_in_unit(const double value, const Dimension dimension)
    {
      const UnitSystem &system = unit_system(dimension);
      if (dimension == Dimension::angle)
        return {1, "\u00b0"};
      if (system.printed == 0)
        return {};
      // The largest unit that leaves at least one; the SI unit itself for zero and NaN.
      const auto size = [](const Unit &unit) { return unit.multiplier / unit.divisor; };
      Unit       best = system.units.front();
      for (std::size_t i = 0; i < system.printed; ++i)
        if (const Unit &unit = system.units[i]; std::abs(value) >= size(unit) * (1 - 1e-12) ||
                                                (!(std::abs(value) > 0) && size(unit) == 1))
          best = unit;
      return {best.divisor / best.multiplier, std::string(" ") + best.symbol};
    }

    /// Two integers without unit or blank, of which the second is the smaller or the first is 0.
    bool looks_like_decimal_comma(const std::string &text)
    {
      const auto comma = text.find(',');
      if (comma == std::string::npos || text.size() > 40)
        return false;
      const std::string whole = text.substr(0, comma), fraction = text.substr(comma + 1);
      const auto        is_integer = [](const std::string &digits) {
        return !digits.empty() && digits.find_first_not_of("0123456789") == std::string::npos;
      };
      return is_integer(whole) && is_integer(fraction) &&
             (std::stod(fraction) < std::stod(whole) || !(std::stod(whole) > 0));
    }
  } // namespace

  double parse_quantity(const std::string &name, const std::string &text, const Dimension dimension)
  {
    return read_part(name, text, dimension).value;
  }

  std::vector<double>
  parse_quantities(const std::string &name, const std::string &text, const Dimension dimension)
  {
    std::string unit; // behind the bracket
    std::string list = trimmed(text);
    if (looks_like_decimal_comma(list))
      throw InputError(name + ": '" + list +
                       "' may be a list of two or one number with a decimal " + "comma: write '" +
                       list.substr(0, list.find(',')) + ", " + list.substr(list.find(',') + 1) +
                       "' with a blank, or '" + list.substr(0, list.find(',')) + "." +
                       list.substr(list.find(',') + 1) + "'");
    if (!list.empty() && (list.front() == '(' || list.front() == '['))
      {
        const auto close = list.find(list.front() == '(' ? ')' : ']');
        if (close == std::string::npos)
          throw InputError(name + ": '" + shortened(text) +
                           "' opens a bracket and never closes it");
        unit = trimmed(list.substr(close + 1));
        list = list.substr(1, close - 1);
      }

    std::vector<Part> parts;
    std::set<double>  known;
    for (const std::string &part : split_list(list))
      {
        parts.push_back(read_part(name, part, dimension));
        if (!unit.empty() && !parts.back().unit.empty())
          throw InputError(name + ": '" + shortened(text) +
                           "' gives a unit inside and behind the "
                           "bracket: leave out one of them");
        if (!unit.empty())
          parts.back() = read_part(name, part + unit, dimension);
        if (!known.insert(parts.back().value).second)
          throw InputError(name + ": '" + part + "' stands twice in the list '" + shortened(text) +
                           "'");
      }
    const auto has_unit = [](const Part &part) { return !part.unit.empty(); };
    if (std::any_of(parts.begin(), parts.end(), has_unit) &&
        !std::all_of(parts.begin(), parts.end(), has_unit))
      refuse_mixed_units(name, text, parts, dimension);

    std::vector<double> values;
    for (const Part &part : parts)
      values.push_back(part.value);
    return values;
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
    const Printed printed = printed_in_unit(value, dimension);
    char          buffer[32];
    std::snprintf(buffer, sizeof(buffer), "%.5g", value * printed.factor);
    return buffer + printed.symbol;
  }

  std::string
  format_uncertain(const double value, const double uncertainty, const Dimension dimension)
  {
    if (!std::isfinite(value) || !std::isfinite(uncertainty))
      return format_quantity(value, dimension);
    // A value far below its uncertainty is printed in the unit of that.
    const Printed printed   = printed_in_unit(std::max(std::abs(value), uncertainty), dimension);
    const double  magnitude = value * printed.factor, spread = uncertainty * printed.factor;
    char          buffer[96];
    const auto    with_unit = [&] {
      return printed.symbol.empty() ? buffer : "(" + std::string(buffer) + ")" + printed.symbol;
    };
    if (!(spread > 0))
      {
        std::snprintf(buffer, sizeof(buffer), "%.5g \u00b1 0", magnitude);
        return with_unit();
      }
    // As many decimals as leave the uncertainty one digit, or two where that would be a 1.
    const double leading = std::floor(std::log10(spread));
    const int    decimals =
      std::clamp(static_cast<int>(-leading) + (spread < 2 * std::pow(10, leading) ? 1 : 0), 0, 12);
    const double unit    = std::pow(10, -decimals);
    const double rounded = std::ceil(spread / unit * (1 - 1e-12)) * unit; // never too small
    std::snprintf(
      buffer, sizeof(buffer), "%.*f \u00b1 %.*f", decimals, magnitude, decimals, rounded);
    return with_unit();
  }
} // namespace dpcontact
