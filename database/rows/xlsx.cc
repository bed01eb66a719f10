#include "database/files/files.h"
#include "database/rows/packages.h"
#include "database/rows/row_json.h"
#include "database/rows/schema.h"
#include "meshing/errors.h"

#include <cmath>
#include <type_traits>
#include <xlsxwriter.h>

namespace dpcontact
{
  namespace
  {
    void text(lxw_worksheet     *sheet,
              const std::size_t  row,
              const std::size_t  column,
              const std::string &content)
    {
      worksheet_write_string(sheet,
                             static_cast<lxw_row_t>(row),
                             static_cast<lxw_col_t>(column),
                             clean_text(content).c_str(),
                             nullptr);
    }

    void fill(lxw_workbook *book, const Database &database)
    {
      lxw_worksheet *const rows = workbook_add_worksheet(book, "rows");
      lxw_worksheet *const list = workbook_add_worksheet(book, "columns");
      lxw_worksheet *const from = workbook_add_worksheet(book, "provenance");
      worksheet_freeze_panes(rows, 1, 0);
      text(list, 0, 0, "name");
      text(list, 0, 1, "unit");
      text(list, 0, 2, "description");
      const auto &columns = schema::columns();
      for (std::size_t c = 0; c < columns.size(); ++c)
        {
          text(rows, 0, c, columns[c].name);
          text(list, c + 1, 0, columns[c].name);
          text(list, c + 1, 1, columns[c].unit);
          text(list, c + 1, 2, columns[c].description);
          for (std::size_t r = 0; r < database.records.size(); ++r)
            std::visit(
              [&](const auto &value) {
                using T = std::decay_t<decltype(value)>;
                if constexpr (std::is_same_v<T, std::string>)
                  text(rows, r + 1, c, value);
                else if (const auto number = static_cast<double>(value); std::isfinite(number))
                  worksheet_write_number(rows,
                                         static_cast<lxw_row_t>(r + 1),
                                         static_cast<lxw_col_t>(c),
                                         number,
                                         nullptr);
              },
              columns[c].get(database.records[r]));
        }
      std::size_t row = 0;
      text(from, row, 0, "schema_version");
      text(from, row++, 1, std::to_string(schema::version));
      for (const auto &[name, content] : database.provenance)
        {
          text(from, row, 0, name);
          text(from, row++, 1, content);
        }
    }
  } // namespace

  void write_xlsx(const std::filesystem::path &file, const Database &database)
  {
    TemporaryFile        temporary(file);
    lxw_workbook_options options{};
    lxw_workbook *const  book = workbook_new_opt(temporary.path().c_str(), &options);
    if (book == nullptr)
      throw FileError("cannot write " + file.string() + ": no workbook");
    fill(book, database);
    if (const lxw_error error = workbook_close(book); error != LXW_NO_ERROR)
      throw FileError("cannot write " + file.string() + ": " + lxw_strerror(error));
    temporary.sync();
    temporary.publish();
  }
} // namespace dpcontact
