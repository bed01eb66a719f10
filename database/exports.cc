#include "database/exports.h"

#include "database/files.h"
#include "database/schema.h"
#include "database/text.h"
#include "meshing/errors.h"

#include <ostream>
#include <sstream>

namespace dpcontact
{
  namespace
  {
    const char *const title = "dpcontact: coefficients of elastic-plastic contact";

    std::string cell(const double value) { return number_text(value); }

    std::string cell(const std::uint64_t value) { return std::to_string(value); }

    std::string cell(const std::string &text)
    {
      // '#' too: some readers take it for a comment wherever it stands
      if (text.find_first_of(",\"\r\n#") == std::string::npos)
        return text;
      std::string quoted = "\"";
      for (const char c : text)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
      return quoted + "\"";
    }
  } // namespace

  void write_csv(std::ostream &out, const Database &database)
  {
    out << comment_lines(title);
    out << comment_lines("schema_version: " + std::to_string(schema::version));
    for (const auto &[name, text] : database.provenance)
      out << comment_lines(name + ": " + text);
    out << comment_lines("columns (name, unit, description):");
    std::string header;
    for (const auto &column : schema::columns())
      {
        const std::string unit = column.unit;
        out << comment_lines("  " + std::string(column.name) + ", " +
                             (unit.empty() ? "text" : unit) + ", " + column.description);
        header += (header.empty() ? "" : ",") + std::string(column.name);
      }
    out << header << '\n';

    for (const auto &record : database.records)
      {
        std::string line;
        for (const auto &column : schema::columns())
          line +=
            (line.empty() ? "" : ",") +
            std::visit([&](const auto member) { return cell(record.*member); }, column.member);
        out << line << '\n';
      }
  }

  void write_csv(const std::filesystem::path &file, const Database &database)
  {
    std::ostringstream text;
    write_csv(text, database);
    write_with_digest(file, text.str());
  }

  Database read_csv(const std::filesystem::path &file)
  {
    const CsvTable csv(file.string(), read_with_digest(file));
    Database       database;
    if (csv.comments().empty() || csv.comments().front() != title)
      throw CorruptData(file.string() + " is not a table of this program");
    std::string version;
    for (const std::string &line : csv.comments())
      {
        const auto colon = line.find(": ");
        if (line.empty() || line[0] == ' ' || colon == std::string::npos || line == title)
          continue;
        if (line.substr(0, colon) == "schema_version")
          version = line.substr(colon + 2);
        else
          database.provenance[line.substr(0, colon)] = line.substr(colon + 2);
      }
    if (version != std::to_string(schema::version))
      throw SettingsMismatch(file.string() + " has schema version " + version +
                             ", this program reads version " + std::to_string(schema::version));
    database.records.resize(csv.rows());
    for (const auto &column : schema::columns())
      for (std::size_t i = 0; i < csv.rows(); ++i)
        std::visit(
          [&](const auto member) {
            auto &target = database.records[i].*member;
            using T      = std::decay_t<decltype(target)>;
            if constexpr (std::is_same_v<T, std::string>)
              target = csv.text(column.name, i);
            else if constexpr (std::is_same_v<T, double>)
              target = csv.number(column.name, i);
            else
              target = csv.count(column.name, i);
          },
          column.member);
    return database;
  }

  Database read_database(const std::filesystem::path &file)
  {
    return file.extension() == ".csv" ? read_csv(file) : read_store(file);
  }
} // namespace dpcontact
