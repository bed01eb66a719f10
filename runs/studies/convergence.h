#ifndef DPCONTACT_RUNS_STUDIES_CONVERGENCE_H
#define DPCONTACT_RUNS_STUDIES_CONVERGENCE_H

#include "database/rows/error_parts.h"
#include "solver/path/solution.h"
#include "solver/problem/case.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace dpcontact
{
  /// One source of error, varied on its own.
  struct ErrorStudy
  {
    struct Level
    {
      std::string           label;
      std::array<double, 4> values; ///< a, b, m, n; of finite_radius: change against the half-space
    };

    std::string        source;
    std::string        varied; ///< what the labels are
    std::vector<Level> levels; ///< coarse, as asked for, fine
    std::array<double, 4>
      order; ///< observed, ln₂ of the ratio of successive changes; NaN where it is not clean
    std::array<double, 4> limit; ///< Richardson's, or the finest where the order is not clean
    std::array<double, 4> error; ///< of the level asked for, absolute
  };

  struct Convergence
  {
    Solution                solution; ///< as asked for
    std::array<double, 4>   values;   ///< its a, b, m, n
    CoefficientErrors       estimate; ///< what solve states for it
    CoefficientErrors       studied;
    std::vector<ErrorStudy> studies;
  };

  /// Limit of three values of successively halved steps, and the order: d₁/d₂ = 2^order with the
  /// changes d₁, d₂. Clean where both have one sign and 2^0.5 ≤ d₁/d₂ ≤ 2^4; elsewhere the limit is
  /// the last value and the order NaN.
  std::pair<double, double> richardson(double coarse, double middle, double fine);

  /// Varies each source for one material, everything else kept: mesh (resolution N/2, N, 2N), load
  /// step (half, all, twice of the steps that step_tolerance needed), contact (stiffness ε/10, ε,
  /// 10 ε), far field (L/2, L, 2L), and finite radius (the true sphere at a/R times 1, 2, 4, its
  /// remote compliance taken out, against the half-space of the same domain, the change fitted by
  /// k₁ κ + k₂ κ²; coarser mesh). Contact and far field are varied with few steps, which they do
  /// not depend on.
  /// Of a scene solved in closed form nothing is varied, and its finite radius stays NaN.
  /// @param log is told what is computed next.
  /// @throws SolverError, InputError as solve_contact(), with the source named.
  Convergence study_convergence(const Case                                     &input,
                                const SolverOptions                            &options,
                                const std::function<void(const std::string &)> &log);
} // namespace dpcontact

#endif
