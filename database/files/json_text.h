#ifndef DPCONTACT_DATABASE_FILES_JSON_TEXT_H
#define DPCONTACT_DATABASE_FILES_JSON_TEXT_H

#include <string>
#include <vector>

namespace dpcontact
{
  /// How deep arrays and objects may be nested in JSON that the program reads. What it writes
  /// itself has fewer than ten levels; comparing, copying and printing take stack for every level.
  constexpr unsigned int deepest_json = 64;

  /// JSON from a file that may have been altered.
  /// @tparam Json nlohmann::json or nlohmann::ordered_json.
  /// @param source names the text in messages.
  /// @throws CorruptData where it is no JSON, or is nested deeper than `deepest_json`; the latter
  /// is found before anything is built.
  template <typename Json>
  Json parse_json(const std::string &text, const std::string &source);

  /// An entry in which two documents differ.
  struct JsonDifference
  {
    std::string name;        ///< with the names of what it is in: "options/resolution"
    std::string left, right; ///< the values as JSON; "(absent)"
  };

  /// In the order of their names. @tparam Json as above.
  template <typename Json>
  std::vector<JsonDifference> differences(const Json &left, const Json &right);
} // namespace dpcontact

#endif
