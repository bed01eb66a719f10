#ifndef DPCONTACT_DATABASE_ROWS_EXPORTS_H
#define DPCONTACT_DATABASE_ROWS_EXPORTS_H

#include "database/rows/store.h"

#include <filesystem>
#include <string>

namespace dpcontact
{
  /// The table as CSV: lines that begin with `#` (title, schema version, provenance, and name, unit
  /// and description of every column), the header, one line a row. Numbers have the fewest digits
  /// that give the same double back; NaN and infinities are `nan`, `inf`, `-inf`; text with commas,
  /// quotes or line ends is quoted as in RFC 4180. Units are in the names of the columns.
  std::string csv_text(const Database &database);

  /// The same into a file, and its digest `<file>.sha256`, through temporary ones that are synced
  /// and
  /// renamed. @throws FileError where it cannot be written; an earlier file then stays as it was.
  void write_csv(const std::filesystem::path &file, const Database &database);
  /// The table that write_csv() wrote, without its curves.
  /// @throws FileError if it cannot be read, CorruptData if its digest does not hold or it is not such a
  /// table, SettingsMismatch if it has another schema version.
  Database read_csv(const std::filesystem::path &file);

  /// read_csv() for names that end in .csv, read_store() for others.
  Database read_database(const std::filesystem::path &file);
} // namespace dpcontact

#endif
