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
  /// loading's; a, b, m, n smooth over the load levels of equal ν and φ.
  /// @return the worst first, each grade in the order of the nodes.
  std::vector<Finding> check(const UniversalTable &table);

  /// What a data package says about the table.
  PackageContent package_of(const UniversalTable &table);
} // namespace dpcontact

#endif
