#ifndef DPCONTACT_FITTING_LEAST_SQUARES_H
#define DPCONTACT_FITTING_LEAST_SQUARES_H

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace dpcontact
{
  /// Why a fit ended.
  enum class StopReason
  {
    relative_offset, ///< converged: the residual is orthogonal to the tangent plane
    residual_zero,   ///< converged: the residuals have reached rounding level
    no_progress,     ///< no step lowers the sum of squares any further
    iteration_limit, ///< the number of iterations is used up
    failed           ///< the library refused to go on
  };

  /// The reason as a sentence for people.
  const char *describe(StopReason reason);

  /// Residuals r(p) = model − observation, unweighted, and their Jacobian J_ij = ∂r_i/∂p_j.
  struct LeastSquaresProblem
  {
    std::size_t         n_residuals = 0;
    std::vector<double> start; ///< p₀; its length is the number of parameters

    /// Fills `residuals` (length n_residuals) and, unless `jacobian` is nullptr, the Jacobian
    /// (row-major, n_residuals × n_parameters). Both arrive sized. Returning false, or a residual
    /// that is not finite, means that p lies outside the model's domain: the step is shortened.
    std::function<bool(const std::vector<double> &p,
                       std::vector<double>       &residuals,
                       std::vector<double>       *jacobian)>
      evaluate;

    /// √(Σ y²) of the observations, 0 where it is not known. A residual whose norm is below 1e-15
    /// of it is rounding.
    double observation_norm = 0;
  };

  struct LeastSquaresOptions
  {
    unsigned int max_iterations = 2000;

    /// The search stops where the residual's part in the tangent plane, per parameter, is this
    /// fraction of the part orthogonal to it, per degree of freedom (Bates & Watts, Technometrics
    /// 23, 1981). The parameters are then this fraction of a standard error away from the minimum.
    /// Where rounding (see observation_norm) does not let the fraction become so small, the
    /// smallest attainable one takes its place.
    double relative_offset = 1e-9;

    /// @throws InputError unless both are positive.
    void check() const;
  };

  struct LeastSquaresSummary
  {
    std::vector<double> parameters;
    std::vector<double> covariance; ///< s² (JᵀJ)⁻¹, row-major; NaN where the rank is deficient
    std::vector<double> standard_errors; ///< square roots of its diagonal
    double              sum_of_squares  = std::numeric_limits<double>::quiet_NaN();
    double              relative_offset = std::numeric_limits<double>::quiet_NaN();
    unsigned int        rank            = 0; ///< of the Jacobian with columns scaled to unit length
    unsigned int        iterations      = 0;
    StopReason          reason          = StopReason::failed;
    bool                converged       = false; ///< a minimum, and its Jacobian of full rank
  };

  /// Minimises Σ r² by the Levenberg–Marquardt method: GSL's trust region with QR, Levenberg's
  /// scaling and geodesic acceleration, the one of GSL's choices that solves all of the tried
  /// problems of NIST from both starts. For the covariance s² = SSE/(n − p); where n = p it is NaN.
  /// A search that does not converge is no error: `converged` and `reason` tell it. Switches GSL's
  /// aborting error handler off for the process.
  /// @throws InputError where n < p, or where the residuals cannot be evaluated at the start.
  LeastSquaresSummary levenberg_marquardt(const LeastSquaresProblem &problem,
                                          const LeastSquaresOptions &options = {});
} // namespace dpcontact

#endif
