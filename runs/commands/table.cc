#include "database/rows/checks.h"
#include "database/rows/packages.h"
#include "database/tables/universal_checks.h"
#include "database/tables/universal_table.h"
#include "runs/commands/commands.h"
#include "runs/commands/options.h"
#include "runs/interface/documents.h"
#include "runs/interface/outputs.h"
#include "runs/interface/version.h"

#include <iostream>
#include <memory>

namespace dpcontact::commands
{
  namespace
  {
    struct TableOptions
    {
      std::string database;
      std::string csv, join, datapackage, datacite;
      bool        json = false;
    };

    ExitCode run(const TableOptions &options)
    {
      check_files(
        {{options.database, options.join}, {options.csv, options.datapackage, options.datacite}});
      UniversalTable table =
        UniversalTable::from_rows(read_checked_store(options.database), git_revision());
      if (!options.join.empty())
        table = table.joined(read_checked_universal(options.join));
      table.write(options.csv);
      if (!options.datapackage.empty())
        write_datapackage(options.datapackage, options.csv, package_of(table));
      if (!options.datacite.empty())
        write_datacite(options.datacite, universal_title, table.made_from());
      if (options.json)
        print_document({{"database", options.database},
                        {"csv", options.csv},
                        {"nu", table.nu()},
                        {"phi_deg", table.phi_deg()},
                        {"load_level", table.load_level()}});
      else
        std::cout << options.csv << ": " << table.nu().size() << " nu x " << table.phi_deg().size()
                  << " phi x " << table.load_level().size() << " load levels\n";
      return ExitCode::success;
    }
  } // namespace

  void add_table(CLI::App &command, Action &action)
  {
    const auto options = std::make_shared<TableOptions>();
    command.add_option("DATABASE", options->database, "HDF5 file of runs/universal.prm")
      ->required();
    command.add_option("--csv", options->csv, "file to write, and its digest beside it")
      ->required()
      ->type_name("FILE");
    command
      .add_option("--join",
                  options->join,
                  "table of the same settings whose nodes are added, where the sweep holds what a "
                  "denser grid has beside them")
      ->type_name("FILE");
    command.add_option("--datapackage", options->datapackage, "Frictionless data package of it")
      ->type_name("FILE");
    command.add_option("--datacite", options->datacite, "DataCite metadata")->type_name("FILE");
    add_json_flag(command, options->json);
    command.callback([options, &action] { action = [options] { return run(*options); }; });
  }
} // namespace dpcontact::commands
