#ifndef DPCONTACT_FITTING_ALTERNATIVES_H
#define DPCONTACT_FITTING_ALTERNATIVES_H

#include "fitting/fit_report.h"
#include "meshing/enum_names.h"

#include <vector>

namespace dpcontact
{
  /// The forms of which Wang et al. (2018, section 4.1) say that the power law fits better. They
  /// name "exponential, polynomial, and parabola relationships" without formulas. These are read
  /// here as Matlab's library models exp1, poly2 and poly3 (with intercept), and as the parabola
  /// whose vertex is the origin.
  enum class Form
  {
    exponential, ///< y = c₀ exp(c₁ x)
    quadratic,   ///< y = c₀ + c₁ x + c₂ x²
    cubic,       ///< y = c₀ + c₁ x + c₂ x² + c₃ x³
    parabola     ///< y = c₀ x²
  };

  template <>
  struct EnumNames<Form>
  {
    static constexpr const char    *what     = "form";
    static constexpr EnumName<Form> values[] = {{Form::exponential, "exponential"},
                                                {Form::quadratic, "quadratic"},
                                                {Form::cubic, "cubic"},
                                                {Form::parabola, "parabola"}};
  };

  struct AlternativeFit
  {
    Form                form = Form::exponential;
    std::vector<double> coefficients;    ///< c₀, c₁, … in the units of x and y
    std::vector<double> standard_errors; ///< of the coefficients, meant as in PowerLawFit
    FitReport           report;

    /// y at x.
    double operator()(double x) const;
  };

  /// Fits one form by unweighted least squares.
  /// @param x, y as many abscissae as ordinates; their last values set the scales of the search
  /// @throws InputError unless x and y are finite, equally long and positive at their ends, and
  /// there are more points than coefficients.
  AlternativeFit fit_alternative(Form                       form,
                                 const std::vector<double> &x,
                                 const std::vector<double> &y,
                                 const LeastSquaresOptions &options = {});

  /// Fits all forms, in the order of `Form`, to the same points. @throws as fit_alternative().
  std::vector<AlternativeFit> fit_alternatives(const std::vector<double> &x,
                                               const std::vector<double> &y,
                                               const LeastSquaresOptions &options = {});
} // namespace dpcontact

#endif
