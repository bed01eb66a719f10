#ifndef DPCONTACT_DATABASE_ROWS_ROW_JSON_H
#define DPCONTACT_DATABASE_ROWS_ROW_JSON_H

#include "database/rows/record.h"

#include <nlohmann/json_fwd.hpp>

namespace dpcontact
{
  /// A row as JSON: its columns by name, then `curve {loading, unloading}` and `peak_profile` as
  /// objects of arrays. Numbers come back as the same doubles; NaN, Inf and -Inf are the strings
  /// "nan", "inf" and "-inf"; text is made valid UTF-8 (see clean_text()).
  nlohmann::json to_json(const Record &record);

  /// @throws CorruptData naming the entry that is missing or has the wrong type.
  Record record_from_json(const nlohmann::json &json);

  /// Text that every format can store: invalid UTF-8 and NUL become U+FFFD.
  std::string clean_text(const std::string &text);
} // namespace dpcontact

#endif
