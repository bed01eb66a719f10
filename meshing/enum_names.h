#ifndef DPCONTACT_MESHING_ENUM_NAMES_H
#define DPCONTACT_MESHING_ENUM_NAMES_H

#include "meshing/errors.h"

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace dpcontact
{
  /// A value of an enum and the name by which people ask for it.
  template <class Enum>
  using EnumName = std::pair<Enum, const char *>;

  /// The names of an enum's values, in the order in which they are listed for people. An enum gets
  /// its names by one specialisation beside its declaration:
  ///
  ///     template <> struct EnumNames<Colour>
  ///     {
  ///       static constexpr const char     *what     = "colour";
  ///       static constexpr EnumName<Colour> values[] = {{Colour::red, "red"}, …};
  ///     };
  template <class Enum>
  struct EnumNames;

  /// The name of a value.
  template <class Enum, std::size_t = sizeof(EnumNames<Enum>)>
  const char *to_string(const Enum value)
  {
    for (const auto &[candidate, name] : EnumNames<Enum>::values)
      if (candidate == value)
        return name;
    return "";
  }

  /// All names, in their order.
  template <class Enum>
  std::vector<std::string> enum_names()
  {
    std::vector<std::string> names;
    for (const auto &[value, name] : EnumNames<Enum>::values)
      names.emplace_back(name);
    return names;
  }

  /// "a, b or c"
  inline std::string one_of(const std::vector<std::string> &names)
  {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
      text += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + names[i];
    return text;
  }

  /// The value of a name.
  /// @throws InputError naming the enum, the text and what it must be, where it is none of the names.
  template <class Enum>
  Enum parse_enum(const std::string &text)
  {
    for (const auto &[value, name] : EnumNames<Enum>::values)
      if (text == name)
        return value;
    throw InputError(std::string(EnumNames<Enum>::what) + ": '" + text + "' is not one of " +
                     one_of(enum_names<Enum>()));
  }
} // namespace dpcontact

#endif
