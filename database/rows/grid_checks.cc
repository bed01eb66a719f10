#include "database/rows/row_checks.h"
#include "database/rows/schema.h"
#include "meshing/number_text.h"

#include <algorithm>
#include <map>

namespace dpcontact
{
  namespace
  {
    /// The values of an input, in the order in which rows first have them.
    struct Axis
    {
      std::string                        name;
      std::map<std::string, std::size_t> numbers; ///< of the values
      std::vector<std::size_t>           of_row, uses;
    };

    std::string text_of(const schema::Cell &cell)
    {
      return std::visit(
        [](const auto &value) {
          if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::string>)
            return value;
          else
            return number_text(static_cast<double>(value));
        },
        cell);
    }

    std::vector<Axis> axes_of(const std::vector<Record> &records)
    {
      std::vector<Axis> axes;
      for (const schema::Column &column : schema::input_columns())
        {
          Axis axis{column.name, {}, {}, {}};
          for (const Record &row : records)
            {
              const auto [place, is_new] =
                axis.numbers.emplace(text_of(column.get(row)), axis.numbers.size());
              axis.of_row.push_back(place->second);
              if (is_new)
                axis.uses.push_back(0);
              ++axis.uses[place->second];
            }
          // An input that goes with another, as ψ = φ does, is no axis of its own.
          const bool follows = std::any_of(axes.begin(), axes.end(), [&axis](const Axis &other) {
            return other.of_row == axis.of_row;
          });
          if (axis.uses.size() > 1 && !follows)
            axes.push_back(std::move(axis));
        }
      return axes;
    }

    std::string row_name(const std::size_t i) { return "row " + std::to_string(i + 1); }

    /// Warns of a value that one row has and all others have another.
    void check_alone(const std::vector<Axis> &axes, Findings &findings)
    {
      constexpr std::size_t many = 8;
      for (const Axis &axis : axes)
        if (axis.of_row.size() >= many && axis.uses.size() == 2)
          if (const auto once = std::find(axis.uses.begin(), axis.uses.end(), std::size_t(1));
              once != axis.uses.end())
            {
              const auto value = static_cast<std::size_t>(once - axis.uses.begin());
              const auto at    = std::find(axis.of_row.begin(), axis.of_row.end(), value);
              findings.add(Grade::warning,
                           row_name(static_cast<std::size_t>(at - axis.of_row.begin())),
                           "it alone has another " + axis.name + " than all other rows");
            }
    }
  } // namespace

  void check_grid(const std::vector<Record> &records, Findings &findings)
  {
    const std::vector<Axis> axes = axes_of(records);
    check_alone(axes, findings);
    const std::size_t rows  = records.size();
    std::size_t       nodes = 1;
    for (const Axis &axis : axes)
      nodes = std::min(nodes * axis.uses.size(), 4 * rows); // far from full is full enough
    if (nodes > rows && nodes <= rows + rows / 4)
      findings.add(Grade::warning,
                   "database",
                   std::to_string(nodes - rows) + " of the " + std::to_string(nodes) +
                     " rows of its grid are missing");
    if (nodes != rows)
      return;
    for (std::size_t i = 0; i < rows; ++i)
      {
        std::size_t place = 0;
        for (const Axis &axis : axes)
          place = place * axis.uses.size() + axis.of_row[i];
        if (place != i)
          {
            findings.add(
              Grade::warning, row_name(i), "the rows do not stand in the order of their grid");
            return;
          }
      }
  }
} // namespace dpcontact
