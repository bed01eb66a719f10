#include "database/rows/uncertainty.h"

#include "solver/path/solution.h"
#include "solver/path/step_extrapolation.h"

#include <algorithm>
#include <cmath>

namespace dpcontact
{
  namespace
  {
    /// Relative error base + factor·x^exponent, x = δ_max/δ_Hertz(F_max) − 1 ≥ 0.
    struct Growth
    {
      double base, factor, exponent;
      double at(const double x) const
      {
        return base + factor * std::pow(std::max(x, 0.), exponent);
      }
    };

    // Of a, b, m, n. Calibrated on the 38 materials that runs/studies/error_study names for it,
    // such that the sum of the numerical parts covers 36 of them with a margin, and split by their
    // shares. The base is what resolution 40 leaves of Hertz's contact. How well this covers 12
    // other materials: runs/studies/error_study --report.
    constexpr Growth mesh_error[]      = {{6e-5, .0075, .75},
                                          {4e-5, .00085, .5},
                                          {1e-4, .01, 1},
                                          {4e-5, .0006, .5}};
    constexpr Growth step_floor[]      = {{7e-5, .0062, .75},
                                          {3e-5, .00045, .5},
                                          {9e-5, .0141, 1},
                                          {5e-5, .001, .5}};
    constexpr Growth far_field_error[] = {{1e-5, .0015, .75},
                                          {1e-5, .00013, .5},
                                          {1e-5, .0021, 1},
                                          {1e-5, .0001, .5}};
    // In space. Quadratic elements, four across the contact: to fall with the square of their
    // number; six and eight leave less. Bricks: from eight across the contact on the rings' angles,
    // which the resolution does not change, leave most, a level a quarter of it (measured on
    // Hertz's approach: 1.0 and 0.25 %);
    // fewer to leave more by their square, which tests/system/test_space.py checks at four.
    // One and a half times the largest of three materials' (Λ = 1.2, 11 and 392) against
    // axisymmetry, equal steps.
    constexpr Growth quadratic_mesh_error[] = {{.004, .15, 1},
                                               {.003, .012, .5},
                                               {.005, .15, 1},
                                               {.005, .015, 1}};
    constexpr double brick_mesh_error[]     = {.033, .01, .025, .0105};
    /// To be multiplied by a/R.
    constexpr Growth finite_radius_error[] = {{.04, 3.2, .5},
                                              {.06, .8, .5},
                                              {.23, 2.6, .5},
                                              {.1, .6, .75}};
    /// The step's part is this multiple of what the coefficient moves by, plus the floor.
    constexpr double step_multiple[] = {1, .5, .5, .3};
    /// Of plain penalty, times the stiffness in E/a. The augmentation leaves a millionth of the
    /// approach open.
    constexpr double penalty_error[]    = {1, .2, 1, .2};
    constexpr double augmentation_error = 1e-6;
    /// Of mesh and step outside the calibration. Von Mises at F_max/F_y = 65 moves b by 2.4 times
    /// the calibrated step error where the steps are halved.
    constexpr double uncalibrated = 3;

    bool is_calibrated(const Material &material)
    {
      const double phi = material.friction_angle.degrees();
      return is_tabulated_kind(material) && phi > 19.99 && phi < 40.01;
    }
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
    return {
      part(up.fit.standard_error.coefficient, up.fit.law.coefficient, up.coefficient_change),
      part(up.fit.standard_error.exponent, up.fit.law.exponent, up.exponent_change),
      part(down.fit.standard_error.coefficient, down.fit.law.coefficient, down.coefficient_change),
      part(down.fit.standard_error.exponent, down.fit.law.exponent, down.exponent_change)};
  }

  std::array<double, 4> finite_radius_errors(const double excess, const double kappa)
  {
    std::array<double, 4> errors{};
    for (unsigned int c = 0; c < 4; ++c)
      errors[c] = finite_radius_error[c].at(excess) * kappa;
    return errors;
  }

  CoefficientErrors estimate_errors(const CurveFit &fit,
                                    const Solution &solution,
                                    const Material &material,
                                    const Scene    &scene)
  {
    const auto &second = scene.second;
    const bool  calibrated =
      is_calibrated(material) && (!second || !second->material || is_calibrated(*second->material));
    const double         safety = calibrated ? 1 : uncalibrated;
    const auto           values = coefficients(fit);
    const auto           fits   = fit_errors(fit);
    const SolverOptions &used   = solution.used;
    const bool           closed = solution.cost.dofs == 0;
    const double kappa   = solution.curve.loading.back().contact_radius / scene.smaller_radius();
    const double hertz   = fit.approach_yield * std::pow(fit.force_max / fit.force_yield, 2. / 3);
    const double excess  = fit.approach_max / hertz - 1;
    const double refined = static_cast<double>(1u << used.refinements);
    const double across  = used.resolution * refined;
    // Of the element and mesh that were studied; unset for others.
    const auto mesh_share = [&](const unsigned int c) {
      if (used.mesh == MeshKind::fitted && in_space(used.geometry))
        {
          if (used.element == Element::quadratic_full)
            return quadratic_mesh_error[c].at(excess) * std::pow(4 / across, 2);
          if (used.element == Element::linear_mean_dilatation)
            return brick_mesh_error[c] * std::pow(std::max(1., 8. / used.resolution) / refined, 2);
        }
      else if (used.mesh == MeshKind::fitted && used.element == Element::serendipity_reduced)
        return mesh_error[c].at(excess) * 40 / across;
      return ErrorParts::unset;
    };
    std::array<double, 4> moved{};
    if (!closed)
      {
        const auto before =
          coefficients(fit_curve(solution.coarser_steps, fit.force_yield, fit.approach_yield));
        for (unsigned int c = 0; c < 4; ++c)
          moved[c] = solution.coarser_share * std::abs(values[c] - before[c]);
      }

    CoefficientErrors errors;
    for (unsigned int c = 0; c < 4; ++c)
      {
        const double value = std::abs(values[c]);
        ErrorParts  &parts = errors[c];
        parts.fit          = fits[c];
        parts.finite_radius =
          used.surface == Surface::sphere ? 0. : value * finite_radius_errors(excess, kappa)[c];
        if (closed)
          {
            parts.mesh = parts.step = parts.contact = parts.far_field = 0;
            continue;
          }
        parts.mesh = safety * value * mesh_share(c);
        // A curve that is not extrapolated keeps the whole error of its order.
        const double multiple =
          used.extrapolation ? step_multiple[c] : 1 / (std::pow(2., step_order) - 1);
        parts.step    = safety * (multiple * moved[c] + value * step_floor[c].at(excess));
        parts.contact = value * (used.contact == ContactMethod::augmented
                                   ? augmentation_error
                                   : penalty_error[c] / used.penalty_stiffness);
        parts.far_field =
          value * far_field_error[c].at(excess) * std::pow(200 / used.domain_radius, 2);
      }
    // a and m stand for the curve at δ_y. Where it does not reach that far, they carry the error of
    // its exponent along.
    const double beyond = std::log(std::max(1., fit.approach_yield / fit.approach_max));
    if (beyond > 0 && !closed)
      for (const unsigned int c : {0u, 2u})
        for (double ErrorParts::*part :
             {&ErrorParts::mesh, &ErrorParts::step, &ErrorParts::contact, &ErrorParts::far_field})
          errors[c].*part += std::abs(values[c]) * beyond * errors[c + 1].*part;
    return errors;
  }
} // namespace dpcontact
