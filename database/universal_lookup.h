#ifndef DPCONTACT_DATABASE_UNIVERSAL_LOOKUP_H
#define DPCONTACT_DATABASE_UNIVERSAL_LOOKUP_H

#include "database/universal_table.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace dpcontact
{
  /// Whether a lookup may leave the box of its data.
  enum class Outside
  {
    refuse,
    extrapolate
  };

  /// @throws InputError naming the axis and its range where the value lies outside and must not.
  void check_range(const std::string &axis, double value, double low, double high, Outside outside);

  /// What the universal table says about one load level.
  struct UniversalValue
  {
    double                approach;          ///< δ/δ_y at F = Λ F_y
    double                residual_approach; ///< δ_res/δ_y after release, as computed
    double                residual_eq18;  ///< that which eq (18) gives from the approach, m and n
    std::array<double, 4> coefficients;   ///< a, b, m, n of the consistent pair
    std::array<double, 4> numerical;      ///< error of each that the computation left
    std::array<double, 4> interpolation;  ///< that interpolation adds
    std::array<double, 4> misfit;         ///< of the power laws
    double                approach_error; ///< of ln(approach): numerical and interpolation
    double                residual_error; ///< of residual_approach, likewise, in δ_y
  };

  /// The universal table at one ν and φ, interpolated over them as the contact law does
  /// (contact_law.h: the polynomial through the Chebyshev–Lobatto points of ν, a cubic spline over
  /// φ), by cubic splines over ln Λ. Interpolated are smooth logarithms of ratios: of approach and
  /// recovered approach to Hertz's, of either power law to the peak, and b and n. Below first yield
  /// everything is Hertz's in closed form.
  ///
  /// The error of interpolation is read off the table: how far a lower order is from the value,
  /// along ν the polynomial through every second node, along φ the cubic through four nodes, along
  /// ln Λ what four levels make of the one between them, which shows how the nodes scatter as well.
  /// Of these and of the numerical errors that the nodes state, shares count that were calibrated
  /// on materials that are not in the table, and verified on others (runs/held_out).
  class UniversalFamily
  {
  public:
    /// @throws InputError naming nu or phi and its range where they lie outside, or below 0, ν ≥ 0.5.
    UniversalFamily(const UniversalTable &table,
                    double                nu,
                    double                phi_deg,
                    Outside               outside = Outside::refuse);

    /// @throws InputError naming the load level and its range where it lies above.
    UniversalValue at(double load_level, Outside outside = Outside::refuse) const;

    /// δ/δ_y of the virgin loading curve at F = Λ F_y, as at().
    double approach(double load_level, Outside outside = Outside::refuse) const;

    double onset() const { return onset_level; } ///< load level of first yield, on axis or ring
    double highest() const { return levels.back(); }

  private:
    double                                     onset_level;
    std::vector<double>                        levels; ///< Λ
    std::vector<std::function<double(double)>> smooth; ///< over ln Λ
    /// Over ln Λ, linear: the stated errors of ln a, b, ln m, n, ln(approach) and of the residual
    /// over the peak approach; and the misfit of a, b, m, n.
    std::vector<std::function<double(double)>> interpolation, numerical, misfit;
  };
} // namespace dpcontact

#endif
