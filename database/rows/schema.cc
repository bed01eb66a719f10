#include "database/rows/column_builder.h"
#include "meshing/errors.h"

namespace dpcontact::schema
{
  namespace
  {
    Column criterion_column()
    {
      Column result{"criterion",
                    "",
                    "yield criterion: " + one_of(enum_names<Criterion>()),
                    [](const Record &row) -> Cell {
                      return std::string(to_string(row.input.material.criterion));
                    },
                    [](Record &row, const Cell &cell) {
                      row.input.material.criterion =
                        parse_enum<Criterion>(std::get<std::string>(cell));
                    }};
      result.choices = enum_names<Criterion>();
      return result;
    }

    Column input_column(const CaseParameter &parameter)
    {
      Column result{parameter.column(),
                    unit_of(parameter.dimension),
                    parameter.description,
                    [&parameter](const Record &row) -> Cell { return parameter.get(row.input); },
                    [&parameter](Record &row, const Cell &cell) {
                      parameter.set(row.input, std::get<double>(cell));
                    }};
      result.range = parameter.range;
      // where nothing stands for "none"
      if (parameter.may_be_left_out() && !parameter.default_value)
        result.absence = Absence::allowed;
      return result;
    }

    /// What every criterion has comes first, what single ones have last.
    Columns inputs(const bool of_single_criteria)
    {
      Columns list;
      if (of_single_criteria)
        list.push_back(criterion_column());
      for (const CaseParameter &parameter : stored_parameters())
        if (parameter.owners.empty() != of_single_criteria)
          list.push_back(input_column(parameter));
      return list;
    }

  } // namespace

  void enter(const Column &column, const Cell &cell, Record &row)
  {
    try
      {
        column.set(row, cell);
      }
    catch (const InputError &error)
      {
        throw CorruptData(error.what());
      }
  }

  void check_version(const std::string &file, const std::string &found)
  {
    if (found != std::to_string(version))
      throw SettingsMismatch(file + " has schema version " + found +
                             ", this program reads version " + std::to_string(version) +
                             ": compute it again with this program, or read it with the one that "
                             "wrote it (its provenance names the revision)");
  }

  const std::vector<Column> &columns()
  {
    // The first twenty are promised to readers of the CSV in this order; new columns go at the end.
    static const Columns list = [] {
      Columns all = inputs(false);
      append(all, first_yield_columns());
      append(all, law_columns());
      append(all, status_columns());
      append(all, state_columns());
      append(all, fit_columns());
      append(all, cost_columns());
      append(all, error_columns());
      append(all, inputs(true));
      return all;
    }();
    return list;
  }

  const std::vector<Column> &input_columns()
  {
    static const Columns list = [] {
      Columns all = {criterion_column()};
      for (const CaseParameter &parameter : stored_parameters())
        all.push_back(input_column(parameter));
      return all;
    }();
    return list;
  }

  std::vector<std::pair<std::string, Cell>> input_cells(const Case &input)
  {
    Record row;
    row.input = input;
    std::vector<std::pair<std::string, Cell>> cells;
    for (const Column &entry : input_columns())
      cells.emplace_back(entry.name, entry.get(row));
    return cells;
  }

  const std::vector<ProfileColumn> &profile_columns()
  {
    static const std::vector<ProfileColumn> list = {
      {"radius", "m", "distance from the axis", &PressurePoint::radius},
      {"pressure",
       "Pa",
       "contact pressure at the peak force, compression positive",
       &PressurePoint::pressure},
    };
    return list;
  }
} // namespace dpcontact::schema
