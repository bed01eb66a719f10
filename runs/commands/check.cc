#include "database/files/digest.h"
#include "database/files/files.h"
#include "database/rows/checks.h"
#include "database/rows/exports.h"
#include "database/rows/read_in_child.h"
#include "database/tables/universal_checks.h"
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
    struct CheckOptions
    {
      std::string database;
      bool        json = false;
    };

    /// A table of rows begins with its title; other tables are universal, or excerpts of one.
    bool is_of_rows(const std::filesystem::path &file)
    {
      return file.extension() != ".csv" ||
             read_file(file).rfind(std::string("# ") + database_title, 0) == 0;
    }

    std::vector<Finding> findings_of(const std::filesystem::path &file)
    {
      if (!is_of_rows(file))
        return check_universal(file.string(), read_with_digest(file));
      try
        {
          check_digest(file);
        }
      catch (const CorruptData &error)
        {
          if (file.extension() == ".csv")
            throw;
          const ChildReading reading = read_in_child(file, read_file(file));
          throw CorruptData(std::string(error.what()) +
                            ". Read all the same, in a process of its own: " + reading.text +
                            (reading.code == ExitCode::success ? ", which may be wrong" : ""));
        }
      return check(read_database(file));
    }

    ExitCode run(const CheckOptions &options)
    {
      check_files({{options.database}, {}});
      const std::vector<Finding> findings = findings_of(options.database);
      std::array<std::size_t, 3> counts{};
      Json                       list = Json::array();
      for (const Finding &finding : findings)
        {
          ++counts[static_cast<std::size_t>(finding.grade)];
          list.push_back({{"grade", to_string(finding.grade)},
                          {"where", finding.where},
                          {"what", finding.what}});
          if (!options.json)
            std::cout << to_string(finding.grade) << ": " << finding.where << ": " << finding.what
                      << '\n';
        }
      if (options.json)
        print_document({{"database", options.database},
                        {"errors", counts[0]},
                        {"warnings", counts[1]},
                        {"notes", counts[2]},
                        {"findings", list}});
      else
        std::cout << options.database << ": " << counts[0] << " errors, " << counts[1]
                  << " warnings, " << counts[2] << " notes\n";
      return counts[0] > 0 ? ExitCode::incomplete : ExitCode::success;
    }
  } // namespace

  void add_check(CLI::App &command, Action &action)
  {
    const auto options = std::make_shared<CheckOptions>();
    command
      .add_option("DATABASE", options->database, "HDF5 file, CSV of an export, or universal table")
      ->required();
    add_json_flag(command, options->json);
    command.callback([options, &action] { action = [options] { return run(*options); }; });
  }
} // namespace dpcontact::commands
