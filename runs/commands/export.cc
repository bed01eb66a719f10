#include "database/exports.h"
#include "runs/commands/commands.h"
#include "runs/commands/options.h"
#include "runs/documents.h"

#include <iostream>
#include <memory>

namespace dpcontact::commands
{
  namespace
  {
    struct Options
    {
      std::string database;
      std::string csv;
      bool        json = false;
    };

    ExitCode run(const Options &options)
    {
      const Database database = read_store(options.database);
      write_csv(std::filesystem::path(options.csv), database);
      if (options.json)
        print_document({{"database", options.database},
                        {"csv", options.csv},
                        {"rows", database.records.size()}});
      else
        std::cout << options.csv << ": " << database.records.size() << " rows\n";
      return ExitCode::success;
    }
  } // namespace

  void add_export(CLI::App &program, Action &action)
  {
    const auto      options = std::make_shared<Options>();
    CLI::App *const command = program.add_subcommand("export", "The table of a database as CSV");
    command->add_option("DATABASE", options->database, "HDF5 file of a sweep")->required();
    command->add_option("--csv", options->csv, "file to write")->required()->type_name("FILE");
    add_json_flag(*command, options->json);
    command->callback([options, &action] { action = [options] { return run(*options); }; });
  }
} // namespace dpcontact::commands
