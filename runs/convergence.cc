#include "runs/convergence.h"

#include "meshing/errors.h"
#include "runs/quantity.h"
#include "solver/hertz.h"
#include "solver/remote_compliance.h"

#include <algorithm>
#include <cmath>

namespace dpcontact
{
  namespace
  {
    using Values = std::array<double, 4>;

    constexpr unsigned int few_steps           = 32;
    constexpr unsigned int finite_radius_cells = 20;  ///< resolution of the study of a/R
    constexpr double       largest_cap         = 0.8; ///< its domain over R, at most

    std::string number(const double value) { return format_quantity(value, Dimension::number); }

    CurveFit fit_of(const Solution &solution, const Curve &curve)
    {
      return fit_curve(curve, solution.yield.force, solution.yield.approach);
    }

    Values solve(const Case &input, const SolverOptions &options)
    {
      const Solution solution = solve_contact(input.material, input.scene, options);
      return coefficients(fit_of(solution, solution.curve));
    }

    /// Sets limit, order and error of a study whose second level is what was asked for.
    void judge(ErrorStudy &study)
    {
      const auto &levels = study.levels;
      for (unsigned int c = 0; c < 4; ++c)
        {
          const double middle = levels[1].values[c], fine = levels[2].values[c];
          std::tie(study.limit[c], study.order[c]) = richardson(levels[0].values[c], middle, fine);
          study.error[c] = std::max(std::abs(middle - fine), std::abs(middle - study.limit[c]));
        }
    }

    ErrorStudy
    study_finite_radius(const Case &input, const SolverOptions &options, const Solution &base)
    {
      ErrorStudy   study{"finite_radius", "a/R", {}, {}, {}, {}};
      const double kappa = base.curve.loading.back().contact_radius / input.scene.radius;
      for (const double factor : {4., 2., 1.})
        {
          // The same Λ at a larger a/R: F_y grows like σc³, the radius of the contact like σc.
          Case scaled = input;
          scaled.material.compressive_strength *= factor;
          scaled.scene.force_max *= factor * factor * factor;
          SolverOptions used    = options;
          used.resolution       = finite_radius_cells;
          used.loading_steps    = few_steps;
          used.domain_radius    = std::min(options.domain_radius, largest_cap / (kappa * factor));
          const Values flat     = solve(scaled, used);
          used.surface          = Surface::sphere;
          const Solution sphere = solve_contact(scaled.material, scaled.scene, used);
          const double   C =
            remote_compliance(scaled.material, scaled.scene.radius, used, sphere.mesh_radius);
          const Values curved =
            coefficients(fit_of(sphere, remove_linear_compliance(sphere.curve, C)));
          ErrorStudy::Level level{number(kappa * factor), {}};
          for (unsigned int c = 0; c < 4; ++c)
            level.values[c] = curved[c] - flat[c];
          study.levels.push_back(level);
        }
      // Least squares of k₁ κ + k₂ κ² over κ = 4, 2, 1 times the scene's a/R.
      for (unsigned int c = 0; c < 4; ++c)
        {
          double s2 = 0, s3 = 0, s4 = 0, y1 = 0, y2 = 0;
          for (unsigned int i = 0; i < 3; ++i)
            {
              const double x = std::pow(2., 2. - i), y = study.levels[i].values[c];
              s2 += x * x, s3 += x * x * x, s4 += x * x * x * x, y1 += x * y, y2 += x * x * y;
            }
          const double determinant = s2 * s4 - s3 * s3;
          const double at_scene    = ((y1 * s4 - y2 * s3) + (y2 * s2 - y1 * s3)) / determinant;
          study.limit[c]           = at_scene;
          study.order[c]           = std::numeric_limits<double>::quiet_NaN();
          study.error[c]           = std::abs(at_scene);
        }
      return study;
    }
  } // namespace

  std::pair<double, double> richardson(const double coarse, const double middle, const double fine)
  {
    const double first = middle - coarse, second = fine - middle;
    const double ratio = first / second;
    if (!(ratio >= std::sqrt(2.) && ratio <= 16))
      return {fine, std::numeric_limits<double>::quiet_NaN()};
    return {fine + second / (ratio - 1), std::log2(ratio)};
  }

  Convergence study_convergence(const Case                                     &input,
                                const SolverOptions                            &options,
                                const std::function<void(const std::string &)> &log)
  {
    Convergence result;
    log("as asked for");
    result.solution    = solve_contact(input.material, input.scene, options);
    const CurveFit fit = fit_of(result.solution, result.solution.curve);
    result.values      = coefficients(fit);
    result.estimate    = estimate_errors(fit, result.solution, input.material, input.scene);
    const auto fits    = fit_errors(fit);
    for (unsigned int c = 0; c < 4; ++c)
      result.studied[c] = {0, 0, 0, 0, 0, fits[c]};
    if (result.solution.cost.dofs == 0)
      {
        log("the scene is elastic and solved in closed form: nothing to vary; what a finite a/R "
            "changes is not studied");
        for (ErrorParts &parts : result.studied)
          parts.finite_radius = ErrorParts::unset;
        return result;
      }

    const SolverOptions base = result.solution.used;
    const auto          vary = [&](const char                                               *source,
                          const char                                               *varied,
                          const std::vector<std::pair<std::string, SolverOptions>> &levels,
                          double ErrorParts::*part) {
      ErrorStudy study{source, varied, {}, {}, {}, {}};
      for (const auto &[label, level] : levels)
        {
          log(std::string(source) + ": " + varied + " " + label);
          study.levels.push_back({label, solve(input, level)});
        }
      judge(study);
      for (unsigned int c = 0; c < 4; ++c)
        result.studied[c].*part = study.error[c];
      result.studies.push_back(study);
    };
    const auto with = [&](const std::function<void(SolverOptions &)> &change) {
      SolverOptions changed = base;
      change(changed);
      return changed;
    };

    std::vector<std::pair<std::string, SolverOptions>> levels;
    for (const double factor : {0.5, 1., 2.})
      {
        const auto n = static_cast<unsigned int>(std::lround(factor * base.resolution));
        levels.emplace_back(std::to_string(n), with([n](SolverOptions &o) { o.resolution = n; }));
      }
    vary("mesh", "resolution", levels, &ErrorParts::mesh);

    levels.clear();
    for (const double factor : {0.5, 1., 2.})
      {
        const auto n = 2 * static_cast<unsigned int>(std::lround(factor * base.loading_steps / 2));
        levels.emplace_back(std::to_string(n),
                            with([n](SolverOptions &o) { o.loading_steps = n; }));
      }
    vary("step", "loading-steps", levels, &ErrorParts::step);

    levels.clear();
    for (const double factor : {0.1, 1., 10.})
      levels.emplace_back(number(factor * base.penalty_stiffness), with([factor](SolverOptions &o) {
                            o.penalty_stiffness *= factor;
                            o.loading_steps = few_steps;
                          }));
    vary("contact", "penalty-stiffness", levels, &ErrorParts::contact);

    levels.clear();
    for (const double factor : {0.5, 1., 2.})
      levels.emplace_back(number(factor * base.domain_radius), with([factor](SolverOptions &o) {
                            o.domain_radius *= factor;
                            o.loading_steps = few_steps;
                          }));
    vary("far_field", "domain-radius", levels, &ErrorParts::far_field);

    log("finite_radius: a/R");
    result.studies.push_back(study_finite_radius(input, base, result.solution));
    for (unsigned int c = 0; c < 4; ++c)
      result.studied[c].finite_radius = result.studies.back().error[c];
    return result;
  }
} // namespace dpcontact
