#ifndef DPCONTACT_SOLVER_SYSTEM_NEWTON_H
#define DPCONTACT_SOLVER_SYSTEM_NEWTON_H

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace dpcontact
{
  struct NewtonOptions
  {
    double       tolerance       = 1e-10; ///< on the problem's dimensionless residual norm
    unsigned int max_iterations  = 25;
    unsigned int max_line_search = 8;   ///< evaluations along one correction
    double       overshoot       = 0.5; ///< share of the starting slope that may be left
  };

  struct NewtonReport
  {
    bool                converged  = false;
    int                 iterations = 0; ///< linear systems solved
    std::vector<double> residuals;      ///< norm at the start and after every iteration
    std::string         reason;         ///< why it stopped, where it did not converge
  };

  /// Newton's method with a line search; it knows no physics.
  ///
  /// `Problem` has
  ///   double residual();        evaluates at the current iterate, returns a dimensionless norm;
  ///   bool   correction();      solves for the step with the tangent there; false: no solution;
  ///   double rounding();        share of that norm which rounding alone may leave;
  ///   double slope();           step · residual at the current iterate, negative before moving;
  ///   void   move(double t);    iterate += t · step.
  /// Where the residual is the gradient of a convex potential (associated plasticity and
  /// frictionless contact are), the slope grows along the step and its zero is the potential's
  /// minimum: a full step is kept unless it overshoots that by more than `overshoot`; then the zero
  /// is bracketed (Matthies & Strang, Int. J. Numer. Methods Eng. 14, 1979).
  template <class Problem>
  NewtonReport solve_newton(Problem &problem, const NewtonOptions &options)
  {
    NewtonReport report;
    double       norm = problem.residual();
    report.residuals.push_back(norm);
    while (!(norm <= options.tolerance + problem.rounding()))
      {
        if (!std::isfinite(norm))
          {
            report.reason = "the residual is not finite";
            return report;
          }
        if (report.iterations == static_cast<int>(options.max_iterations))
          {
            report.reason =
              "no convergence in " + std::to_string(options.max_iterations) + " Newton iterations";
            return report;
          }
        ++report.iterations;
        if (!problem.correction())
          {
            report.reason =
              "no correction was found: the tangent is singular or indefinite, or the linear "
              "solver did not converge";
            return report;
          }

        const double start = problem.slope();
        double       low = 0, low_slope = start, high = 1;
        problem.move(1);
        norm              = problem.residual();
        double high_slope = problem.slope();
        double position   = 1;
        for (unsigned int k = 0; k < options.max_line_search; ++k)
          {
            const double present = problem.slope();
            if (present <= options.overshoot * std::abs(start) &&
                (k == 0 || present >= -options.overshoot * std::abs(start)))
              break;
            if (present > 0)
              high = position, high_slope = present;
            else
              low = position, low_slope = present;
            // Regula falsi, kept off the ends of the bracket.
            const double zero  = low + (high - low) * low_slope / (low_slope - high_slope);
            const double inner = 0.1 * (high - low);
            const double next  = std::min(std::max(zero, low + inner), high - inner);
            problem.move(next - position);
            position = next;
            norm     = problem.residual();
          }
        report.residuals.push_back(norm);
      }
    report.converged = true;
    return report;
  }
} // namespace dpcontact

#endif
