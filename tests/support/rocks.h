#ifndef DPCONTACT_TESTS_SUPPORT_ROCKS_H
#define DPCONTACT_TESTS_SUPPORT_ROCKS_H

#include "fitting/curve_fit.h"
#include "solver/path/solution.h"
#include "solver/path/solve.h"

#include <cmath>

namespace dpcontact::tests
{
  /// A material from the units people speak: GPa, degrees, MPa.
  inline Material
  rock(const double E_GPa, const double nu, const double phi_deg, const double sigma_c_MPa)
  {
    return {1e9 * E_GPa, nu, Angle(phi_deg), 1e6 * sigma_c_MPa};
  }

  /// A solved scene with its fit and its approaches in units of δ_y.
  struct Solved
  {
    Solution solution;
    CurveFit fit;

    Solved(const Material &material, const Scene &scene, const SolverOptions &options = {})
      : solution(solve_contact(material, scene, options))
      , fit(fit_curve(solution.curve, solution.yield.force, solution.yield.approach))
    {}

    double a() const { return fit.loading.fit.law.coefficient; }
    double b() const { return fit.loading.fit.law.exponent; }
    double m() const { return fit.unloading.fit.law.coefficient; }
    double n() const { return fit.unloading.fit.law.exponent; }
    double peak_approach() const
    {
      return solution.curve.loading.back().approach / solution.yield.approach;
    }
    double residual_approach() const
    {
      return solution.curve.residual_approach() / solution.yield.approach;
    }
  };
} // namespace dpcontact::tests

#endif
