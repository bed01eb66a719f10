#include "solver/closed_form/yield_surface.h"

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

namespace dpcontact
{
  namespace
  {
    constexpr double farthest = 1e6; // in units of the scale

    laws::StressTensor diagonal(const std::array<double, 3> &principal)
    {
      laws::StressTensor stress;
      for (unsigned int i = 0; i < 3; ++i)
        stress[i][i] = principal[i];
      return stress;
    }

    std::array<double, 3>
    principal_stresses(const double pressure, const double sqrt_j2, const double lode_angle)
    {
      std::array<double, 3> result;
      for (unsigned int i = 0; i < 3; ++i)
        result[i] =
          -pressure + 2 / std::sqrt(3.) * sqrt_j2 * std::cos(lode_angle - 2 * M_PI * i / 3);
      return result;
    }

    /// The zero of a function that is negative at 0, beyond 0; unset where there is none up to the
    /// end.
    template <class Function>
    std::optional<double> first_zero(const Function &f, const double scale)
    {
      double upper = scale;
      while (f(upper) <= 0)
        if ((upper *= 2) > farthest * scale)
          return std::nullopt;
      std::uintmax_t iterations = 200;
      const auto [low, high]    = boost::math::tools::toms748_solve(
        f, 0., upper, boost::math::tools::eps_tolerance<double>(48), iterations);
      return (low + high) / 2;
    }
  } // namespace

  std::optional<double> tensile_pressure(const laws::Law &law, const double scale)
  {
    const auto zero = first_zero(
      [&](const double tension) {
        return laws::yield_excess(law, diagonal({tension, tension, tension}), 0);
      },
      scale);
    return zero ? std::optional(-*zero) : std::nullopt;
  }

  std::optional<YieldSurfacePoint> surface_point(const laws::Law &law,
                                                 const double     pressure,
                                                 const double     lode_angle,
                                                 const double     scale)
  {
    const auto excess = [&](const double sqrt_j2) {
      return laws::yield_excess(
        law, diagonal(principal_stresses(pressure, sqrt_j2, lode_angle)), 0);
    };
    const double at_axis = excess(0);
    if (at_axis > 1e-12)
      return std::nullopt;
    const auto zero = at_axis < 0 ? first_zero(excess, scale) : std::optional(0.);
    if (!zero)
      return std::nullopt;
    return YieldSurfacePoint{
      lode_angle, pressure, *zero, principal_stresses(pressure, *zero, lode_angle)};
  }
} // namespace dpcontact
