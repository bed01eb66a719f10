#ifndef DPCONTACT_SOLVER_SYSTEM_UNKNOWNS_H
#define DPCONTACT_SOLVER_SYSTEM_UNKNOWNS_H

#include <vector>

namespace dpcontact
{
  /// What equilibrium is solved for, in the system's units.
  struct Unknowns
  {
    std::vector<double> u;            ///< the free displacements of the discretisation
    double              approach = 0; ///< d, of the mirror plane
  };
} // namespace dpcontact

#endif
