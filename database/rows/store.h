#ifndef DPCONTACT_DATABASE_ROWS_STORE_H
#define DPCONTACT_DATABASE_ROWS_STORE_H

#include "database/rows/record.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace dpcontact
{
  /// Where numbers come from: git revision, versions of libraries, the full input, by name.
  using Provenance = std::map<std::string, std::string>;

  /// What a database calls itself in files.
  constexpr const char *database_title = "dpcontact: coefficients of elastic-plastic contact";

  /// Rows in the order of the table, and where they come from.
  struct Database
  {
    std::vector<Record> records;
    Provenance          provenance;
  };

  /// Writes the HDF5 file @p file and its digest `<file>.sha256` (`sha256sum -c` understands it) as
  /// write_with_digest() does. The file is made in memory and read back there, and every row, curve
  /// and text compared, before anything is written.
  ///
  /// Layout: attributes `title` and `schema_version` at the root; `/provenance` with one attribute
  /// an entry; `/rows/<column>`, one dataset of length N a column;
  /// `/curves/<i>/loading/<quantity>`,
  /// `/curves/<i>/unloading/<quantity>` and `/curves/<i>/profile/<quantity>` for row i. Every
  /// dataset has attributes `units` and `description`. Equal content gives equal bytes.
  ///
  /// @throws FileError with the system's reason where it cannot be written; an earlier file and its
  /// digest then stay as they were.
  void write_store(const std::filesystem::path &file, const Database &database);

  /// Reads it back, after the digest of the whole file has been checked and a process of its own
  /// (read_in_child()) has read it without crashing.
  /// @throws FileError if it is missing or unreadable, CorruptData if it is truncated, altered, not
  /// ours or has no digest, SettingsMismatch if it has another schema version.
  Database read_store(const std::filesystem::path &file);

  /// The database in the bytes of a file, at once. HDF5 can crash on damaged ones: for
  /// read_in_child() only.
  /// @param file its name, for messages.
  Database read_store_unchecked(const std::filesystem::path &file, const std::string &bytes);
} // namespace dpcontact

#endif
