#include "runs/studies/convergence.h"

#include "database/rows/uncertainty.h"
#include "fitting/curve_fit.h"
#include "meshing/errors.h"
#include "solver/closed_form/hertz.h"
#include "solver/path/remote_compliance.h"
#include "solver/path/solution.h"
#include "solver/path/solve.h"
#include "solver/problem/quantity.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <tuple>
#include <utility>

namespace dpcontact
{
  namespace
  {
    using Values = std::array<double, 4>;

    constexpr unsigned int few_steps           = 32;
    constexpr unsigned int finite_radius_cells = 20;  ///< resolution of the study of a/R
    constexpr double       largest_cap         = 0.8; ///< its domain over R, at most
    constexpr double       least_cap           = 10;  ///< its domain over a, at least

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

    /// At 4, 2 and 1 times the scene's a/R, or at less where the domain of a larger one would not
    /// fit into the sphere.
    ErrorStudy
    study_finite_radius(const Case &input, const SolverOptions &options, const Solution &base)
    {
      ErrorStudy   study{"finite_radius", "a/R", {}, {}, {}, {}};
      const double kappa = base.curve.loading.back().contact_radius / input.scene.radius;
      const double most  = std::min(4., largest_cap / (least_cap * kappa) * (1 - 1e-12));
      const std::array<double, 3> factors{most, most / 2, most / 4};
      for (const double factor : factors)
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
      // Least squares of k₁ κ + k₂ κ² over the factors, at the factor 1.
      for (unsigned int c = 0; c < 4; ++c)
        {
          double s2 = 0, s3 = 0, s4 = 0, y1 = 0, y2 = 0;
          for (unsigned int i = 0; i < 3; ++i)
            {
              const double x = factors[i], y = study.levels[i].values[c];
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

  namespace
  {
    /// Options of the three levels of a study, with the label of each.
    using Levels = std::vector<std::pair<std::string, SolverOptions>>;

    /// One source: what of the options is varied for it.
    struct Source
    {
      const char *name;
      const char *varied; ///< the option
      double ErrorParts::*part;
      Levels              levels;
    };

    Levels resolutions(const SolverOptions &base)
    {
      Levels levels;
      for (const double factor : {0.5, 1., 2.})
        {
          SolverOptions options = base;
          options.resolution    = static_cast<unsigned int>(std::lround(factor * base.resolution));
          levels.emplace_back(std::to_string(options.resolution), options);
        }
      return levels;
    }

    Levels load_steps(const SolverOptions &base)
    {
      Levels levels;
      for (const double factor : {0.5, 1., 2.})
        {
          SolverOptions options = base;
          options.loading_steps =
            2 * static_cast<unsigned int>(std::lround(factor * base.loading_steps / 2));
          levels.emplace_back(std::to_string(options.loading_steps), options);
        }
      return levels;
    }

    /// A number times three factors, with few steps, which it does not depend on.
    Levels multiples(const SolverOptions &base,
                     double SolverOptions::*const         member,
                     const std::initializer_list<double> &factors)
    {
      Levels levels;
      for (const double factor : factors)
        {
          SolverOptions options = base;
          options.*member *= factor;
          options.loading_steps = few_steps;
          levels.emplace_back(number(factor * base.*member), options);
        }
      return levels;
    }

    std::vector<Source> sources_of(const SolverOptions &base)
    {
      using O = SolverOptions;
      return {
        {"mesh", "resolution", &ErrorParts::mesh, resolutions(base)},
        {"step", "loading-steps", &ErrorParts::step, load_steps(base)},
        {"contact",
         "penalty-stiffness",
         &ErrorParts::contact,
         multiples(base, &O::penalty_stiffness, {0.1, 1., 10.})},
        {"far_field",
         "domain-radius",
         &ErrorParts::far_field,
         multiples(base, &O::domain_radius, {0.5, 1., 2.})},
      };
    }

    ErrorStudy study_of(const Case                                     &input,
                        const Source                                   &source,
                        const std::function<void(const std::string &)> &log)
    {
      ErrorStudy study{source.name, source.varied, {}, {}, {}, {}};
      for (const auto &[label, options] : source.levels)
        {
          log(std::string(source.name) + ": " + source.varied + " " + label);
          study.levels.push_back({label, solve(input, options)});
        }
      judge(study);
      return study;
    }
  } // namespace

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
    for (std::size_t c = 0; c < fits.size(); ++c)
      result.studied[c] = {0, 0, 0, 0, 0, fits[c]};
    if (result.solution.cost.dofs == 0)
      {
        log("the scene is elastic and solved in closed form: nothing to vary; what a finite a/R "
            "changes is not studied");
        for (ErrorParts &parts : result.studied)
          parts.finite_radius = ErrorParts::unset;
        return result;
      }

    const SolverOptions base  = result.solution.used;
    const auto          enter = [&result](const ErrorStudy &study, double ErrorParts::*const part) {
      for (std::size_t c = 0; c < study.error.size(); ++c)
        result.studied[c].*part = study.error[c];
      result.studies.push_back(study);
    };
    for (const Source &source : sources_of(base))
      enter(study_of(input, source, log), source.part);
    log("finite_radius: a/R");
    enter(study_finite_radius(input, base, result.solution), &ErrorParts::finite_radius);
    return result;
  }
} // namespace dpcontact
