#include "fitting/uncertainty.h"

#include <algorithm>
#include <cmath>

namespace dpcontact
{
  namespace
  {
    /// Relative error base + plastic·x, x = δ_max/δ_Hertz(F_max) − 1, of a, b, m, n.
    struct Line
    {
      double base, plastic;
      double at(const double x) const { return base + plastic * std::max(x, 0.); }
    };

    // Calibrated by runs/error_study (12 materials; how well it covers others: runs/error_study.json).
    constexpr Line mesh_error[4]          = {{1e-4, 1e-2}, {1e-4, 2e-3}, {1e-3, 1e-2}, {2e-4, 1e-3}};
    constexpr Line finite_radius_error[4] = {{.2, 1.}, {.15, .5}, {.5, 1.5}, {.1, .5}};
    /// The step's part is this multiple of what the coefficient moves by, and at least a floor.
    constexpr double step_multiple[4] = {2, 2, 2, 2};
    constexpr Line   step_floor[4]    = {{1e-5, 2e-3}, {1e-5, 4e-4}, {1e-4, 2e-3}, {2e-5, 2e-4}};
    /// Of plain penalty, times the stiffness in E/a; the augmentation leaves less than a thousandth.
    constexpr double penalty_error[4]   = {1., .2, 1., .2};
    constexpr double far_field_error[4] = {1e-4, 2e-5, 1e-4, 2e-5}; ///< at 200 contact radii, falls as 1/L²
  } // namespace

  std::array<double, 4> coefficients(const CurveFit &fit)
  {
    const PowerLaw &up = fit.loading.fit.law, &down = fit.unloading.fit.law;
    return {up.coefficient, up.exponent, down.coefficient, down.exponent};
  }

  std::array<double, 4> fit_errors(const CurveFit &fit)
  {
    const auto part = [](const double standard_error, const double value, const double change) {
      return standard_error + std::abs(value * change);
    };
    const BranchFit &up = fit.loading, &down = fit.unloading;
    return {part(up.fit.standard_error.coefficient, up.fit.law.coefficient, up.coefficient_change),
            part(up.fit.standard_error.exponent, up.fit.law.exponent, up.exponent_change),
            part(down.fit.standard_error.coefficient, down.fit.law.coefficient, down.coefficient_change),
            part(down.fit.standard_error.exponent, down.fit.law.exponent, down.exponent_change)};
  }

  CoefficientErrors
  estimate_errors(const CurveFit &fit, const Solution &solution, const Scene &scene)
  {
    const auto           values  = coefficients(fit);
    const auto           fits    = fit_errors(fit);
    const SolverOptions &used    = solution.used;
    const bool           closed  = solution.cost.dofs == 0;
    const double         kappa   = solution.curve.loading.back().contact_radius / scene.radius;
    const double         hertz   = fit.approach_yield * std::pow(fit.force_max / fit.force_yield, 2. / 3);
    const double         excess  = fit.approach_max / hertz - 1;
    const bool           known   = used.mesh == MeshKind::fitted && used.element == Element::serendipity_reduced;
    const double         coarser = 40. / (used.resolution * static_cast<double>(1u << used.level));
    std::array<double, 4> moved{};
    if (!closed)
      {
        const auto before = coefficients(fit_curve(solution.coarser_steps, fit.force_yield, fit.approach_yield));
        for (unsigned int c = 0; c < 4; ++c)
          moved[c] = solution.coarser_share * std::abs(values[c] - before[c]);
      }

    CoefficientErrors errors;
    for (unsigned int c = 0; c < 4; ++c)
      {
        const double value = std::abs(values[c]);
        ErrorParts  &parts = errors[c];
        parts.fit           = fits[c];
        parts.finite_radius = used.surface == Surface::sphere ? 0. : value * finite_radius_error[c].at(excess) * kappa;
        if (closed)
          {
            parts.mesh = parts.step = parts.contact = parts.far_field = 0;
            continue;
          }
        if (known)
          parts.mesh = value * mesh_error[c].at(excess) * coarser;
        parts.step    = std::max(step_multiple[c] * moved[c], value * step_floor[c].at(excess));
        parts.contact = value * penalty_error[c] / used.penalty_stiffness *
                        (used.contact == ContactMethod::augmented ? 1e-3 : 1.);
        parts.far_field = value * far_field_error[c] * std::pow(200 / used.domain_radius, 2);
      }
    return errors;
  }
} // namespace dpcontact
