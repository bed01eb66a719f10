#ifndef DPCONTACT_TESTS_SUPPORT_CURVES_H
#define DPCONTACT_TESTS_SUPPORT_CURVES_H

#include "solver/problem/curve.h"

#include <cmath>
#include <functional>

namespace dpcontact::test_curves
{
  inline CurvePoint point(const double approach, const double force)
  {
    CurvePoint result;
    result.approach = approach;
    result.force    = force;
    return result;
  }

  /// A curve sampled from two analytic branches: F(δ) and U(δ − δ_res) with F(δ_max) = U(δ_max −
  /// δ_res). Points at s = (i/n)^grading of either range; grading 1 is uniform.
  inline Curve sample(const std::function<double(double)> &loading,
                      const std::function<double(double)> &unloading,
                      const double                         approach_max,
                      const double                         residual,
                      const unsigned int                   n,
                      const double                         grading = 1)
  {
    Curve curve;
    for (unsigned int i = 0; i <= n; ++i)
      {
        const double x = approach_max * std::pow(static_cast<double>(i) / n, grading);
        curve.loading.push_back(point(x, i == 0 ? 0 : loading(x)));
      }
    curve.unloading.push_back(curve.loading.back());
    for (unsigned int i = n - 1; i > 0; --i)
      {
        const double x = (approach_max - residual) * std::pow(static_cast<double>(i) / n, grading);
        curve.unloading.push_back(point(residual + x, unloading(x)));
      }
    curve.unloading.push_back(point(residual, 0));
    return curve;
  }

  /// Power laws on both branches, in units of F_y and δ_y; m follows from the shared peak.
  struct PowerLaws
  {
    double force_yield    = 9.056;
    double approach_yield = 3.2792e-6;
    double a = 1, b = 1.5, n = 1.5;
    double approach_max_ratio = 5; ///< δ_max/δ_y
    double residual_ratio     = 0; ///< δ_res/δ_y

    double m() const
    {
      return a * std::pow(approach_max_ratio, b) / std::pow(approach_max_ratio - residual_ratio, n);
    }

    Curve curve(const unsigned int n_steps, const double grading = 1) const
    {
      return sample(
        [this](const double x) { return force_yield * a * std::pow(x / approach_yield, b); },
        [this](const double x) { return force_yield * m() * std::pow(x / approach_yield, n); },
        approach_max_ratio * approach_yield,
        residual_ratio * approach_yield,
        n_steps,
        grading);
    }
  };
} // namespace dpcontact::test_curves

#endif
