#include "database/rows/exports.h"

#include "database/files/csv.h"
#include "database/files/digest.h"
#include "database/rows/schema.h"
#include "meshing/errors.h"

#include <string>
#include <type_traits>
#include <vector>

namespace dpcontact
{
  namespace
  {
    std::string unit_in_csv(const schema::Column &column)
    {
      return column.unit.empty() ? "text" : column.unit;
    }
  } // namespace

  std::string csv_text(const Database &database)
  {
    CsvWriter csv;
    csv.comment(database_title);
    csv.comment("schema_version: " + std::to_string(schema::version));
    for (const auto &[name, text] : database.provenance)
      csv.comment(name + ": " + text);
    csv.comment("columns (name, unit, description):");
    std::vector<std::string> names;
    for (const schema::Column &column : schema::columns())
      {
        csv.comment(column_comment(column.name, unit_in_csv(column), column.description));
        names.push_back(column.name);
      }
    csv.header(names);
    for (const Record &record : database.records)
      {
        for (const schema::Column &column : schema::columns())
          std::visit([&csv](const auto &value) { csv.add(value); }, column.get(record));
        csv.end_row();
      }
    return csv.text();
  }

  void write_csv(const std::filesystem::path &file, const Database &database)
  {
    write_with_digest(file, csv_text(database));
  }

  Database read_csv(const std::filesystem::path &file)
  {
    const CsvTable csv(file.string(), read_with_digest(file));
    Database       database;
    if (csv.comments().empty() || csv.comments().front() != database_title)
      throw CorruptData(file.string() + " is not a table of rows, as `dpcontact export` writes it");
    std::string version;
    for (const std::string &line : csv.comments())
      {
        const auto colon = line.find(": ");
        if (line.empty() || line[0] == ' ' || colon == std::string::npos || line == database_title)
          continue;
        if (line.substr(0, colon) == "schema_version")
          version = line.substr(colon + 2);
        else
          database.provenance[line.substr(0, colon)] = line.substr(colon + 2);
      }
    schema::check_version(file.string(), version);
    for (const schema::Column &column : schema::columns())
      csv.require_unit(column.name, unit_in_csv(column));
    database.records.resize(csv.rows());
    for (const auto &column : schema::columns())
      for (std::size_t i = 0; i < csv.rows(); ++i)
        {
          schema::Cell cell = column.get(database.records[i]);
          std::visit(
            [&](auto &value) {
              using T = std::decay_t<decltype(value)>;
              if constexpr (std::is_same_v<T, std::string>)
                value = csv.text(column.name, i);
              else if constexpr (std::is_same_v<T, double>)
                value = csv.number(column.name, i);
              else
                value = csv.count(column.name, i);
            },
            cell);
          try
            {
              schema::enter(column, cell, database.records[i]);
            }
          catch (const CorruptData &error)
            {
              throw CorruptData(file.string() + ", row " + std::to_string(i + 1) + ": " +
                                error.what());
            }
        }
    return database;
  }

  Database read_database(const std::filesystem::path &file)
  {
    return file.extension() == ".csv" ? read_csv(file) : read_store(file);
  }
} // namespace dpcontact
