#include "database/rows/comparison.h"

#include "database/files/csv.h"
#include "database/files/files.h"
#include "database/rows/schema.h"
#include "meshing/errors.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace dpcontact
{
  bool RowComparison::agrees(double Difference::*const stated) const
  {
    return std::all_of(std::begin(difference), std::end(difference), [stated](const Difference &d) {
      return std::abs(d.value - d.other) <= d.*stated;
    });
  }

  std::vector<RowComparison> compare(const Database &one, const Database &other)
  {
    std::map<CaseKey, const Record *> partners;
    for (const Record &row : other.records)
      partners.emplace(key_of(row.input), &row);
    std::vector<RowComparison> result;
    for (const Record &row : one.records)
      {
        const auto found = partners.find(key_of(row.input));
        if (found == partners.end())
          throw InputError("compare: the row of " + label(row.input) +
                           " is not in the other database");
        const Record &partner = *found->second;
        if (!row.converged() || !partner.converged())
          throw InputError("compare: the row of " + label(row.input) +
                           " has failed in one of the databases");
        RowComparison pair{&row, &partner, {}};
        for (std::size_t c = 0; c < coefficient_names.size(); ++c)
          {
            // Where both are closed forms rounding is all that may differ.
            const double value    = row.law[c];
            const double rounding = 1e-12 * std::abs(value);
            pair.difference[c]    = {value,
                                     partner.law[c],
                                     row.error[c].parts.numerical() +
                                       partner.error[c].parts.numerical() + rounding,
                                     row.error[c].total + partner.error[c].total + rounding};
          }
        result.push_back(pair);
      }
    return result;
  }

  void write_csv(const std::filesystem::path &file, const std::vector<RowComparison> &rows)
  {
    CsvWriter csv;
    csv.comment("Coefficients of one database beside those of another (_other), their difference "
                "(other\n"
                "over one, minus 1), and the sums of the errors that both state, over the "
                "coefficient: the\n"
                "numerical parts (mesh, load step, contact, far field), and the total.");
    std::vector<std::string> names;
    for (const schema::Column &column : schema::input_columns())
      names.push_back(column.name);
    names.emplace_back("load_level");
    for (const std::string name : coefficient_names)
      for (const char *const suffix : {"",
                                       "_other",
                                       "_relative_difference",
                                       "_relative_numerical_error",
                                       "_relative_total_error"})
        names.push_back(name + suffix);
    names.insert(names.end(), {"agrees_numerical", "agrees"});
    csv.header(names);

    using Difference = RowComparison::Difference;
    for (const RowComparison &pair : rows)
      {
        for (const auto &[name, cell] : schema::input_cells(pair.row->input))
          std::visit([&csv](const auto &value) { csv.add(value); }, cell);
        csv.add(pair.row->load_level);
        for (const Difference &d : pair.difference)
          for (const double number : {d.value,
                                      d.other,
                                      d.other / d.value - 1,
                                      d.numerical / std::abs(d.value),
                                      d.total / std::abs(d.value)})
            csv.add(number);
        csv.row(std::string(pair.agrees(&Difference::numerical) ? "yes" : "no"),
                std::string(pair.agrees(&Difference::total) ? "yes" : "no"));
      }
    write_file(file, csv.text());
  }
} // namespace dpcontact
