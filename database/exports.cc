#include "database/exports.h"

#include "database/files.h"
#include "database/schema.h"
#include "database/text.h"

#include <ostream>
#include <sstream>

namespace dpcontact
{
  namespace
  {
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
    out << comment_lines("dpcontact: coefficients of elastic-plastic contact");
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
    write_file(file, text.str());
  }
} // namespace dpcontact
