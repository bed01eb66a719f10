#ifndef DPCONTACT_DATABASE_TEXT_H
#define DPCONTACT_DATABASE_TEXT_H

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace dpcontact
{
  /// The fewest digits that give the same double back; NaN and infinities are nan, inf, -inf.
  std::string number_text(double value);

  /// Text of any number of lines as CSV comment lines.
  std::string comment_lines(const std::string &text);

  /// A CSV text of this program: lines that begin with `#`, a header, rows of equal length; fields
  /// with commas, quotes or line ends quoted as in RFC 4180.
  class CsvTable
  {
  public:
    /// @param name of the file, for messages. @throws CorruptData where the text is not such a table.
    CsvTable(std::string name, const std::string &text);

    std::size_t                     rows() const { return cells.size(); }
    const std::vector<std::string> &comments() const { return comment; } ///< without "# "
    bool has(const std::string &column) const { return columns.count(column) == 1; }

    /// @throws CorruptData where the column is missing or, of number() and count(), the cell is
    /// none.
    const std::string &text(const std::string &column, std::size_t row) const;
    double             number(const std::string &column, std::size_t row) const;
    std::uint64_t      count(const std::string &column, std::size_t row) const;

  private:
    template <typename T>
    T parsed(const std::string &column, std::size_t row, const char *what) const;

    std::string                           file;
    std::vector<std::string>              comment;
    std::map<std::string, std::size_t>    columns;
    std::vector<std::vector<std::string>> cells;
  };

  /// Writes a file and its digest `<file>.sha256`, each synced and renamed. @throws FileError.
  void write_with_digest(const std::filesystem::path &file, const std::string &content);

  /// @throws FileError if it cannot be read, CorruptData unless its digest holds.
  std::string read_with_digest(const std::filesystem::path &file);

  /// @throws CorruptData unless the digest beside the file is the file's.
  void check_digest(const std::filesystem::path &file);

  /// `<file>.sha256`
  std::filesystem::path digest_path_of(const std::filesystem::path &file);
} // namespace dpcontact

#endif
