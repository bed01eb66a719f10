#ifndef DPCONTACT_DATABASE_TABLES_ESTIMATORS_H
#define DPCONTACT_DATABASE_TABLES_ESTIMATORS_H

#include "database/tables/lookup.h"
#include "database/tables/material_table.h"

namespace dpcontact
{
  /// Kriging, natural neighbours or the regression over the rows of a table, for LookupTable. They
  /// need OpenTURNS and CGAL.
  std::unique_ptr<MaterialMethod> make_estimator(LookupMethod method, const MaterialTable &table);
} // namespace dpcontact

#endif
