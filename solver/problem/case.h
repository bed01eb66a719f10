#ifndef DPCONTACT_SOLVER_PROBLEM_CASE_H
#define DPCONTACT_SOLVER_PROBLEM_CASE_H

#include "solver/problem/scene.h"

#include <string>
#include <utility>
#include <vector>

namespace dpcontact
{
  /// What is computed: a material (of the first body, or of both) and a scene.
  struct Case
  {
    Material material;
    Scene    scene;
  };
  bool operator==(const Case &p, const Case &q);

  using CaseParameter = Parameter<Case>;

  /// Every number that describes a case besides the criterion: the material's, then the scene's,
  /// those included that are another way to give one (`instead_of`). Its order is that of grids
  /// (the first varies slowest), help and documents.
  const std::vector<CaseParameter> &case_parameters();

  /// Those of case_parameters() that a row keeps: each number of a case once.
  const std::vector<CaseParameter> &stored_parameters();

  /// @throws std::out_of_range where there is none of this name.
  const CaseParameter &case_parameter(const std::string &name);

  /// What two rows of the same material and scene have in common: the criterion's name and the
  /// values of stored_parameters(). Ordered, and NaN nowhere (what is not there is infinite).
  using CaseKey = std::pair<std::string, std::vector<double>>;
  CaseKey key_of(const Case &input);

  /// "E = 10 GPa, nu = 0.1, phi = 20°, sigma_c = 5 MPa, R = 100 mm, F_max = 100 N", and what else
  /// is not at its default.
  std::string label(const Case &input);
} // namespace dpcontact

#endif
