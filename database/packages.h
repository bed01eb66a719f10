#ifndef DPCONTACT_DATABASE_PACKAGES_H
#define DPCONTACT_DATABASE_PACKAGES_H

#include "database/store.h"
#include "database/universal_table.h"

#include <filesystem>
#include <string>

namespace dpcontact
{
  // The table in other people's formats. All throw FileError where the file cannot be written; an
  // earlier one then stays as it was.

  /// One JSON object: title, provenance, columns (name, unit, description), rows (by column; null
  /// for NaN and infinities).
  void write_json(const std::filesystem::path &file, const Database &database);

  /// A workbook with the sheets rows, columns and provenance; cells of NaN and infinities stay
  /// empty.
  void write_xlsx(const std::filesystem::path &file, const Database &database);

  /// Frictionless data package of a CSV file of this program, which must lie in the same directory:
  /// its digest, dialect, and of each field type, unit, description and constraints; the primary
  /// key, licence, source and version.
  void write_datapackage(const std::filesystem::path &file,
                         const std::filesystem::path &csv,
                         const Database              &database);
  void write_datapackage(const std::filesystem::path &file,
                         const std::filesystem::path &csv,
                         const UniversalTable        &table);

  /// Metadata by DataCite's schema 4: title, creators, version and revision, licence, source paper.
  void write_datacite(const std::filesystem::path &file,
                      const std::string           &title,
                      const Provenance            &provenance);

  /// What a column's values must keep to wherever they are known.
  struct ColumnRange
  {
    double low, high;
    bool   above_low = false; ///< low itself is not allowed
  };
  ColumnRange range_of(const std::string &column);
} // namespace dpcontact

#endif
