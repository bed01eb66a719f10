#ifndef DPCONTACT_FITTING_SMOOTH_CURVE_H
#define DPCONTACT_FITTING_SMOOTH_CURVE_H

#include <memory>
#include <vector>

namespace dpcontact
{
  /// A cubic spline with given knots that is fitted to many points by least squares (GSL's
  /// B-splines). Scatter that is finer than the knots is averaged away.
  class SmoothCurve
  {
  public:
    /// @param knots ascending, at least four; the curve lives between the first and the last, and
    /// points beyond them are left out
    /// @param x, y as many abscissae as ordinates
    /// @throws InputError for fewer than 4 knots, knots that do not ascend, or fewer points between
    /// them than the spline has coefficients.
    SmoothCurve(const std::vector<double> &knots,
                const std::vector<double> &x,
                const std::vector<double> &y);

    /// y at x. Beyond the first and last knots it is the value there.
    double operator()(double x) const;

    /// The root mean square distance in y of the points with low ≤ x ≤ high from the curve, 0 where
    /// there are none.
    double scatter(double low, double high) const;

  private:
    struct Basis;
    std::shared_ptr<Basis> basis;
    std::vector<double>    coefficients;
    std::vector<double>    positions, residuals;
  };
} // namespace dpcontact

#endif
