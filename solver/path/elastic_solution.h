#ifndef DPCONTACT_SOLVER_PATH_ELASTIC_SOLUTION_H
#define DPCONTACT_SOLVER_PATH_ELASTIC_SOLUTION_H

#include "solver/path/solution.h"

namespace dpcontact
{
  /// Curve, pressure profile and axis stresses of a scene that yields nowhere, in closed form
  /// (Hertz; Wang et al. 2018, eq 8; Johnson, Contact Mechanics, 1985, eq 3.45). `yield`, `curve`,
  /// `coarser_steps`, `peak_profile` and `peak_axis` are set, SI units. Loading has `loading_steps`
  /// equal steps of (F/F_max)^⅓. The material's strength plays no role but for `yield`.
  Solution
  elastic_solution(const Material &material, const Scene &scene, unsigned int loading_steps);
} // namespace dpcontact

#endif
