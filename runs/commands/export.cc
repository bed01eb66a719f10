#include "database/rows/exports.h"
#include "database/rows/packages.h"
#include "meshing/errors.h"
#include "runs/commands/commands.h"
#include "runs/commands/options.h"
#include "runs/interface/documents.h"
#include "runs/interface/outputs.h"

#include <iostream>
#include <memory>

namespace dpcontact::commands
{
  namespace
  {
    struct ExportOptions
    {
      std::string database;
      std::string csv, datapackage, xlsx, json_table, datacite;
      bool        json = false;
    };

    ExitCode run(const ExportOptions &options)
    {
      if (!options.datapackage.empty() && options.csv.empty())
        throw InputError("export: --datapackage describes the file of --csv: give that too");
      check_files(
        {{options.database},
         {options.csv, options.datapackage, options.xlsx, options.json_table, options.datacite}});
      const Database database = read_database(options.database);
      Json           written  = {{"database", options.database}};
      const auto     note     = [&](const char *what, const std::string &file) {
        written[what] = file;
        if (!options.json)
          std::cout << file << ": " << database.records.size() << " rows\n";
      };
      if (!options.csv.empty())
        {
          write_csv(std::filesystem::path(options.csv), database);
          note("csv", options.csv);
        }
      if (!options.datapackage.empty())
        {
          write_datapackage(options.datapackage, options.csv, package_of(database));
          note("datapackage", options.datapackage);
        }
      if (!options.xlsx.empty())
        {
          write_xlsx(options.xlsx, database);
          note("xlsx", options.xlsx);
        }
      if (!options.json_table.empty())
        {
          write_json(options.json_table, database);
          note("json_table", options.json_table);
        }
      if (!options.datacite.empty())
        {
          write_datacite(options.datacite, database_title, database.provenance);
          note("datacite", options.datacite);
        }
      written["rows"] = database.records.size();
      if (options.json)
        print_document(written);
      return ExitCode::success;
    }
  } // namespace

  void add_export(CLI::App &command, Action &action)
  {
    const auto options = std::make_shared<ExportOptions>();
    command.add_option("DATABASE", options->database, "HDF5 file of a sweep, or CSV of an export")
      ->required();
    CLI::Option_group *const formats = command.add_option_group("Formats", "at least one of them");
    formats->require_option(1, 0);
    const auto file = [&](const char *name, std::string &target, const char *help) {
      formats->add_option(name, target, help)->type_name("FILE");
    };
    file("--csv", options->csv, "CSV, and its digest beside it");
    file("--datapackage", options->datapackage, "Frictionless data package of that CSV file");
    file("--xlsx", options->xlsx, "spreadsheet");
    file("--json-table", options->json_table, "JSON");
    file("--datacite", options->datacite, "DataCite metadata");
    add_json_flag(command, options->json);
    command.callback([options, &action] { action = [options] { return run(*options); }; });
  }
} // namespace dpcontact::commands
