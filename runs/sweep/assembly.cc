#include "runs/sweep/assembly.h"

#include "database/files/digest.h"
#include "database/rows/identity.h"
#include "database/rows/row_json.h"
#include "database/rows/store.h"
#include "meshing/errors.h"
#include "runs/interface/documents.h"
#include "runs/interface/version.h"
#include "solver/path/families.h"
#include "solver/path/method_version.h"

#include <iostream>
#include <optional>

namespace dpcontact
{
  namespace
  {
    Database assemble(const Sweep &sweep, const RowStore &rows)
    {
      Database database;
      for (const Case &input : sweep.cases)
        {
          auto row = rows.find(input);
          if (!row)
            throw FileError("the row of " + label(input) + " has vanished; run the sweep again");
          database.records.push_back(std::move(*row));
        }
      for (const auto &[name, version] : versions())
        database.provenance["version_" + name] = version;
      database.provenance["solver_settings"] = row_settings(sweep).dump();
      database.provenance["rows"]            = std::to_string(sweep.cases.size());
      return database;
    }

    /// Whether the file holds these rows already, whoever assembled it.
    bool up_to_date(const std::filesystem::path &file, const Database &database)
    {
      if (!std::filesystem::exists(file))
        return false;
      try
        {
          const Database stored = read_store(file);
          if (stored.records.size() != database.records.size())
            return false;
          for (std::size_t i = 0; i < stored.records.size(); ++i)
            if (to_json(stored.records[i]) != to_json(database.records[i]))
              return false;
          return stored.provenance.count("solver_settings") == 1 &&
                 stored.provenance.at("solver_settings") ==
                   database.provenance.at("solver_settings");
        }
      catch (const Error &error)
        {
          log_sweep(std::string(error.what()) + "; assembling it again from its rows");
          return false;
        }
    }
  } // namespace

  /// What every row depends on besides its inputs. In a family a row depends on the others: their
  /// load levels are where the common path stops.
  nlohmann::json row_settings(const Sweep &sweep)
  {
    nlohmann::json settings    = identity_json(sweep.solver);
    settings["method_version"] = method_version;
    settings["mode"]           = to_string(sweep.mode);
    if (sweep.mode == SweepMode::families)
      {
        nlohmann::json grid;
        for (const Case &input : sweep.cases)
          grid.push_back(key_json(input));
        settings["grid_sha256"] = sha256(grid.dump());
      }
    return settings;
  }

  /// A database without its rows cannot be resumed, but it must not be overwritten by rows of
  /// other settings either.
  void check_database(const Sweep &sweep)
  {
    if (std::filesystem::is_directory(sweep.database))
      throw FileError("cannot write the database " + sweep.database.string() +
                      ": it is a directory");
    if (!std::filesystem::exists(sweep.database) ||
        RowStore::stored_settings(sweep.database).has_value())
      return;
    const Database    stored = read_store(sweep.database);
    const auto        found  = stored.provenance.find("solver_settings");
    const std::string given  = row_settings(sweep).dump();
    if (found == stored.provenance.end() || found->second != given)
      throw SettingsMismatch(sweep.database.string() + " was made with other settings:\n  stored " +
                             (found == stored.provenance.end() ? "(absent)" : found->second) +
                             "\n  now    " + given +
                             "\nUse these settings again, or another database.");
  }

  Assembled assemble_database(const Sweep &sweep, const RowStore &rows)
  {
    const Database database = assemble(sweep, rows);
    Assembled      result;
    for (const Record &row : database.records)
      ++(row.converged() ? result.converged : result.failed);
    if (!up_to_date(sweep.database, database))
      {
        write_store(sweep.database, database);
        result.written = true;
      }
    log_sweep(sweep.database.string() + (result.written ? " was written" : " was up to date") +
              ": " + std::to_string(result.converged) + " rows converged, " +
              std::to_string(result.failed) + " failed");
    return result;
  }

  void log_sweep(const std::string &message) { std::cerr << "sweep: " << message << std::endl; }
} // namespace dpcontact
