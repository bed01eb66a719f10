#ifndef DPCONTACT_DATABASE_TABLES_UNIVERSAL_CHECKS_H
#define DPCONTACT_DATABASE_TABLES_UNIVERSAL_CHECKS_H

#include "database/rows/findings.h"
#include "database/rows/packages.h"
#include "database/tables/universal_table.h"

#include <vector>

namespace dpcontact
{
  /// Of every node: columns in their ranges, first yield as in closed form, a, m = 1 and
  /// b, n = 1.5 where nothing yields, the laws through the peak, unloading's work at most
  /// loading's; stated errors and misfits of the order of what they belong to; a, b, m, n smooth
  /// over the load levels of equal ν and φ. Of the table: as many nodes as the provenance says.
  /// @return the worst first, each grade in the order of the nodes.
  std::vector<Finding> check(const UniversalTable &table);

  /// check() of the text of a file. Where it does not begin as a universal table, it is read as an
  /// excerpt that has the contact law's columns alone (contact_law.h), of which a note is made.
  /// @param name of the file, for messages.
  /// @throws CorruptData where it is neither.
  std::vector<Finding> check_universal(const std::string &name, const std::string &text);

  /// A table that others rely on.
  /// @throws as UniversalTable::read() does; CorruptData where check() finds an error.
  UniversalTable read_checked_universal(const std::filesystem::path &file);

  /// What a data package says about the table.
  PackageContent package_of(const UniversalTable &table);
} // namespace dpcontact

#endif
