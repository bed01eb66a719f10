#include "database/files/json_text.h"

#include "meshing/errors.h"

#include <nlohmann/json.hpp>

#include <set>

namespace dpcontact
{
  namespace
  {
    /// Of text that is JSON the levels of arrays and objects; brackets in strings do not count.
    bool is_nested_too_deep(const std::string &text)
    {
      std::size_t level     = 0;
      bool        in_string = false;
      for (std::size_t i = 0; i < text.size(); ++i)
        {
          const char c = text[i];
          if (in_string)
            {
              if (c == '\\')
                ++i;
              else
                in_string = c != '"';
            }
          else if (c == '"')
            in_string = true;
          else if ((c == '[' || c == '{') && ++level > deepest_json)
            return true;
          else if ((c == ']' || c == '}') && level > 0)
            --level;
        }
      return false;
    }
  } // namespace

  template <typename Json>
  Json parse_json(const std::string &text, const std::string &source)
  {
    if (is_nested_too_deep(text))
      throw CorruptData(source + " is nested deeper than " + std::to_string(deepest_json) +
                        " levels, which this program never writes");
    Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded())
      throw CorruptData(source + " is not JSON");
    return json;
  }

  template <typename Json>
  std::vector<JsonDifference> differences(const Json &left, const Json &right)
  {
    const Json            left_entries = left.flatten(), right_entries = right.flatten();
    std::set<std::string> names;
    for (const Json *const entries : {&left_entries, &right_entries})
      for (const auto &entry : entries->items())
        names.insert(entry.key());
    const auto value = [](const Json &entries, const std::string &name) {
      const auto found = entries.find(name);
      return found == entries.end() ? std::string("(absent)") : found->dump();
    };
    std::vector<JsonDifference> found;
    for (const std::string &name : names)
      if (const JsonDifference entry{name.substr(name.empty() ? 0 : 1),
                                     value(left_entries, name),
                                     value(right_entries, name)};
          entry.left != entry.right)
        found.push_back(entry);
    return found;
  }

  template nlohmann::json              parse_json(const std::string &, const std::string &);
  template nlohmann::ordered_json      parse_json(const std::string &, const std::string &);
  template std::vector<JsonDifference> differences(const nlohmann::json &, const nlohmann::json &);
  template std::vector<JsonDifference> differences(const nlohmann::ordered_json &,
                                                   const nlohmann::ordered_json &);
} // namespace dpcontact
