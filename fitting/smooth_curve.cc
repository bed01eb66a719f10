#include "fitting/smooth_curve.h"

#include "meshing/errors.h"

#include <gsl/gsl_bspline.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit.h>

#include <algorithm>
#include <cmath>

namespace dpcontact
{
  namespace
  {
    template <typename T>
    using Owned = std::unique_ptr<T, void (*)(T *)>;

    Owned<gsl_vector> make_vector(const std::size_t size)
    {
      return {gsl_vector_alloc(size), &gsl_vector_free};
    }

    Owned<gsl_matrix> make_matrix(const std::size_t rows, const std::size_t columns)
    {
      return {gsl_matrix_alloc(rows, columns), &gsl_matrix_free};
    }
  } // namespace

  struct SmoothCurve::Basis
  {
    explicit Basis(const std::vector<double> &knots)
      : workspace(gsl_bspline_alloc(4, knots.size()), &gsl_bspline_free)
      , values(make_vector(knots.size() + 2))
      , low(knots.front())
      , high(knots.back())
    {
      const auto breaks = gsl_vector_const_view_array(knots.data(), knots.size());
      gsl_bspline_knots(&breaks.vector, workspace.get());
    }

    /// The values of all basis functions at x.
    const gsl_vector &at(const double x)
    {
      gsl_bspline_eval(std::clamp(x, low, high), values.get(), workspace.get());
      return *values;
    }

    Owned<gsl_bspline_workspace> workspace;
    Owned<gsl_vector>            values;
    double                       low, high;
  };

  SmoothCurve::SmoothCurve(const std::vector<double> &knots,
                           const std::vector<double> &x,
                           const std::vector<double> &y)
  {
    if (knots.size() < 4 ||
        std::adjacent_find(knots.begin(), knots.end(), std::greater_equal<>()) != knots.end())
      throw InputError("smooth curve: at least four ascending knots are needed");
    std::vector<double> values;
    for (std::size_t i = 0; i < x.size(); ++i)
      if (x[i] >= knots.front() && x[i] <= knots.back())
        {
          positions.push_back(x[i]);
          values.push_back(y[i]);
        }
    const std::size_t n = knots.size() + 2;
    if (positions.size() < n)
      throw InputError("smooth curve: " + std::to_string(positions.size()) +
                       " points do not determine " + std::to_string(n) + " coefficients");

    basis       = std::make_shared<Basis>(knots);
    auto matrix = make_matrix(positions.size(), n), covariance = make_matrix(n, n);
    for (std::size_t i = 0; i < positions.size(); ++i)
      gsl_matrix_set_row(matrix.get(), i, &basis->at(positions[i]));
    auto       solution = make_vector(n);
    const auto right    = gsl_vector_const_view_array(values.data(), values.size());
    const Owned<gsl_multifit_linear_workspace> workspace(
      gsl_multifit_linear_alloc(positions.size(), n), &gsl_multifit_linear_free);
    double chi_squared = 0;
    if (gsl_multifit_linear(matrix.get(),
                            &right.vector,
                            solution.get(),
                            covariance.get(),
                            &chi_squared,
                            workspace.get()) != GSL_SUCCESS)
      throw InputError("smooth curve: the least-squares problem has no solution");
    coefficients.assign(solution->data, solution->data + n);
    for (std::size_t i = 0; i < positions.size(); ++i)
      residuals.push_back(values[i] - (*this)(positions[i]));
  }

  double SmoothCurve::operator()(const double x) const
  {
    const gsl_vector &values = basis->at(x);
    double            sum    = 0;
    for (std::size_t i = 0; i < coefficients.size(); ++i)
      sum += coefficients[i] * gsl_vector_get(&values, i);
    return sum;
  }

  double SmoothCurve::scatter(const double low, const double high) const
  {
    double      sum   = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < positions.size(); ++i)
      if (positions[i] >= low && positions[i] <= high)
        {
          sum += residuals[i] * residuals[i];
          ++count;
        }
    return count == 0 ? 0 : std::sqrt(sum / static_cast<double>(count));
  }
} // namespace dpcontact
