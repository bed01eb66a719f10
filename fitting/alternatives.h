#ifndef DPCONTACT_FITTING_ALTERNATIVES_H
#define DPCONTACT_FITTING_ALTERNATIVES_H

#include "fitting/fit_report.h"

#include <vector>

namespace dpcontact
{
  /// The forms that Wang et al. (2018, section 4.1) say the power law beats. They name "exponential,
  /// polynomial, and parabola relationships" without formulas; read here as Matlab's library models
  /// exp1, poly2 and poly3 (with intercept), and as the parabola whose vertex is the origin.
  enum class Form
  {
    exponential, ///< y = c₀ exp(c₁ x)
    quadratic,   ///< y = c₀ + c₁ x + c₂ x²
    cubic,       ///< y = c₀ + c₁ x + c₂ x² + c₃ x³
    parabola     ///< y = c₀ x²
  };

  const char *name(Form form);

  struct AlternativeFit
  {
    Form                form = Form::exponential;
    std::vector<double> coefficients;    ///< c₀, c₁, … for y over x as given
    std::vector<double> standard_errors; ///< misfit over the points, as in PowerLawFit
    FitReport           report;

    double operator()(double x) const;
  };

  /// Fits one form by unweighted least squares.
  /// @throws InputError unless x and y are finite, equally long and positive at their ends, and
  /// there are more points than coefficients.
  AlternativeFit fit_alternative(Form                       form,
                                 const std::vector<double> &x,
                                 const std::vector<double> &y,
                                 const LeastSquaresOptions &options = {});

  /// All forms, in the order of `Form`.
  std::vector<AlternativeFit> fit_alternatives(const std::vector<double> &x,
                                               const std::vector<double> &y,
                                               const LeastSquaresOptions &options = {});
} // namespace dpcontact

#endif
