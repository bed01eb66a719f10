#ifndef DPCONTACT_DATABASE_ROWS_PACKAGES_H
#define DPCONTACT_DATABASE_ROWS_PACKAGES_H

#include "database/rows/store.h"

#include <filesystem>
#include <string>
#include <vector>

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

  /// A column as a data package describes it.
  struct PackageField
  {
    std::string              name;
    std::string              type; ///< "string", "number" or "integer"
    std::string              unit; ///< of a number
    std::string              description;
    Range                    range;   ///< of a number
    std::vector<std::string> choices; ///< of a text that is one of some words
  };

  /// What a data package says about a table.
  struct PackageContent
  {
    std::string               title;
    Provenance                provenance;
    std::vector<PackageField> fields;
    std::vector<std::string>  key; ///< names of the columns that identify a row
  };
  PackageContent package_of(const Database &database);

  /// Frictionless data package of a CSV file of this program, which must lie in the same directory:
  /// its digest, dialect, and of each field type, unit, description and constraints; the primary
  /// key, licence, source and version.
  void write_datapackage(const std::filesystem::path &file,
                         const std::filesystem::path &csv,
                         const PackageContent        &content);

  /// Metadata by DataCite's schema 4: title, creators, version and revision, licence, source paper.
  void write_datacite(const std::filesystem::path &file,
                      const std::string           &title,
                      const Provenance            &provenance);
} // namespace dpcontact

#endif
