#ifndef DPCONTACT_DATABASE_FILES_CSV_H
#define DPCONTACT_DATABASE_FILES_CSV_H

#include <cstdint>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

namespace dpcontact
{
  /// A text of any number of lines as lines that begin with `# `.
  std::string comment_lines(const std::string &text);

  /// The comment that says what a column means; CsvTable::require_unit() reads it.
  std::string
  column_comment(const std::string &name, const std::string &unit, const std::string &description);

  /// How a CsvWriter writes numbers.
  struct CsvFormat
  {
    /// What stands where a number is NaN.
    enum class NotANumber
    {
      named, ///< `nan`
      empty  ///< nothing: the cell is empty
    };

    /// Significant digits, 1 to 17, of numbers that are no integers. 0 writes the fewest digits
    /// that give the same double back, as number_text() does.
    int        digits = 0;
    NotANumber nan    = NotANumber::named;
  };

  /// Makes the text of a CSV file: lines of comments that begin with `# `, a header, and rows as
  /// long as the header. Texts with commas, quotes, line ends or `#` are quoted as in RFC 4180.
  class CsvWriter
  {
  public:
    explicit CsvWriter(const CsvFormat &format = {});

    /// Writes a text of any number of lines as comments, which must stand before the header.
    void comment(const std::string &text);

    void header(const std::vector<std::string> &names);

    /// Appends a cell to the row that is being written.
    void add(double value);
    void add(const std::string &text);
    template <typename Integer, typename = std::enable_if_t<std::is_integral_v<Integer>>>
    void add(const Integer value)
    {
      append(std::to_string(value));
    }

    /// Ends a row of cells that add() has written.
    /// @throws Error, of a defect of the program, unless it has as many cells as the header.
    void end_row();

    /// Writes a whole row: numbers and texts in any order. @throws as end_row() does.
    template <typename... Cells>
    void row(const Cells &...values)
    {
      (add(values), ...);
      end_row();
    }

    /// All lines that were written so far.
    const std::string &text() const { return lines; }

  private:
    void append(const std::string &cell);

    CsvFormat   format;
    std::string lines;
    std::size_t n_columns = 0, n_cells = 0;
  };

  /// A table that a CsvWriter has written, or a person in the same form: lines that begin with `#`,
  /// a header, and rows as long as the header. Columns are found by their names.
  class CsvTable
  {
  public:
    /// @param name of the file, for messages.
    /// @param text of the whole file.
    /// @throws CorruptData where the text is not such a table.
    CsvTable(std::string name, const std::string &text);

    std::size_t rows() const { return cells.size(); }

    /// The lines of comments, without their `# `.
    const std::vector<std::string> &comments() const { return comment; }

    /// @throws CorruptData unless a comment (column_comment()) says this unit of the column.
    void require_unit(const std::string &column, const std::string &unit) const;

    bool has(const std::string &column) const { return columns.count(column) == 1; }

    /// The cell of a column in a row, counted from 0, as it stands there.
    /// @throws CorruptData where the column is missing.
    const std::string &text(const std::string &column, std::size_t row) const;

    /// The cell as a number or as a count.
    /// @throws CorruptData where the column is missing or the cell is no number or no count.
    double        number(const std::string &column, std::size_t row) const;
    std::uint64_t count(const std::string &column, std::size_t row) const;

  private:
    template <typename T>
    T parsed(const std::string &column, std::size_t row, const char *what) const;

    std::string                           file;
    std::vector<std::string>              comment;
    std::map<std::string, std::size_t>    columns;
    std::vector<std::vector<std::string>> cells;
  };
} // namespace dpcontact

#endif
