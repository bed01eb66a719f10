#ifndef DPCONTACT_SOLVER_NEWTON_H
#define DPCONTACT_SOLVER_NEWTON_H

#include <cmath>
#include <string>
#include <vector>

namespace dpcontact
{
  struct NewtonOptions
  {
    double       tolerance      = 1e-10; ///< on the problem's dimensionless residual norm
    unsigned int max_iterations = 25;
    unsigned int max_halvings   = 6;     ///< of one correction
    double       divergence     = 1e8;   ///< residual norm at which the iteration is given up
  };

  struct NewtonReport
  {
    bool                converged  = false;
    int                 iterations = 0; ///< linear systems solved
    std::vector<double> residuals;      ///< norm at the start and after every iteration
    std::string         reason;         ///< why it stopped, where it did not converge
  };

  /// Newton's method with backtracking on the residual norm; it knows no physics.
  ///
  /// `Problem` has
  ///   double residual();        evaluates at the current iterate, returns a dimensionless norm;
  ///   bool   correction();      solves for the step with the tangent there; false: no solution;
  ///   void   move(double t);    iterate += t · step.
  /// A full step is kept unless the norm grows beyond the largest of the last three: contact and
  /// plastic onset make single iterations go up on the way to quadratic convergence.
  template <class Problem>
  NewtonReport solve_newton(Problem &problem, const NewtonOptions &options)
  {
    NewtonReport report;
    double       norm = problem.residual();
    report.residuals.push_back(norm);
    while (!(norm <= options.tolerance))
      {
        if (!std::isfinite(norm) || norm > options.divergence)
          {
            report.reason = "the residual diverged";
            return report;
          }
        if (report.iterations == static_cast<int>(options.max_iterations))
          {
            report.reason = "no convergence in " + std::to_string(options.max_iterations) +
                            " Newton iterations";
            return report;
          }
        ++report.iterations;
        if (!problem.correction())
          {
            report.reason = "the tangent is not positive definite";
            return report;
          }
        double reference = norm;
        for (std::size_t back = 1; back < 3 && back < report.residuals.size(); ++back)
          reference = std::max(reference, report.residuals[report.residuals.size() - 1 - back]);

        double length = 1;
        problem.move(length);
        double       best = problem.residual();
        unsigned int halvings = 0;
        while (!(best < 2 * reference) && halvings < options.max_halvings)
          {
            problem.move(-length / 2);
            length /= 2;
            ++halvings;
            best = problem.residual();
          }
        norm = best;
        report.residuals.push_back(norm);
      }
    report.converged = true;
    return report;
  }
} // namespace dpcontact

#endif
