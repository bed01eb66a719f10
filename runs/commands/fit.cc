#include "database/rows/row.h"
#include "database/rows/row_store.h"
#include "database/rows/store.h"
#include "fitting/curve_fit.h"
#include "runs/commands/commands.h"
#include "runs/commands/options.h"
#include "runs/interface/documents.h"
#include "runs/interface/outputs.h"
#include "solver/problem/quantity.h"

#include <cmath>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>

namespace dpcontact::commands
{
  namespace
  {
    struct FitOptions
    {
      std::string database;
      bool        write = false;
      bool        json  = false;
    };

    /// Relative changes of a, b, m, n.
    using Changes = Coefficients;

    Changes changes_between(const Record &stored, const Record &refitted)
    {
      Changes changes;
      for (std::size_t i = 0; i < coefficient_names.size(); ++i)
        {
          const double before = stored.law[i], after = refitted.law[i];
          changes[i] = std::isnan(before) ? std::numeric_limits<double>::infinity()
                                          : std::abs(after - before) / std::abs(before);
        }
      return changes;
    }

    /// The rows beside a database, kept from other processes. @throws FileError.
    struct RowsBeside
    {
      RowStore       rows;
      RowStore::Lock lock = rows.lock();
    };

    /// Nothing where no rows are beside it.
    std::optional<RowsBeside> rows_beside(const std::filesystem::path &file)
    {
      const auto settings = RowStore::stored_settings(file);
      if (!settings)
        return std::nullopt;
      return RowsBeside{RowStore(file, nlohmann::json::parse(*settings))};
    }

    /// @throws SettingsMismatch where the rows beside a database are not its own.
    void check_settings(const std::filesystem::path &file, const Database &database)
    {
      const auto beside = RowStore::stored_settings(file);
      const auto own    = database.provenance.find("solver_settings");
      if (beside &&
          (own == database.provenance.end() ||
           nlohmann::json::parse(own->second, nullptr, false) != nlohmann::json::parse(*beside)))
        throw SettingsMismatch(
          file.string() + " and the rows in " + RowStore::directory_of(file).string() +
          " were made with different settings:\n  file " +
          (own == database.provenance.end() ? "(absent)" : own->second) + "\n  rows " + *beside);
    }

    /// Rows first: a database that was not written any more is assembled from them by a sweep.
    void write_back(const std::filesystem::path     &file,
                    const Database                  &database,
                    const std::optional<RowsBeside> &beside)
    {
      if (beside)
        for (const Record &row : database.records)
          beside->rows.write(row);
      write_store(file, database);
    }

    ExitCode run(const FitOptions &options)
    {
      check_files({{options.database}, {}});
      const auto beside   = options.write ? rows_beside(options.database) : std::nullopt;
      Database   database = read_store(options.database);
      if (options.write)
        check_settings(options.database, database);
      Changes largest{0, 0, 0, 0};
      Json    rows       = Json::array();
      bool    all_fitted = true;
      for (Record &row : database.records)
        {
          const Case            &input = row.input;
          std::optional<Changes> changes;
          if (!row.curve.loading.empty())
            {
              const Record stored = row;
              fit_row(row);
              changes = changes_between(stored, row);
              for (std::size_t i = 0; i < coefficient_names.size(); ++i)
                largest[i] = std::max(largest[i], (*changes)[i]);
            }
          all_fitted = all_fitted && row.converged();
          if (options.json)
            rows.push_back({{"material", material_json(input)},
                            {"scene", scene_json(input)},
                            {"fit", fit_json(row)},
                            {"published_convention", published_json(row.fit.published)},
                            {"residual_approach", row.state.approach_residual},
                            {"change", changes ? by_name(*changes) : Json()},
                            {"status", row.status},
                            {"reason", row.reason}});
          else
            {
              std::cout << label(input) << ": ";
              for (std::size_t i = 0; changes && i < coefficient_names.size(); ++i)
                std::cout << coefficient_names[i] << " = "
                          << format_quantity(row.law[i], Dimension::number) << ", ";
              std::cout << row.status << (row.reason.empty() ? "" : ": ") << row.reason << '\n';
            }
        }
      if (options.write)
        write_back(options.database, database, beside);

      if (options.json)
        print_document({{"database", options.database},
                        {"rows", rows},
                        {"largest_change", by_name(largest)},
                        {"written", options.write}});
      else
        {
          std::cout << "largest relative change:";
          for (std::size_t i = 0; i < coefficient_names.size(); ++i)
            std::cout << ' ' << coefficient_names[i] << ' '
                      << format_quantity(largest[i], Dimension::number);
          std::cout << (options.write ? "; written to " : "; not written (--write does) to ")
                    << options.database << '\n';
        }
      return all_fitted ? ExitCode::success : ExitCode::incomplete;
    }
  } // namespace

  void add_fit(CLI::App &command, Action &action)
  {
    const auto options = std::make_shared<FitOptions>();
    command.add_option("DATABASE", options->database, "HDF5 file of a sweep")->required();
    command.add_flag(
      "--write", options->write, "store the new coefficients in the database and in its rows");
    add_json_flag(command, options->json);
    command.callback([options, &action] { action = [options] { return run(*options); }; });
  }
} // namespace dpcontact::commands
