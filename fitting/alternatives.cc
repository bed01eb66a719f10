#include "fitting/alternatives.h"

#include "meshing/errors.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace dpcontact
{
  namespace
  {
    /// Exponents of the monomials of a form that is linear in its coefficients.
    std::vector<int> monomials(const Form form)
    {
      switch (form)
        {
          case Form::quadratic:
            return {0, 1, 2};
          case Form::cubic:
            return {0, 1, 2, 3};
          case Form::parabola:
            return {2};
          case Form::exponential:
            break;
        }
      return {};
    }

    /// Value of the form and, unless nullptr, its derivatives by the coefficients.
    double
    evaluate(const Form form, const std::vector<double> &c, const double x, double *derivatives)
    {
      if (form == Form::exponential)
        {
          const double growth = std::exp(c[1] * x);
          if (derivatives)
            {
              derivatives[0] = growth;
              derivatives[1] = c[0] * x * growth;
            }
          return c[0] * growth;
        }
      double                 value  = 0;
      const std::vector<int> powers = monomials(form);
      for (std::size_t j = 0; j < powers.size(); ++j)
        {
          const double term = std::pow(x, powers[j]);
          value += c[j] * term;
          if (derivatives)
            derivatives[j] = term;
        }
      return value;
    }

    /// Start of the search on points scaled to [0, 1]: an exponential through half of the range.
    std::vector<double> starting_values(const Form form)
    {
      if (form == Form::exponential)
        return {0.1, 2.3};
      return std::vector<double>(monomials(form).size(), 0.);
    }

    void check_points(const Form                 form,
                      const std::vector<double> &x,
                      const std::vector<double> &y,
                      const std::size_t          n_coefficients)
    {
      const std::string where  = std::string("fit of the ") + to_string(form) + " form: ";
      const auto        finite = [](const double v) { return std::isfinite(v); };
      if (x.size() != y.size() || x.size() <= n_coefficients)
        throw InputError(where + std::to_string(x.size()) + " abscissae and " +
                         std::to_string(y.size()) + " ordinates for " +
                         std::to_string(n_coefficients) + " coefficients");
      if (!std::all_of(x.begin(), x.end(), finite) || !std::all_of(y.begin(), y.end(), finite))
        throw InputError(where + "a point is not finite");
      if (!(x.back() > 0 && y.back() > 0))
        throw InputError(where + "the last point must be positive");
    }
  } // namespace

  double AlternativeFit::operator()(const double x) const
  {
    return evaluate(form, coefficients, x, nullptr);
  }

  AlternativeFit fit_alternative(const Form                 form,
                                 const std::vector<double> &x,
                                 const std::vector<double> &y,
                                 const LeastSquaresOptions &options)
  {
    LeastSquaresProblem problem;
    problem.start = starting_values(form);
    check_points(form, x, y, problem.start.size());

    const double x_scale = x.back(), y_scale = y.back();
    const auto   k      = problem.start.size();
    problem.n_residuals = x.size();
    problem.observation_norm =
      std::sqrt(std::inner_product(y.begin(), y.end(), y.begin(), 0.)) / y_scale;
    problem.evaluate = [&](const auto &c, auto &residuals, auto *jacobian) {
      if (form == Form::exponential && c[1] > 500) // exp() would overflow
        return false;
      for (std::size_t i = 0; i < x.size(); ++i)
        residuals[i] =
          evaluate(form, c, x[i] / x_scale, jacobian ? jacobian->data() + i * k : nullptr) -
          y[i] / y_scale;
      return true;
    };
    const LeastSquaresSummary summary = levenberg_marquardt(problem, options);

    AlternativeFit fit;
    fit.form                      = form;
    const std::vector<int> powers = monomials(form);
    for (std::size_t j = 0; j < k; ++j)
      {
        double unit = y_scale;
        if (form == Form::exponential)
          unit = j == 0 ? y_scale : 1 / x_scale;
        else
          unit = y_scale * std::pow(x_scale, -powers[j]);
        fit.coefficients.push_back(unit * summary.parameters[j]);
        fit.standard_errors.push_back(unit * summary.standard_errors[j]);
      }
    std::vector<double> predictions(x.size());
    std::transform(x.begin(), x.end(), predictions.begin(), fit);
    fit.report = fit_report(summary, y, predictions);
    return fit;
  }

  std::vector<AlternativeFit> fit_alternatives(const std::vector<double> &x,
                                               const std::vector<double> &y,
                                               const LeastSquaresOptions &options)
  {
    std::vector<AlternativeFit> fits;
    for (const Form form : {Form::exponential, Form::quadratic, Form::cubic, Form::parabola})
      fits.push_back(fit_alternative(form, x, y, options));
    return fits;
  }
} // namespace dpcontact
