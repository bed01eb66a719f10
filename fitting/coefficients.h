#ifndef DPCONTACT_FITTING_COEFFICIENTS_H
#define DPCONTACT_FITTING_COEFFICIENTS_H

#include <array>
#include <cstddef>
#include <limits>

namespace dpcontact
{
  /// The names of the four coefficients: F/F_y = a (δ/δ_y)^b in loading (eq 16), and
  /// F/F_y = m ((δ − δ_res)/δ_y)^n in unloading (eq 17).
  constexpr std::array<const char *, 4> coefficient_names{"a", "b", "m", "n"};

  /// A number for each of the four coefficients: their values, their errors, their changes.
  struct Coefficients
  {
    static constexpr double unset = std::numeric_limits<double>::quiet_NaN();

    double a = unset, b = unset, m = unset, n = unset;

    double       &operator[](const std::size_t i) { return this->*members[i]; }
    const double &operator[](const std::size_t i) const { return this->*members[i]; }

    static Coefficients from(const std::array<double, 4> &values)
    {
      return {values[0], values[1], values[2], values[3]};
    }

  private:
    static const std::array<double Coefficients::*, 4> members; ///< in the order of the names
  };

  inline constexpr std::array<double Coefficients::*, 4> Coefficients::members{&Coefficients::a,
                                                                               &Coefficients::b,
                                                                               &Coefficients::m,
                                                                               &Coefficients::n};
} // namespace dpcontact

#endif
