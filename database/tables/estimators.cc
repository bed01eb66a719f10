#include "database/tables/estimators.h"

#include "meshing/errors.h"

namespace dpcontact
{
  std::unique_ptr<MaterialMethod> make_estimator(const LookupMethod   method,
                                                 const MaterialTable &table)
  {
    switch (method)
      {
        case LookupMethod::kriging:
          return make_kriging(table);
        case LookupMethod::natural_neighbour:
          return make_natural_neighbour(table);
        case LookupMethod::regression:
          return make_regression(regress(table));
        case LookupMethod::similarity:
        case LookupMethod::table_2:
          break;
      }
    throw InputError(std::string("method ") + to_string(method) + " needs no estimator");
  }
} // namespace dpcontact
