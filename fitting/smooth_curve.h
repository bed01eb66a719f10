#ifndef DPCONTACT_FITTING_SMOOTH_CURVE_H
#define DPCONTACT_FITTING_SMOOTH_CURVE_H

#include <memory>
#include <vector>

namespace dpcontact
{
  /// A cubic spline with given knots through many points, in the sense of least squares (GSL's
  /// B-splines). What scatters between the knots is averaged away.
  class SmoothCurve
  {
  public:
    /// @param knots ascending, at least two; the curve lives between the first and the last.
    /// @throws InputError for fewer than 4 knots, knots that do not ascend, or fewer points between
    /// them than the spline has coefficients.
    SmoothCurve(const std::vector<double> &knots,
                const std::vector<double> &x,
                const std::vector<double> &y);

    /// Constant beyond the ends.
    double operator()(double x) const;

    /// Root mean square distance of the points within [low, high] from the curve; 0 without points.
    double scatter(double low, double high) const;

  private:
    struct Basis;
    std::shared_ptr<Basis> basis;
    std::vector<double>    coefficients;
    std::vector<double>    positions, residuals;
  };
} // namespace dpcontact

#endif
