#ifndef DPCONTACT_FITTING_CONVENTIONS_H
#define DPCONTACT_FITTING_CONVENTIONS_H

#include <cmath>

namespace dpcontact
{
  // A power law F/F_y = c (δ/δ_y)^p with the mutual approaches δ and δ_y is in the consistent
  // convention. The published one (Wang et al. 2018) divides the same mutual δ by the δ_y of one
  // sphere, which is half of the mutual one: c (δ/δ_y)^p = c 2^(−p) (δ/(δ_y/2))^p. The exponent is
  // the same in both. Loading has c = a and p = b, unloading c = m and p = n.

  /// c 2^(−p): the published coefficient of a consistent one.
  inline double published_coefficient(const double consistent, const double exponent)
  {
    return consistent * std::pow(2, -exponent);
  }

  /// c 2^p: the consistent coefficient of a published one.
  inline double consistent_coefficient(const double published, const double exponent)
  {
    return published * std::exp2(exponent);
  }

  /// δ_y of one sphere from the mutual one, in the same unit.
  inline double published_approach_yield(const double mutual) { return mutual / 2; }

  /// The uncertainty of a coefficient that was converted either way, to first order, with errors of
  /// coefficient and exponent that are independent of each other:
  /// |c'| √(ε_c² + (ln 2 · u_p)²), in the unit of c'.
  /// @param converted c', the coefficient after the conversion
  /// @param relative_uncertainty ε_c, of the coefficient before it, over that coefficient
  /// @param exponent_uncertainty u_p, of the exponent
  inline double converted_uncertainty(const double converted,
                                      const double relative_uncertainty,
                                      const double exponent_uncertainty)
  {
    return std::abs(converted) *
           std::hypot(relative_uncertainty, std::log(2.) * exponent_uncertainty);
  }

  /// The standard error of a published coefficient from the covariance of the consistent one and
  /// its exponent, to first order.
  /// @param consistent c
  /// @param exponent p
  /// @param variance of c
  /// @param covariance of c and p
  /// @param exponent_variance of p
  inline double published_standard_error(const double consistent,
                                         const double exponent,
                                         const double variance,
                                         const double covariance,
                                         const double exponent_variance)
  {
    const double by_coefficient = std::pow(2, -exponent);
    const double by_exponent    = -std::log(2) * consistent * by_coefficient;
    const double total          = by_coefficient * by_coefficient * variance +
                         2 * by_coefficient * by_exponent * covariance +
                         by_exponent * by_exponent * exponent_variance;
    return total < 0 ? 0 : std::sqrt(total); // below zero by rounding only
  }
} // namespace dpcontact

#endif
