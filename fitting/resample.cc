#include "fitting/resample.h"

#include "meshing/errors.h"
#include "meshing/number_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

// Boost 1.74's pchip.hpp calls isnan without declaring it: fpclassify.hpp must stand before it.
// clang-format off
#include <boost/math/special_functions/fpclassify.hpp>
#include <boost/math/interpolators/pchip.hpp>
// clang-format on

namespace dpcontact
{
  namespace
  {
    /// Ends of a branch count as zero, and peaks as equal, within this part of the peak.
    constexpr double end_tolerance = 1e-6;
    /// A released contact may seem this part of the peak approach longer than before: rounding and
    /// discretisation of an elastic scene.
    constexpr double      negative_residual_tolerance = 1e-3;
    constexpr std::size_t min_points                  = 5;

    [[noreturn]] void refuse(const Branch branch, const std::string &what)
    {
      throw InputError(std::string("curve, ") + to_string(branch) + " branch: " + what);
    }

    std::string show(const CurvePoint &point)
    {
      return "(approach " + number_text(point.approach) + " m, force " + number_text(point.force) +
             " N)";
    }

    /// The branch's points in the order of growing force, found strictly monotone.
    std::vector<CurvePoint> checked_points(const Curve &curve, const Branch branch)
    {
      std::vector<CurvePoint> points = branch == Branch::loading ? curve.loading : curve.unloading;
      if (points.size() < min_points)
        refuse(branch,
               std::to_string(points.size()) + " points are too few; at least " +
                 std::to_string(min_points) + " are needed");
      for (std::size_t i = 0; i < points.size(); ++i)
        if (!std::isfinite(points[i].approach) || !std::isfinite(points[i].force))
          refuse(branch, "point " + std::to_string(i) + " " + show(points[i]) + " is not finite");

      const double sign = branch == Branch::loading ? 1 : -1;
      for (std::size_t i = 1; i < points.size(); ++i)
        if (!(sign * (points[i].approach - points[i - 1].approach) > 0) ||
            !(sign * (points[i].force - points[i - 1].force) > 0))
          refuse(branch,
                 std::string("approach and force must both ") +
                   (branch == Branch::loading ? "increase" : "decrease") + " from point " +
                   std::to_string(i - 1) + " " + show(points[i - 1]) + " to point " +
                   std::to_string(i) + " " + show(points[i]));
      if (branch == Branch::unloading)
        std::reverse(points.begin(), points.end());
      return points;
    }

    bool close(const double a, const double b, const double scale)
    {
      return std::fabs(a - b) <= end_tolerance * scale;
    }

    /// Slope at an end from the two nearest intervals; same sign as the data's, at most twice it.
    double end_slope(const double h0, const double h1, const double secant0, const double secant1)
    {
      return std::max(0., ((2 * h0 + h1) * secant0 - h0 * secant1) / (h0 + h1));
    }

    std::function<double(double)> monotone_cubic(std::vector<double> x, std::vector<double> y)
    {
      const std::size_t n      = x.size();
      const auto        step   = [&](const std::size_t k) { return x[k + 1] - x[k]; };
      const auto        secant = [&](const std::size_t k) { return (y[k + 1] - y[k]) / step(k); };
      const double      left   = end_slope(step(0), step(1), secant(0), secant(1));
      const double      right  = end_slope(step(n - 2), step(n - 3), secant(n - 2), secant(n - 3));
      return boost::math::interpolators::pchip<std::vector<double>>(
        std::move(x), std::move(y), left, right);
    }
  } // namespace

  BranchInterpolant::BranchInterpolant(const Curve &curve, const Branch branch)
  {
    const std::vector<CurvePoint> points = checked_points(curve, branch);
    const CurvePoint             &peak = points.back(), &zero = points.front();
    if (branch == Branch::loading)
      {
        if (!close(zero.approach, 0, peak.approach) || !close(zero.force, 0, peak.force))
          refuse(branch, "it begins at " + show(zero) + " and must begin at (0, 0)");
      }
    else
      {
        if (!close(zero.force, 0, peak.force))
          refuse(branch, "it ends at " + show(zero) + " and must end at separation, force 0");
        if (zero.approach < -negative_residual_tolerance * peak.approach)
          refuse(branch, "its residual approach is negative, " + show(zero));
        if (curve.loading.empty() ||
            !close(curve.loading.back().approach, peak.approach, peak.approach) ||
            !close(curve.loading.back().force, peak.force, peak.force))
          refuse(branch, "it begins at " + show(peak) + ", which is not the end of loading");
      }

    approach_at_zero_x = branch == Branch::loading ? 0 : zero.approach;
    largest_x          = peak.approach - approach_at_zero_x;
    largest_force      = peak.force;
    std::vector<double> x(points.size()), y(points.size());
    for (std::size_t i = 1; i < points.size(); ++i)
      {
        x[i] = (points[i].approach - approach_at_zero_x) / largest_x;
        y[i] = std::pow(points[i].force / largest_force, 2. / 3.);
      }
    x.front() = y.front() = 0;
    x.back() = y.back() = 1;
    power_of_force      = monotone_cubic(std::move(x), std::move(y));
  }

  double BranchInterpolant::force_at(const double x) const
  {
    if (!(x >= 0 && x <= largest_x))
      throw InputError("force at x = " + number_text(x) + " m: outside the branch, 0 to " +
                       number_text(largest_x) + " m");
    return largest_force * std::pow(std::max(power_of_force(std::min(x / largest_x, 1.)), 0.), 1.5);
  }

  double BranchInterpolant::x_at(const double force) const
  {
    if (!(force >= 0 && force <= largest_force))
      throw InputError("approach at force " + number_text(force) + " N: outside the branch, 0 to " +
                       number_text(largest_force) + " N");
    const double target = std::pow(force / largest_force, 2. / 3.);
    if (target <= 0 || target >= 1)
      return target <= 0 ? 0 : largest_x;
    double low = 0, high = 1;
    while (high - low > 1e-15)
      {
        const double middle                            = (low + high) / 2;
        (power_of_force(middle) < target ? low : high) = middle;
      }
    return largest_x * (low + high) / 2;
  }

  ResampledBranch resample(const Curve &curve, const Branch branch, const unsigned int n_points)
  {
    if (n_points < 4)
      throw InputError("resampling a curve needs at least 4 points, not " +
                       std::to_string(n_points));
    const BranchInterpolant interpolant(curve, branch);
    ResampledBranch         result;
    result.origin = interpolant.origin();
    for (unsigned int i = 1; i <= n_points; ++i)
      {
        result.x.push_back(i == n_points ? interpolant.x_max()
                                         : i * interpolant.x_max() / n_points);
        result.force.push_back(interpolant.force_at(result.x.back()));
      }
    return result;
  }
} // namespace dpcontact
