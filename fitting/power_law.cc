#include "fitting/power_law.h"

#include "meshing/errors.h"
#include "meshing/number_text.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace dpcontact
{
  namespace
  {
    void check_points(const std::vector<double> &x,
                      const std::vector<double> &y,
                      const double               origin,
                      const std::size_t          n_parameters)
    {
      if (x.size() != y.size())
        throw InputError("power law: " + std::to_string(x.size()) + " abscissae but " +
                         std::to_string(y.size()) + " ordinates");
      if (x.size() <= n_parameters)
        throw InputError("power law: " + std::to_string(x.size()) + " points are too few for " +
                         std::to_string(n_parameters) + " parameters and their errors");
      for (std::size_t i = 0; i < x.size(); ++i)
        if (!std::isfinite(x[i]) || !std::isfinite(y[i]) || !(x[i] > (i == 0 ? origin : x[i - 1])))
          throw InputError("power law: point " + std::to_string(i) + " (" + number_text(x[i]) +
                           ", " + number_text(y[i]) +
                           ") is not finite, or its abscissa does not increase from the origin " +
                           number_text(origin));
      if (!(*std::max_element(y.begin(), y.end()) > 0))
        throw InputError("power law: no ordinate is positive");
    }

    /// Exponent between the point nearest to half of the span and the last one.
    double first_exponent(const std::vector<double> &x, const std::vector<double> &y)
    {
      const auto half = std::lower_bound(x.begin(), x.end() - 1, 0.5 * x.back());
      const auto i    = static_cast<std::size_t>(half - x.begin());
      if (!(y[i] > 0 && y.back() > y[i] && x.back() > x[i]))
        return 1.5;
      return std::clamp(std::log(y.back() / y[i]) / std::log(x.back() / x[i]), 0.1, 10.);
    }

    /// Residuals and Jacobian of C (X − X₀)^p; X₀ = 0 unless there is a third parameter.
    bool evaluate(const std::vector<double> &X,
                  const std::vector<double> &Y,
                  const std::vector<double> &parameters,
                  std::vector<double>       &residuals,
                  std::vector<double>       *jacobian)
    {
      const std::size_t k = parameters.size();
      const double      C = parameters[0], p = parameters[1], X0 = k > 2 ? parameters[2] : 0;
      if (!(p > 0))
        return false;
      for (std::size_t i = 0; i < X.size(); ++i)
        {
          const double s     = X[i] - X0;
          const double power = s > 0 ? std::pow(s, p) : 0;
          residuals[i]       = C * power - Y[i];
          if (jacobian)
            {
              double *row = jacobian->data() + i * k;
              row[0]      = power;
              row[1]      = s > 0 ? C * power * std::log(s) : 0;
              if (k > 2)
                row[2] = s > 0 ? -C * p * power / s : 0;
            }
        }
      return true;
    }

    /// Back from X = (x − x₀)/span, Y = y/y_scale: c = y_scale C span^(−p), x₀ += span X₀.
    PowerLawFit unscale(const LeastSquaresSummary &summary,
                        const double               origin,
                        const double               span,
                        const double               y_scale)
    {
      PowerLawFit       fit;
      const std::size_t k = summary.parameters.size();
      const double      p = summary.parameters[1];
      // The scale alone, so that C = 0 has a derivative too.
      const double unit   = y_scale * std::pow(span, -p);
      fit.law.coefficient = summary.parameters[0] * unit;
      fit.law.exponent    = p;
      fit.law.origin      = origin + (k > 2 ? span * summary.parameters[2] : 0);

      const double T[3][3] = {
        {unit, -fit.law.coefficient * std::log(span), 0}, {0, 1, 0}, {0, 0, span}};
      for (std::size_t i = 0; i < k; ++i)
        for (std::size_t j = 0; j < k; ++j)
          for (std::size_t a = 0; a < k; ++a)
            for (std::size_t b = 0; b < k; ++b)
              fit.covariance[i][j] += T[i][a] * summary.covariance[a * k + b] * T[j][b];
      fit.standard_error = {std::sqrt(fit.covariance[0][0]),
                            std::sqrt(fit.covariance[1][1]),
                            std::sqrt(fit.covariance[2][2])};
      return fit;
    }
  } // namespace

  double PowerLaw::operator()(const double x) const
  {
    return x > origin ? coefficient * std::pow(x - origin, exponent) : 0;
  }

  PowerLawFit fit_power_law(const std::vector<double> &x,
                            const std::vector<double> &y,
                            const double               origin,
                            const Origin               policy,
                            const LeastSquaresOptions &options)
  {
    const std::size_t n_parameters = policy == Origin::free ? 3 : 2;
    check_points(x, y, origin, n_parameters);
    const double span    = x.back() - origin;
    const double y_scale = *std::max_element(y.begin(), y.end());

    std::vector<double> X(x.size()), Y(y.size());
    for (std::size_t i = 0; i < x.size(); ++i)
      {
        X[i] = (x[i] - origin) / span;
        Y[i] = y[i] / y_scale;
      }
    LeastSquaresProblem problem;
    problem.n_residuals = X.size();
    problem.start       = {Y.back(), first_exponent(X, Y)};
    problem.start.resize(n_parameters, 0.);
    problem.observation_norm = std::sqrt(std::inner_product(Y.begin(), Y.end(), Y.begin(), 0.));
    problem.evaluate = [&](const auto &p, auto &r, auto *J) { return evaluate(X, Y, p, r, J); };
    const LeastSquaresSummary summary = levenberg_marquardt(problem, options);

    PowerLawFit         fit = unscale(summary, origin, span, y_scale);
    std::vector<double> predictions(x.size());
    std::transform(x.begin(), x.end(), predictions.begin(), fit.law);
    fit.report = fit_report(summary, y, predictions);
    return fit;
  }

  PowerLaw fit_through_peak(const std::vector<double> &x,
                            const std::vector<double> &y,
                            const double               peak_approach,
                            const double               weight,
                            const LeastSquaresOptions &options)
  {
    check_points(x, y, 0, 2);
    constexpr double resolved = 1e-3; // just past first yield the residual approach may be below 0
    if (!(peak_approach >= (1 - resolved) * x.back() && std::isfinite(peak_approach)))
      throw InputError("power law through the peak: the approach there is " +
                       number_text(peak_approach) + ", but the branch alone takes " +
                       number_text(x.back()));
    const double        span = x.back(), peak = y.back();
    const std::size_t   n = x.size();
    std::vector<double> X, Y;
    for (std::size_t i = 0; i < n; ++i)
      {
        X.push_back(x[i] / span);
        Y.push_back(y[i] / peak);
      }
    const double        scale = weight * std::sqrt(static_cast<double>(n)) * span / peak_approach;
    LeastSquaresProblem problem;
    problem.n_residuals      = n + 1;
    problem.start            = {0., first_exponent(X, Y)};
    problem.observation_norm = std::sqrt(std::inner_product(Y.begin(), Y.end(), Y.begin(), 0.));
    problem.evaluate         = [&](const auto &parameters, auto &residuals, auto *jacobian) {
      const double X0 = parameters[0], p = parameters[1];
      if (!(X0 < 1 && p > 0))
        return false;
      const auto enter =
        [&](const std::size_t i, const double value, const double by_X0, const double by_p) {
          residuals[i] = value;
          if (jacobian)
            {
              (*jacobian)[2 * i]     = by_X0;
              (*jacobian)[2 * i + 1] = by_p;
            }
        };
      for (std::size_t i = 0; i < n; ++i)
        if (const double s = (X[i] - X0) / (1 - X0); s > 0)
          {
            const double power = std::pow(s, p);
            enter(i,
                  power - Y[i],
                  p * power / s * (X[i] - 1) / ((1 - X0) * (1 - X0)),
                  power * std::log(s));
          }
        else
          enter(i, -Y[i], 0, 0);
      enter(n, scale * X0, scale, 0);
      return true;
    };
    const LeastSquaresSummary summary = levenberg_marquardt(problem, options);
    if (!summary.converged)
      throw SolverError(std::string("power law through the peak: ") + describe(summary.reason));
    const double X0 = summary.parameters[0], p = summary.parameters[1];
    return {peak * std::pow((1 - X0) * span, -p), p, X0 * span};
  }

  double law_difference(const PowerLaw &first,
                        const PowerLaw &second,
                        const double    x_max,
                        const double    scale)
  {
    if (!(x_max > 0 && scale > 0))
      throw InputError("difference of two laws: range and scale must be positive");
    const auto difference = [&](const double x) { return std::fabs(first(x) - second(x)); };
    double     largest    = std::max(difference(0), difference(x_max));

    if (first.origin == second.origin)
      {
        // d/dx = 0 at one interior point at most.
        if (first.exponent == second.exponent)
          return largest / scale;
        const double ratio =
          second.coefficient * second.exponent / (first.coefficient * first.exponent);
        const double x = first.origin + std::pow(ratio, 1 / (first.exponent - second.exponent));
        if (std::isfinite(x) && x > std::max(0., first.origin) && x < x_max)
          largest = std::max(largest, difference(x));
        return largest / scale;
      }

    double low = 0, high = x_max;
    for (unsigned int round = 0; round < 3; ++round)
      {
        constexpr unsigned int n    = 4096;
        const double           step = (high - low) / n;
        double                 best = low, value = -1;
        for (unsigned int i = 0; i <= n; ++i)
          if (difference(low + i * step) > value)
            {
              best  = low + i * step;
              value = difference(best);
            }
        largest = std::max(largest, value);
        low     = std::max(0., best - step);
        high    = std::min(x_max, best + step);
      }
    return largest / scale;
  }
} // namespace dpcontact
