#include "database/files/csv.h"

#include "meshing/errors.h"
#include "meshing/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace dpcontact
{
  std::string comment_lines(const std::string &text)
  {
    std::string lines = "# ";
    for (const char c : text)
      if (c == '\n')
        lines += "\n# ";
      else if (c != '\r')
        lines += c;
    return lines + "\n";
  }

  std::string
  column_comment(const std::string &name, const std::string &unit, const std::string &description)
  {
    return "  " + name + ", " + unit + ", " + description;
  }

  namespace
  {
    /// A text as a cell. Some readers take `#` for a comment wherever it stands.
    std::string quoted_where_needed(const std::string &text)
    {
      if (text.find_first_of(",\"\r\n#") == std::string::npos)
        return text;
      std::string quoted = "\"";
      for (const char c : text)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
      return quoted + "\"";
    }

    std::string with_digits(const double value, const int digits)
    {
      char       buffer[64];
      const auto end =
        std::to_chars(buffer, buffer + sizeof(buffer), value, std::chars_format::general, digits)
          .ptr;
      return {buffer, end};
    }
  } // namespace

  CsvWriter::CsvWriter(const CsvFormat &format_)
    : format(format_)
  {}

  void CsvWriter::comment(const std::string &text) { lines += comment_lines(text); }

  void CsvWriter::header(const std::vector<std::string> &names)
  {
    n_columns = names.size();
    for (const std::string &name : names)
      add(name);
    end_row();
  }

  void CsvWriter::add(const double value)
  {
    if (std::isnan(value))
      append(format.nan == CsvFormat::NotANumber::empty ? "" : number_text(value));
    else
      append(format.digits == 0 ? number_text(value) : with_digits(value, format.digits));
  }

  void CsvWriter::add(const std::string &text) { append(quoted_where_needed(text)); }

  void CsvWriter::append(const std::string &cell)
  {
    if (n_cells++ > 0)
      lines += ',';
    lines += cell;
  }

  void CsvWriter::end_row()
  {
    if (n_cells != n_columns)
      throw Error(ExitCode::internal,
                  "CSV: a row has " + std::to_string(n_cells) + " cells, the header " +
                    std::to_string(n_columns));
    lines += '\n';
    n_cells = 0;
  }

  namespace
  {
    /// The record that begins at `at`, which moves behind it. An unfinished quotation is left open.
    std::vector<std::string> read_record(const std::string &text, std::size_t &at, bool &open)
    {
      std::vector<std::string> fields(1);
      open = false;
      for (; at < text.size(); ++at)
        {
          const char c = text[at];
          if (open)
            {
              if (c != '"')
                fields.back() += c;
              else if (at + 1 < text.size() && text[at + 1] == '"')
                fields.back() += text[++at];
              else
                open = false;
            }
          else if (c == '"')
            open = true;
          else if (c == ',')
            fields.emplace_back();
          else if (c == '\n')
            {
              ++at;
              break;
            }
          else if (c != '\r')
            fields.back() += c;
        }
      return fields;
    }
  } // namespace

  CsvTable::CsvTable(std::string name, const std::string &text)
    : file(std::move(name))
  {
    std::size_t at = 0;
    while (at < text.size() && text[at] == '#')
      {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        comment.push_back(text.substr(std::min(at + 2, end), end - std::min(at + 2, end)));
        at = std::min(end + 1, text.size());
      }
    bool       open   = false;
    const auto header = read_record(text, at, open);
    for (std::size_t i = 0; i < header.size(); ++i)
      if (header[i].empty() || !columns.emplace(header[i], i).second)
        throw CorruptData(file + ": the header has an empty or repeated name");
    while (at < text.size() && !open)
      {
        cells.push_back(read_record(text, at, open));
        if (cells.back().size() != header.size())
          throw CorruptData(file + ": row " + std::to_string(cells.size()) + " has " +
                            std::to_string(cells.back().size()) + " cells, the header " +
                            std::to_string(header.size()));
      }
    if (open)
      throw CorruptData(file + ": a quotation does not end");
  }

  void CsvTable::require_unit(const std::string &column, const std::string &unit) const
  {
    const std::string begin = column_comment(column, "", "").substr(0, column.size() + 4);
    std::size_t       count = 0;
    for (const std::string &line : comment)
      if (line.compare(0, begin.size(), begin) == 0)
        {
          const std::string said =
            line.substr(begin.size(), line.find(", ", begin.size()) - begin.size());
          if (said != unit)
            throw CorruptData(file + ": " + column + " is in '" + said + "', it should be in '" +
                              unit + "'");
          ++count;
        }
    if (count != 1)
      throw CorruptData(file + ": the comments name the unit of " + column + ' ' +
                        std::to_string(count) + " times, it should be once");
  }

  const std::string &CsvTable::text(const std::string &column, const std::size_t row) const
  {
    const auto found = columns.find(column);
    if (found == columns.end())
      throw CorruptData(file + ": the column " + column + " is missing");
    return cells.at(row)[found->second];
  }

  template <typename T>
  T CsvTable::parsed(const std::string &column, const std::size_t row, const char *const what) const
  {
    const std::string &cell  = text(column, row);
    T                  value = 0;
    const auto         end   = cell.data() + cell.size();
    const auto         found = std::from_chars(cell.data(), end, value);
    if (cell.empty() || found.ec != std::errc() || found.ptr != end)
      throw CorruptData(file + ": " + column + " in row " + std::to_string(row + 1) + ", '" + cell +
                        "', is not a " + what);
    return value;
  }

  double CsvTable::number(const std::string &column, const std::size_t row) const
  {
    return parsed<double>(column, row, "number");
  }

  std::uint64_t CsvTable::count(const std::string &column, const std::size_t row) const
  {
    return parsed<std::uint64_t>(column, row, "count");
  }
} // namespace dpcontact
