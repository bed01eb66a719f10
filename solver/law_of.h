#ifndef DPCONTACT_SOLVER_LAW_OF_H
#define DPCONTACT_SOLVER_LAW_OF_H

#include "solver/laws/law.h"
#include "solver/scene.h"

namespace dpcontact
{
  /// The law of a material in a solver's units.
  /// @param stress_unit in Pa. @param strain_unit the strain that counts as 1; stresses over strains
  /// are then in units of stress_unit/strain_unit.
  laws::Law law_of(const Material &material, double stress_unit = 1, double strain_unit = 1);
} // namespace dpcontact

#endif
