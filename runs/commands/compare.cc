#include "database/rows/comparison.h"
#include "runs/commands/commands.h"
#include "runs/commands/options.h"
#include "runs/interface/documents.h"
#include "runs/interface/outputs.h"
#include "solver/problem/quantity.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>

namespace dpcontact::commands
{
  namespace
  {
    struct CompareOptions
    {
      std::string database, other, csv;
      bool        json = false;
    };

    ExitCode run(const CompareOptions &options)
    {
      check_files({{options.database, options.other}, {options.csv}});
      const Database one = read_store(options.database), other = read_store(options.other);
      const auto     rows = compare(one, other);
      if (!options.csv.empty())
        write_csv(std::filesystem::path(options.csv), rows);

      using Difference = RowComparison::Difference;
      const auto agree = [&](double Difference::*stated) {
        return std::count_if(rows.begin(), rows.end(), [stated](const RowComparison &row) {
          return row.agrees(stated);
        });
      };
      Json coefficients;
      for (std::size_t c = 0; c < 4; ++c)
        {
          double largest = 0, share = 0;
          for (const RowComparison &row : rows)
            {
              const auto &d = row.difference[c];
              largest       = std::max(largest, std::abs(d.other / d.value - 1));
              share         = std::max(share, std::abs(d.other - d.value) / d.total);
            }
          coefficients[coefficient_names[c]] = {{"largest_relative_difference", largest},
                                                {"largest_over_total_error", share}};
        }
      if (options.json)
        print_document({{"database", options.database},
                        {"other", options.other},
                        {"rows", rows.size()},
                        {"agree", agree(&Difference::total)},
                        {"agree_numerical", agree(&Difference::numerical)},
                        {"coefficients", coefficients}});
      else
        {
          std::cout << agree(&Difference::total) << " of " << rows.size()
                    << " rows agree within the sum of their stated errors, "
                    << agree(&Difference::numerical)
                    << " within the numerical parts alone (mesh, load step, contact, far field)\n";
          for (const char *name : coefficient_names)
            std::cout << "  " << name << ": differs by at most "
                      << format_quantity(
                           100 * coefficients[name]["largest_relative_difference"].get<double>(),
                           Dimension::number)
                      << " %, "
                      << format_quantity(coefficients[name]["largest_over_total_error"],
                                         Dimension::number)
                      << " of the stated error\n";
          if (!options.csv.empty())
            std::cout << options.csv << ": one line a row\n";
        }
      return ExitCode::success;
    }
  } // namespace

  void add_compare(CLI::App &command, Action &action)
  {
    const auto options = std::make_shared<CompareOptions>();
    command.add_option("DATABASE", options->database, "HDF5 file of a sweep")->required();
    command.add_option("OTHER", options->other, "HDF5 file of another, with the same rows")
      ->required();
    command.add_option("--csv", options->csv, "report to write, one line a row")->type_name("FILE");
    add_json_flag(command, options->json);
    command.callback([options, &action] { action = [options] { return run(*options); }; });
  }
} // namespace dpcontact::commands
