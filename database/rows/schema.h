#ifndef DPCONTACT_DATABASE_ROWS_SCHEMA_H
#define DPCONTACT_DATABASE_ROWS_SCHEMA_H

#include "database/rows/record.h"

#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace dpcontact::schema
{
  /// Raised whenever a column changes its name, unit or meaning, or the layout of a file changes.
  constexpr int version = 3;

  /// @throws SettingsMismatch unless the version that a file names is this program's, saying what to
  /// do.
  void check_version(const std::string &file, const std::string &found);

  /// A value of a row.
  using Cell = std::variant<double, std::uint64_t, std::string>;

  /// What it means that a number of a converged row is not there.
  enum class Absence
  {
    error,  ///< the row is wrong
    noted,  ///< worth a note
    allowed ///< nothing: not every row has one
  };

  /// A column of the table. It has its one entry here; files, checks and reports follow from it.
  struct Column
  {
    std::string name;
    std::string unit; ///< "1" of numbers without dimension, "" of text
    std::string description;

    std::function<Cell(const Record &)>         get;
    std::function<void(Record &, const Cell &)> set; ///< takes the alternative that get() gives

    Range                    range   = {}; ///< of a number, wherever it is known
    Absence                  absence = Absence::noted;
    std::vector<std::string> choices = {}; ///< of a text that is one of some words

    bool is_number() const { return std::holds_alternative<double>(get(Record())); }
    bool is_text() const { return std::holds_alternative<std::string>(get(Record())); }
  };

  /// Enters what a stored file holds in a column of a row.
  /// @throws CorruptData where that is no value that the column can have.
  void enter(const Column &column, const Cell &cell, Record &row);

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
  const std::vector<ProfileColumn> &profile_columns();

  /// The columns that say which case a row is of, in the order of its key: criterion, E_Pa, nu, …
  const std::vector<Column> &input_columns();

  /// Their names, and what they hold of a case: the leading columns of every report.
  std::vector<std::pair<std::string, Cell>> input_cells(const Case &input);
} // namespace dpcontact::schema

#endif
