#include "runs/comparison.h"

#include "database/files.h"
#include "meshing/errors.h"
#include "runs/documents.h"
#include "runs/row.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>

namespace dpcontact
{
  namespace
  {
    constexpr double Record::*values[] = {&Record::a, &Record::b, &Record::m, &Record::n};
    constexpr const char     *names[]  = {"a", "b", "m", "n"};

    /// mesh, step, contact, far_field of error_columns()
    double numerical_error(const Record &row, const std::size_t coefficient)
    {
      const auto columns = error_columns()[coefficient];
      return row.*columns[0] + row.*columns[1] + row.*columns[2] + row.*columns[3];
    }
  } // namespace

  bool RowComparison::agrees(double Difference::*const stated) const
  {
    return std::all_of(std::begin(difference), std::end(difference), [stated](const Difference &d) {
      return std::abs(d.value - d.other) <= d.*stated;
    });
  }

  std::vector<RowComparison> compare(const Database &one, const Database &other)
  {
    std::map<RowInputs::Key, const Record *> partners;
    for (const Record &row : other.records)
      partners.emplace(row.key(), &row);
    std::vector<RowComparison> result;
    for (const Record &row : one.records)
      {
        const auto partner = partners.find(row.key());
        if (partner == partners.end() || row.status != "converged" ||
            partner->second->status != "converged")
          throw InputError("compare: the row of " + label(case_of(row)) +
                           (partner == partners.end() ? " is not in the other database"
                                                      : " has failed in one of the databases"));
        RowComparison pair{&row, partner->second, {}};
        for (std::size_t c = 0; c < 4; ++c)
          {
            // Where both are closed forms rounding is all that may differ.
            const double value    = row.*values[c];
            const double rounding = 1e-12 * std::abs(value);
            const auto   total    = error_columns()[c][6];
            pair.difference[c]    = {value,
                                     partner->second->*values[c],
                                     numerical_error(row, c) + numerical_error(*partner->second, c) +
                                       rounding,
                                     row.*total + partner->second->*total + rounding};
          }
        result.push_back(pair);
      }
    return result;
  }

  void write_csv(const std::filesystem::path &file, const std::vector<RowComparison> &rows)
  {
    std::ostringstream text;
    text << std::setprecision(10)
         << "# Coefficients of one database beside those of another (_other), their difference "
            "(other\n"
            "# over one, minus 1), and the sums of the errors that both state, over the "
            "coefficient: the\n"
            "# numerical parts (mesh, load step, contact, far field), and the total.\n"
            "E_Pa,nu,phi_deg,sigma_c_Pa,radius_m,force_max_N,load_level";
    for (const char *name : names)
      text << ',' << name << ',' << name << "_other," << name << "_relative_difference," << name
           << "_relative_numerical_error," << name << "_relative_total_error";
    text << ",agrees_numerical,agrees\n";
    for (const RowComparison &pair : rows)
      {
        const Record &row = *pair.row;
        text << row.E_Pa << ',' << row.nu << ',' << row.phi_deg << ',' << row.sigma_c_Pa << ','
             << row.radius_m << ',' << row.force_max_N << ',' << row.load_level;
        for (const auto &d : pair.difference)
          text << ',' << d.value << ',' << d.other << ',' << d.other / d.value - 1 << ','
               << d.numerical / std::abs(d.value) << ',' << d.total / std::abs(d.value);
        const auto word = [&](double RowComparison::Difference::*stated) {
          return pair.agrees(stated) ? "yes" : "no";
        };
        text << ',' << word(&RowComparison::Difference::numerical) << ','
             << word(&RowComparison::Difference::total) << '\n';
      }
    write_file(file, text.str());
  }
} // namespace dpcontact
