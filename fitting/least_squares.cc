#include "fitting/least_squares.h"

#include "meshing/errors.h"
#include "meshing/number_text.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace dpcontact
{
  namespace
  {
    using Vector = std::unique_ptr<gsl_vector, decltype(&gsl_vector_free)>;
    using Matrix = std::unique_ptr<gsl_matrix, decltype(&gsl_matrix_free)>;
    using Workspace =
      std::unique_ptr<gsl_multifit_nlinear_workspace, decltype(&gsl_multifit_nlinear_free)>;

    /// What a point outside the model's domain costs: a step there is always refused.
    constexpr double refused_residual = 1e100;

    /// GSL sees the problem through this.
    struct Callback
    {
      const LeastSquaresProblem &problem;
      std::vector<double>        parameters;
      std::vector<double>        residuals;
      std::vector<double>        jacobian;

      explicit Callback(const LeastSquaresProblem &p)
        : problem(p)
        , parameters(p.start.size())
        , residuals(p.n_residuals)
        , jacobian(p.n_residuals * p.start.size())
      {}

      bool evaluate(const gsl_vector *x, const bool with_jacobian)
      {
        for (std::size_t j = 0; j < parameters.size(); ++j)
          parameters[j] = gsl_vector_get(x, j);
        const auto finite = [](const double v) { return std::isfinite(v); };
        return problem.evaluate(parameters, residuals, with_jacobian ? &jacobian : nullptr) &&
               std::all_of(residuals.begin(), residuals.end(), finite) &&
               (!with_jacobian || std::all_of(jacobian.begin(), jacobian.end(), finite));
      }
    };

    int residual_function(const gsl_vector *x, void *data, gsl_vector *f)
    {
      auto      &callback = *static_cast<Callback *>(data);
      const bool inside   = callback.evaluate(x, false);
      for (std::size_t i = 0; i < f->size; ++i)
        gsl_vector_set(f, i, inside ? callback.residuals[i] : refused_residual);
      return GSL_SUCCESS;
    }

    int jacobian_function(const gsl_vector *x, void *data, gsl_matrix *J)
    {
      auto &callback = *static_cast<Callback *>(data);
      if (!callback.evaluate(x, true))
        return GSL_EDOM;
      for (std::size_t i = 0; i < J->size1; ++i)
        for (std::size_t j = 0; j < J->size2; ++j)
          gsl_matrix_set(J, i, j, callback.jacobian[i * J->size2 + j]);
      return GSL_SUCCESS;
    }

    /// Singular value decomposition of the Jacobian with columns scaled to unit length, so that
    /// neither rank nor covariance depends on the parameters' units.
    class TangentPlane
    {
    public:
      explicit TangentPlane(const gsl_matrix *J)
        : p(J->size2)
        , U(gsl_matrix_alloc(J->size1, p), &gsl_matrix_free)
        , V(gsl_matrix_alloc(p, p), &gsl_matrix_free)
        , S(gsl_vector_alloc(p), &gsl_vector_free)
        , column_norms(p)
      {
        gsl_matrix_memcpy(U.get(), J);
        for (std::size_t j = 0; j < p; ++j)
          {
            double sum = 0;
            for (std::size_t i = 0; i < J->size1; ++i)
              sum += gsl_matrix_get(J, i, j) * gsl_matrix_get(J, i, j);
            column_norms[j] = std::sqrt(sum);
            if (column_norms[j] > 0)
              for (std::size_t i = 0; i < J->size1; ++i)
                gsl_matrix_set(U.get(), i, j, gsl_matrix_get(J, i, j) / column_norms[j]);
          }
        if (gsl_linalg_SV_decomp_jacobi(U.get(), V.get(), S.get()) != GSL_SUCCESS)
          return;
        const double threshold = std::numeric_limits<double>::epsilon() *
                                 static_cast<double>(J->size1) * gsl_vector_get(S.get(), 0);
        while (rank < p && gsl_vector_get(S.get(), rank) > threshold)
          ++rank;
      }

      /// Bates & Watts' measure for a residual f.
      double relative_offset(const gsl_vector *f) const
      {
        double total = 0, inside = 0;
        for (std::size_t i = 0; i < f->size; ++i)
          total += gsl_vector_get(f, i) * gsl_vector_get(f, i);
        for (std::size_t k = 0; k < rank; ++k)
          {
            double projection = 0;
            for (std::size_t i = 0; i < f->size; ++i)
              projection += gsl_matrix_get(U.get(), i, k) * gsl_vector_get(f, i);
            inside += projection * projection;
          }
        const double freedom = static_cast<double>(f->size - p);
        if (!(total > inside))
          return inside > 0 ? std::numeric_limits<double>::infinity() : 0;
        return std::sqrt(inside / static_cast<double>(p)) / std::sqrt((total - inside) / freedom);
      }

      /// Element (i, j) of (JᵀJ)⁻¹; full rank is the caller's business.
      double inverse_normal(const std::size_t i, const std::size_t j) const
      {
        double sum = 0;
        for (std::size_t k = 0; k < p; ++k)
          {
            const double s = gsl_vector_get(S.get(), k);
            sum += gsl_matrix_get(V.get(), i, k) * gsl_matrix_get(V.get(), j, k) / (s * s);
          }
        return sum / (column_norms[i] * column_norms[j]);
      }

      /// Gauss–Newton step −J⁺f; full rank is the caller's business.
      std::vector<double> gauss_newton_step(const gsl_vector *f) const
      {
        std::vector<double> step(p, 0.);
        for (std::size_t k = 0; k < p; ++k)
          {
            double projection = 0;
            for (std::size_t i = 0; i < f->size; ++i)
              projection += gsl_matrix_get(U.get(), i, k) * gsl_vector_get(f, i);
            for (std::size_t j = 0; j < p; ++j)
              step[j] -= projection / gsl_vector_get(S.get(), k) * gsl_matrix_get(V.get(), j, k) /
                         column_norms[j];
          }
        return step;
      }

      const std::size_t p;
      std::size_t       rank = 0;

    private:
      Matrix              U, V;
      Vector              S;
      std::vector<double> column_norms;
    };

    double norm(const gsl_vector *f)
    {
      double sum = 0;
      for (std::size_t i = 0; i < f->size; ++i)
        sum += gsl_vector_get(f, i) * gsl_vector_get(f, i);
      return std::sqrt(sum);
    }

    /// Near the minimum the sum of squares is flat to rounding over √ε of a standard error, and the
    /// trust region stalls. Gauss–Newton steps go on while they lower the relative offset, which is
    /// not flat, or the residual itself, down to `floor`.
    void polish(Callback                       &callback,
                gsl_multifit_nlinear_workspace *w,
                const std::function<double()>  &tolerance,
                const double                    floor)
    {
      constexpr double  near = 0.1; // of a standard error
      const std::size_t p    = w->x->size;
      Vector            x(gsl_vector_alloc(p), &gsl_vector_free);
      Vector            f(gsl_vector_alloc(w->f->size), &gsl_vector_free);
      Matrix            J(gsl_matrix_alloc(w->f->size, p), &gsl_matrix_free);
      for (unsigned int i = 0; i < 20; ++i)
        {
          const TangentPlane plane(w->J);
          const double       offset = plane.relative_offset(w->f);
          if (plane.rank < p || offset <= tolerance() || norm(w->f) <= floor)
            return;
          const std::vector<double> step = plane.gauss_newton_step(w->f);
          for (std::size_t j = 0; j < p; ++j)
            gsl_vector_set(x.get(), j, gsl_vector_get(w->x, j) + step[j]);
          if (jacobian_function(x.get(), &callback, J.get()) != GSL_SUCCESS ||
              residual_function(x.get(), &callback, f.get()) != GSL_SUCCESS)
            return;
          const bool closer =
            offset <= near && TangentPlane(J.get()).relative_offset(f.get()) < offset;
          if (!closer && !(norm(f.get()) < norm(w->f)))
            return;
          gsl_vector_memcpy(w->x, x.get());
          gsl_vector_memcpy(w->f, f.get());
          gsl_matrix_memcpy(w->J, J.get());
        }
    }

    void fill_errors(LeastSquaresSummary &summary, const TangentPlane &plane, const std::size_t n)
    {
      const std::size_t p = plane.p;
      summary.covariance.assign(p * p, std::numeric_limits<double>::quiet_NaN());
      summary.standard_errors.assign(p, std::numeric_limits<double>::quiet_NaN());
      if (plane.rank < p || n == p)
        return;
      const double variance = summary.sum_of_squares / static_cast<double>(n - p);
      for (std::size_t i = 0; i < p; ++i)
        {
          for (std::size_t j = 0; j < p; ++j)
            summary.covariance[i * p + j] = variance * plane.inverse_normal(i, j);
          summary.standard_errors[i] = std::sqrt(summary.covariance[i * p + i]);
        }
    }

    gsl_multifit_nlinear_fdf system_of(Callback &callback)
    {
      gsl_multifit_nlinear_fdf system{};
      system.f      = &residual_function;
      system.df     = &jacobian_function;
      system.n      = callback.residuals.size();
      system.p      = callback.parameters.size();
      system.params = &callback;
      return system;
    }

    Workspace make_workspace(const std::size_t n, const std::size_t p)
    {
      auto parameters  = gsl_multifit_nlinear_default_parameters();
      parameters.trs   = gsl_multifit_nlinear_trs_lmaccel;
      parameters.scale = gsl_multifit_nlinear_scale_levenberg;
      return Workspace(gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &parameters, n, p),
                       &gsl_multifit_nlinear_free);
    }

    /// Iterates from the state of the workspace until a reason to stop is found or GSL refuses to
    /// go on, and enters reason, offset and iterations.
    /// @param status of the workspace's initialisation
    /// @return GSL's last status
    int iterate(gsl_multifit_nlinear_workspace *w,
                int                             status,
                const LeastSquaresOptions      &options,
                const std::function<double()>  &tolerance,
                const double                    floor,
                LeastSquaresSummary            &summary)
    {
      const std::size_t n = w->f->size, p = w->x->size;
      while (status == GSL_SUCCESS)
        {
          const TangentPlane plane(w->J);
          summary.relative_offset = n > p ? plane.relative_offset(w->f) : 0;
          if (norm(w->f) <= floor)
            summary.reason = StopReason::residual_zero;
          else if (n > p && plane.rank == p && summary.relative_offset <= tolerance())
            summary.reason = StopReason::relative_offset;
          else if (summary.iterations >= options.max_iterations)
            summary.reason = StopReason::iteration_limit;
          else
            {
              status = gsl_multifit_nlinear_iterate(w);
              ++summary.iterations;
              continue;
            }
          break;
        }
      return status;
    }

    /// Enters what the last state of the workspace says: parameters, their errors, and whether it
    /// is a minimum.
    void conclude(const gsl_multifit_nlinear_workspace *w,
                  const std::function<double()>        &tolerance,
                  const double                          floor,
                  LeastSquaresSummary                  &summary)
    {
      const std::size_t n = w->f->size, p = w->x->size;
      for (std::size_t j = 0; j < p; ++j)
        summary.parameters.push_back(gsl_vector_get(w->x, j));
      const TangentPlane plane(w->J);
      summary.rank            = static_cast<unsigned int>(plane.rank);
      summary.sum_of_squares  = norm(w->f) * norm(w->f);
      summary.relative_offset = n > p ? plane.relative_offset(w->f) : 0;

      if (summary.reason == StopReason::no_progress && norm(w->f) <= floor)
        summary.reason = StopReason::residual_zero;
      else if (summary.reason == StopReason::no_progress && n > p &&
               summary.relative_offset <= tolerance())
        summary.reason = StopReason::relative_offset;

      // Where rounding forbids a further decrease, the minimum is reached as well as it can be.
      const bool stalled_at_minimum = summary.reason == StopReason::no_progress &&
                                      summary.relative_offset <= std::max(1e-5, 100 * tolerance());
      summary.converged =
        summary.rank == p && (summary.reason == StopReason::relative_offset ||
                              summary.reason == StopReason::residual_zero || stalled_at_minimum);
      fill_errors(summary, plane, n);
    }
  } // namespace

  const char *describe(const StopReason reason)
  {
    switch (reason)
      {
        case StopReason::relative_offset:
          return "converged: the residual is orthogonal to the tangent plane";
        case StopReason::residual_zero:
          return "converged: the residuals have reached rounding level";
        case StopReason::no_progress:
          return "no step lowers the sum of squares any further";
        case StopReason::iteration_limit:
          return "the limit on the number of iterations was reached";
        case StopReason::failed:
          return "the least-squares library could not take a step";
      }
    return "unknown";
  }

  void LeastSquaresOptions::check() const
  {
    if (max_iterations == 0)
      throw InputError("least squares: the limit on iterations is 0; give at least 1");
    if (!(relative_offset > 0 && relative_offset < 1))
      throw InputError("least squares: the tolerance on the relative offset is " +
                       number_text(relative_offset) + "; it must lie between 0 and 1");
  }

  LeastSquaresSummary levenberg_marquardt(const LeastSquaresProblem &problem,
                                          const LeastSquaresOptions &options)
  {
    static const auto previous_handler = gsl_set_error_handler_off();
    (void)previous_handler;
    options.check();
    const std::size_t n = problem.n_residuals, p = problem.start.size();
    if (p == 0 || n < p)
      throw InputError("least squares: " + std::to_string(n) + " points cannot determine " +
                       std::to_string(p) + " parameters");

    Callback                    callback(problem);
    gsl_multifit_nlinear_fdf    system = system_of(callback);
    const gsl_vector_const_view start  = gsl_vector_const_view_array(problem.start.data(), p);
    if (!callback.evaluate(&start.vector, true))
      throw InputError("least squares: the model cannot be evaluated at its starting values");
    const Workspace                       workspace = make_workspace(n, p);
    gsl_multifit_nlinear_workspace *const w         = workspace.get();

    // Rounding in the model's values, and what it leaves of the offset: no smaller one can be
    // asked.
    const double floor     = 1e-15 * problem.observation_norm;
    const auto   tolerance = [&]() {
      const double freedom = static_cast<double>(n - p) / static_cast<double>(p);
      const double noise = floor * std::sqrt(freedom), residual = norm(w->f);
      return residual > noise ? std::max(options.relative_offset, noise / residual) : 1.;
    };

    LeastSquaresSummary summary;
    const int           status = iterate(
      w, gsl_multifit_nlinear_init(&start.vector, &system, w), options, tolerance, floor, summary);
    if (status == GSL_ENOPROG)
      {
        summary.reason = StopReason::no_progress;
        if (n > p)
          polish(callback, w, tolerance, floor);
      }
    conclude(w, tolerance, floor, summary);
    return summary;
  }
} // namespace dpcontact
