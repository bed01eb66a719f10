#include "database/text.h"

#include "database/digest.h"
#include "database/files.h"
#include "meshing/errors.h"

#include <array>
#include <charconv>
#include <cmath>

namespace dpcontact
{
  namespace fs = std::filesystem;

  std::string number_text(const double value)
  {
    if (std::isnan(value))
      return "nan"; // without the sign that some systems print
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    return {digits.data(), end};
  }

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

  fs::path digest_path_of(const fs::path &file) { return file.string() + ".sha256"; }

  void check_digest(const fs::path &file)
  {
    const std::string remedy = "; restore both files, or make them again";
    const std::string actual = sha256_of_file(file);
    const fs::path    digest = digest_path_of(file);
    if (!fs::exists(digest))
      throw CorruptData("the digest " + digest.string() +
                        " is missing, so the database cannot be trusted" + remedy);
    const std::string stored = read_file(digest).substr(0, 65);
    if (stored.size() != 65 || stored.back() != ' ' ||
        stored.find_first_not_of("0123456789abcdef") != 64)
      throw CorruptData("the digest " + digest.string() + " is damaged" + remedy);
    if (stored.compare(0, 64, actual) != 0)
      throw CorruptData(file.string() + " is truncated or altered: its SHA-256 is " + actual +
                        ", its digest file says " + stored.substr(0, 64) + remedy);
  }

  void write_with_digest(const fs::path &file, const std::string &content)
  {
    TemporaryFile data(file);
    TemporaryFile digest(digest_path_of(file));
    data.write(content);
    data.sync();
    digest.write(sha256(content) + "  " + file.filename().string() + "\n");
    digest.sync();
    data.publish();
    digest.publish();
  }

  std::string read_with_digest(const fs::path &file)
  {
    check_digest(file);
    return read_file(file);
  }
} // namespace dpcontact
