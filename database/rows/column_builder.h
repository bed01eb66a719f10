#ifndef DPCONTACT_DATABASE_ROWS_COLUMN_BUILDER_H
#define DPCONTACT_DATABASE_ROWS_COLUMN_BUILDER_H

#include "database/rows/schema.h"

#include <utility>

namespace dpcontact::schema
{
  // What the lists of columns are written with.

  inline constexpr double infinity = std::numeric_limits<double>::infinity();

  inline constexpr Range not_negative{0, infinity};
  inline constexpr Range positive{0, infinity, true, false};
  inline constexpr Range any{-infinity, infinity};
  inline constexpr Range at_most_one{-infinity, 1}; ///< of R²

  /// A column of what `place` gives a reference to, of a constant record and of another.
  template <class Place>
  Column column(const std::string &name,
                const std::string &unit,
                const std::string &description,
                const Place       &place)
  {
    using Value = std::decay_t<decltype(place(std::declval<Record &>()))>;
    Column result{name,
                  unit,
                  description,
                  [place](const Record &row) -> Cell { return place(row); },
                  [place](Record &row, const Cell &cell) { place(row) = std::get<Value>(cell); }};
    result.range = not_negative;
    return result;
  }

  template <class Place>
  Column column(const std::string &name,
                const std::string &unit,
                const std::string &description,
                const Place       &place,
                const Range       &range,
                const Absence      absence = Absence::noted)
  {
    Column result  = column(name, unit, description, place);
    result.range   = range;
    result.absence = absence;
    return result;
  }

  using Columns = std::vector<Column>;

  inline void append(Columns &list, const Columns &more)
  {
    list.insert(list.end(), more.begin(), more.end());
  }

  // The groups of columns, each beside what it describes.
  Columns first_yield_columns();
  Columns law_columns();
  Columns status_columns();
  Columns state_columns();
  Columns cost_columns();
  Columns error_columns();
  Columns fit_columns(); ///< how a, b, m, n were fitted, and the forms beside the power law
} // namespace dpcontact::schema

#endif
