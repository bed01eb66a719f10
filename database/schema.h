#ifndef DPCONTACT_DATABASE_SCHEMA_H
#define DPCONTACT_DATABASE_SCHEMA_H

#include "database/record.h"

#include <variant>
#include <vector>

namespace dpcontact::schema
{
  /// Raised whenever a column changes its name, unit or meaning, or the layout of a file changes.
  constexpr int version = 3;

  /// A column of the table. Numbers without dimension have the unit "1", text has the unit "".
  struct Column
  {
    using Member = std::variant<double Record::*, std::uint64_t Record::*, std::string Record::*>;

    const char *name;
    const char *unit;
    const char *description;
    Member      member;
  };

  /// A quantity of every point of a branch of the curve.
  struct CurveColumn
  {
    using Member = std::variant<double CurvePoint::*, int CurvePoint::*>;

    const char *name;
    const char *unit;
    const char *description;
    Member      member;
  };

  /// A quantity of every point of the pressure profile at the peak.
  struct ProfileColumn
  {
    const char *name;
    const char *unit;
    const char *description;
    double PressurePoint::*member;
  };

  /// The columns in their order; the only list of names and units, for CSV, HDF5 and JSON.
  const std::vector<Column>        &columns();
  const std::vector<CurveColumn>   &curve_columns();
  const std::vector<ProfileColumn> &profile_columns();
} // namespace dpcontact::schema

#endif
