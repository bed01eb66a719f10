#ifndef DPCONTACT_DATABASE_TABLES_UNIVERSAL_LOOKUP_H
#define DPCONTACT_DATABASE_TABLES_UNIVERSAL_LOOKUP_H

#include "database/tables/universal_table.h"
#include "database/tables/universal_uncertainty.h"

#include <array>
#include <functional>
#include <string>
#include <utility>
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
    double approach;          ///< δ/δ_y at F = Λ F_y
    double residual_approach; ///< δ_res/δ_y after release, as computed
    double residual_eq18;     ///< δ_res/δ_y by eq (18) from the approach, m and n
    double residual_of_law;   ///< δ_res/δ_y of the contact law's unloading, by m_law and n_law
    double law_exponent;      ///< n_law
    std::array<double, 4>        coefficients;  ///< a, b, m, n of the consistent pair
    std::array<double, 4>        numerical;     ///< error of each that the computation left
    std::array<double, 4>        interpolation; ///< error of each that interpolation adds
    std::array<double, 4>        misfit; ///< how badly the power laws describe the curve, in each
    double                       approach_error; ///< of ln(approach): numerical and interpolation
    double                       residual_error; ///< of residual_approach, the same, in δ_y
    std::array<Outcome, n_parts> parts;          ///< what these errors are shares of
  };

  /// The universal table at one ν and φ, interpolated over them as the contact law does
  /// (contact_law.h: the polynomial through the Chebyshev–Lobatto points of ν, a cubic spline over
  /// φ), and by cubic splines over ln Λ. What is interpolated is smooth: the logarithms of approach
  /// and recovered approach over Hertz's and of either power law's force over the peak's, and b and
  /// n. Below first yield everything is Hertz's solution in closed form.
  ///
  /// The errors are read off the table (UncertaintyPart): along each axis how far the nodes around
  /// are from what their neighbours make of them, which shows how coarse the grid is and how they
  /// scatter; and the numerical errors that they state. The stated uncertainty is made of shares of
  /// these, which runs/studies/calibrate found for materials that are not in the table; other
  /// materials verify them (runs/studies/held_out). Outside the table's box they say nothing.
  class UniversalFamily
  {
  public:
    /// @throws InputError naming nu or phi and its range where they lie outside, or below 0, ν ≥ 0.5.
    UniversalFamily(const UniversalTable &table,
                    double                nu,
                    double                phi_deg,
                    Outside               outside = Outside::refuse);

    /// Everything at one load level Λ.
    /// @throws InputError naming the load level and its range where it lies above.
    UniversalValue at(double load_level, Outside outside = Outside::refuse) const;

    /// δ/δ_y of the virgin loading curve at F = Λ F_y. @throws InputError as at() does.
    double approach(double load_level, Outside outside = Outside::refuse) const;

    double onset() const { return onset_level; }     ///< load level of first yield, on axis or ring
    double highest() const { return levels.back(); } ///< largest load level of the table

  private:
    /// δ_res/δ_y at ln Λ = x: the largest of all levels up to there, since more load leaves no
    /// smaller residual (two splines, whose difference is small at first yield, may say so).
    double residual_up_to(double x) const;
    double residual_of_splines(double x) const;
    /// Finds where it turns round, between the levels ln Λ and at them.
    void find_crests(const std::vector<double> &x);

    double                                     onset_level;
    std::vector<double>                        levels; ///< Λ
    std::vector<std::function<double(double)>> smooth; ///< over ln Λ
    std::vector<std::pair<double, double>>     crests; ///< ln Λ and δ_res/δ_y
    double                                     phi_deg;
    /// Over ln Λ, linear: the misfit of a, b, m, n; every part of the uncertainty of every outcome.
    std::vector<std::function<double(double)>>                                 misfit;
    std::array<std::array<std::function<double(double)>, n_outcomes>, n_parts> parts;
  };
} // namespace dpcontact

#endif
