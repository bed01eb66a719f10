#ifndef DPCONTACT_FITTING_POWER_LAW_H
#define DPCONTACT_FITTING_POWER_LAW_H

#include "fitting/fit_report.h"
#include "fitting/least_squares.h"

#include <array>
#include <limits>
#include <vector>

namespace dpcontact
{
  /// y = c (x − x₀)^p above x₀, 0 below it (the bodies are apart).
  struct PowerLaw
  {
    double coefficient = std::numeric_limits<double>::quiet_NaN(); ///< c
    double exponent    = std::numeric_limits<double>::quiet_NaN(); ///< p
    double origin      = 0;                                        ///< x₀

    /// y at x.
    double operator()(double x) const;
  };

  /// A fitted power law. The points are samples of one smooth curve: the standard errors tell how
  /// badly the form fits them, not how uncertain they are.
  struct PowerLawFit
  {
    PowerLaw law;
    PowerLaw standard_error; ///< of each coefficient; 0 for an origin that was not fitted
    /// Order: coefficient, exponent, origin (zeros where the origin was not fitted).
    std::array<std::array<double, 3>, 3> covariance{};
    FitReport                            report;
  };

  /// What a fit does with x₀.
  enum class Origin
  {
    fixed, ///< x₀ as given
    free   ///< x₀ is a third parameter, and the search starts from the given one
  };

  /// Fits y = c (x − x₀)^p by unweighted least squares. The search works on x and y over their
  /// largest values, so that their units do not matter.
  /// @param x, y as many abscissae as ordinates
  /// @param origin x₀, or where its search starts
  /// @throws InputError unless x increases strictly from above x₀, y is finite with a positive
  /// maximum, and there are more points than parameters.
  PowerLawFit fit_power_law(const std::vector<double> &x,
                            const std::vector<double> &y,
                            double                     origin  = 0,
                            Origin                     policy  = Origin::fixed,
                            const LeastSquaresOptions &options = {});

  /// How much fit_through_peak() weighs the error of the origin, in shares of the peak approach,
  /// against that of the force, in shares of the peak force. With 0.5 both errors are 0.17 % (root
  /// mean square; 0.40 and 0.51 % at most) on the curves of runs/studies/held_out_third.json.
  /// Weight 0 leaves 0.13 % of the force and 0.58 % of the origin, weight 1 leaves 0.20 and 0.08 %.
  /// The curve's own origin, with the law moved to the peak afterwards, leaves 0.36
  /// (0.97) and 0.13 % (`ctest -R fitting`).
  constexpr double origin_weight = 0.5;

  /// The power law by which a contact law unloads: y = y_n ((x − x₀)/(x_n − x₀))^p, which passes
  /// through the last point, the peak. It minimises the mean square of (law − y)/y_n plus the
  /// square of weight · x₀/peak_approach over x₀ and p.
  /// @param x distance from the curve's own origin, ascending
  /// @param y force, as many
  /// @param peak_approach of the last point from where loading began, in the unit of x
  /// @throws InputError as fit_power_law(); SolverError where it does not converge.
  PowerLaw fit_through_peak(const std::vector<double> &x,
                            const std::vector<double> &y,
                            double                     peak_approach,
                            double                     weight  = origin_weight,
                            const LeastSquaresOptions &options = {});

  /// The largest |first − second| over 0 ≤ x ≤ x_max, divided by `scale`, which is the peak force
  /// in the laws' unit. It is found in closed form where both laws share their origin, otherwise
  /// from 4096 samples that are refined round the largest.
  double law_difference(const PowerLaw &first, const PowerLaw &second, double x_max, double scale);
} // namespace dpcontact

#endif
