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
#include <set>

namespace dpcontact
{
  namespace
  {
    using Keys = std::set<CaseKey>;

    Keys keys_of(const std::vector<Case> &cases)
    {
      Keys keys;
      for (const Case &input : cases)
        keys.insert(key_of(input));
      return keys;
    }

    /// The rows of other grids, in the order that assemble_database() promises.
    std::vector<Record> rows_of_other_grids(const Sweep &sweep, const RowStore &rows)
    {
      Keys                known = keys_of(sweep.cases);
      std::vector<Record> others;
      for (const Record &listed : rows_in_file(sweep))
        if (known.count(key_of(listed.input)) == 0)
          if (auto row = rows.find(listed.input))
            {
              known.insert(key_of(listed.input));
              others.push_back(std::move(*row));
            }
      for (Record &row : rows.all())
        if (known.insert(key_of(row.input)).second)
          others.push_back(std::move(row));
      return others;
    }

    Database assemble(const Sweep &sweep, const RowStore &rows, const std::vector<Record> &others)
    {
      Database database;
      for (const Case &input : sweep.cases)
        {
          auto row = rows.find(input);
          if (!row)
            throw FileError("the row of " + label(input) + " has vanished; run the sweep again");
          database.records.push_back(std::move(*row));
        }
      if (sweep.other_rows == OtherRows::keep)
        database.records.insert(database.records.end(), others.begin(), others.end());
      for (const auto &[name, version] : versions())
        database.provenance["version_" + name] = version;
      database.provenance["solver_settings"] = row_settings(sweep).dump();
      database.provenance["rows"]            = std::to_string(database.records.size());
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

  void check_database(const Sweep &sweep)
  {
    if (std::filesystem::is_directory(sweep.database))
      throw FileError("cannot write the database " + sweep.database.string() +
                      ": it is a directory");
    RowStore::check_settings(sweep.database, row_settings(sweep));
    if (!std::filesystem::exists(sweep.database))
      return;
    Database stored;
    try
      {
        stored = read_store(sweep.database);
      }
    catch (const CorruptData &)
      {
        if (RowStore::stored_settings(sweep.database).has_value())
          return;
        throw;
      }
    const auto        found = stored.provenance.find("solver_settings");
    const std::string given = row_settings(sweep).dump();
    if (found == stored.provenance.end() || found->second != given)
      throw SettingsMismatch(sweep.database.string() + " was made with other settings:\n  stored " +
                             (found == stored.provenance.end() ? "(absent)" : found->second) +
                             "\n  now    " + given +
                             "\nUse these settings again, or another database.");
  }

  std::vector<Record> rows_in_file(const Sweep &sweep)
  {
    if (!std::filesystem::exists(sweep.database))
      return {};
    try
      {
        Database   stored = read_store(sweep.database);
        const auto found  = stored.provenance.find("solver_settings");
        if (found != stored.provenance.end() && found->second == row_settings(sweep).dump())
          return std::move(stored.records);
      }
    catch (const CorruptData &)
      {}
    return {};
  }

  void take_up_rows(const Sweep &sweep, const RowStore &rows)
  {
    const Keys  grid  = keys_of(sweep.cases);
    const bool  all   = rows.names().empty();
    std::size_t taken = 0;
    for (const Record &row : rows_in_file(sweep))
      {
        const bool wanted =
          grid.count(key_of(row.input)) == 1 ? all : sweep.other_rows == OtherRows::keep;
        if (wanted && !rows.find(row.input))
          {
            rows.write(row);
            ++taken;
          }
      }
    if (taken > 0)
      log_sweep(std::to_string(taken) + " rows were taken up from " + sweep.database.string());
  }

  Assembled assemble_database(const Sweep &sweep, const RowStore &rows)
  {
    const std::vector<Record> others   = rows_of_other_grids(sweep, rows);
    const Database            database = assemble(sweep, rows, others);
    Assembled                 result;
    for (std::size_t i = 0; i < sweep.cases.size(); ++i)
      ++(database.records[i].converged() ? result.converged : result.failed);
    result.kept = database.records.size() - sweep.cases.size();
    if (!up_to_date(sweep.database, database))
      {
        write_store(sweep.database, database);
        result.written = true;
      }
    const std::size_t dropped = others.size() - result.kept;
    if (dropped > 0)
      for (const Record &row : others)
        rows.remove(row.input);
    log_sweep(
      sweep.database.string() + (result.written ? " was written" : " was up to date") + ": " +
      std::to_string(result.converged) + " rows converged, " + std::to_string(result.failed) +
      " failed" +
      (result.kept > 0 ? "; " + std::to_string(result.kept) + " rows of other grids kept" : "") +
      (dropped > 0 ? "; " + std::to_string(dropped) + " rows of other grids dropped" : ""));
    return result;
  }

  void log_sweep(const std::string &message) { std::cerr << "sweep: " << message << std::endl; }
} // namespace dpcontact
