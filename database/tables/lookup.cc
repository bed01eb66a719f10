#include "database/tables/lookup.h"

#include "database/rows/checks.h"
#include "database/rows/exports.h"
#include "database/rows/uncertainty.h"
#include "database/tables/material_table.h"
#include "database/tables/universal_checks.h"
#include "fitting/conventions.h"
#include "meshing/errors.h"
#include "solver/closed_form/plausibility.h"
#include "solver/problem/quantity.h"

#include <cmath>
#include <optional>

namespace dpcontact
{
  namespace
  {
    constexpr unsigned int master_points = 200;

    double power_law_approach(const double coefficient, const double exponent, const double level)
    {
      return std::pow(level / coefficient, 1 / exponent);
    }

    /// Outside the data none is known.
    void forget_uncertainty(LookupResult &result)
    {
      result.uncertainty                   = {};
      result.published_uncertainty         = {};
      result.parts                         = {};
      result.peak_approach.uncertainty     = Coefficients::unset;
      result.residual_approach.uncertainty = Coefficients::unset;
    }

    /// Uncertainties of a, b, m, n in the other convention, whose coefficients are `converted`.
    Coefficients converted_uncertainties(const Coefficients &converted,
                                         const Coefficients &values,
                                         const Coefficients &uncertainty)
    {
      return {converted_uncertainty(converted.a, uncertainty.a / values.a, uncertainty.b),
              uncertainty.b,
              converted_uncertainty(converted.m, uncertainty.m / values.m, uncertainty.n),
              uncertainty.n};
    }

    /// The relative error of an approach that the relative errors of a coefficient and its exponent
    /// make which a finite radius leaves in them.
    double
    finite_radius_error(const double approach, const double exponent, const double *const errors)
    {
      return approach > 0
               ? (errors[0] + std::abs(std::log(approach)) * exponent * errors[1]) / exponent
               : 0.;
    }

    /// What no contact does is no answer, however it was come by.
    void require_possible(const LookupResult &result)
    {
      const Coefficients &law    = result.coefficients;
      const auto          refuse = [&](const std::string &what) {
        throw InputError(std::string("lookup: method ") + to_string(result.method) +
                         " has no possible law here: " + what +
                         "; solve computes the case, --method similarity knows more of them");
      };
      const auto number = [](const double value) {
        return format_quantity(value, Dimension::number);
      };
      for (std::size_t c = 0; c < coefficient_names.size(); ++c)
        if (!(std::isfinite(law[c]) && law[c] > 0))
          refuse(std::string(coefficient_names[c]) + " is " + number(law[c]) +
                 ", which is not finite and positive");
      if (!(law.n >= 1))
        refuse("the exponent of unloading n is " + number(law.n) + ", below 1");
      const double peak = result.peak_approach.value, residual = result.residual_approach.value;
      if (!(std::isfinite(peak) && peak > 0))
        refuse("the approach at the peak is " + number(peak) + " m");
      // Where nothing yields it is zero but for rounding, or for what a method does not know.
      const double unknown = std::isnan(result.residual_approach.uncertainty)
                               ? 0.
                               : result.residual_approach.uncertainty;
      if (!(residual < peak) || !(residual >= -std::max(1e-9 * peak, unknown)))
        refuse("the residual approach is " + number(residual / peak) +
               " of that at the peak, outside 0 to 1");
    }

    /// Approaches of the power laws, and the first order of their uncertainty.
    void enter_approaches(LookupResult &result)
    {
      const Coefficients &c = result.coefficients, &u = result.uncertainty;
      const double        level = result.load_level, scale = result.yield.approach;
      const double        peak = power_law_approach(c.a, c.b, level),
                   recovered   = power_law_approach(c.m, c.n, level);
      const auto spread =
        [](const double value, const double k, const double p, const double uk, const double up) {
          return std::hypot(value / p * uk / k, value * std::log(value) / p * up);
        };
      result.peak_approach     = {peak * scale, spread(peak, c.a, c.b, u.a, u.b) * scale};
      result.residual_eq18     = (peak - recovered) * scale;
      result.residual_approach = {result.residual_eq18,
                                  std::hypot(result.peak_approach.uncertainty,
                                             spread(recovered, c.m, c.n, u.m, u.n) * scale)};
    }
  } // namespace

  struct LookupTable::Content
  {
    LookupMethod                    method;
    std::optional<UniversalTable>   universal;
    MaterialTable                   materials;
    std::unique_ptr<MaterialMethod> estimator;

    void by_similarity(const Case &input, Outside outside, LookupResult &result) const;
    void by_material(const Case &input, Outside outside, LookupResult &result) const;
  };

  void LookupTable::Content::by_similarity(const Case   &input,
                                           const Outside outside,
                                           LookupResult &result) const
  {
    const UniversalFamily family(
      *universal, input.material.poisson_ratio, input.material.friction_angle.degrees(), outside);
    const double         level = result.load_level, scale = result.yield.approach;
    const UniversalValue value = family.at(level, outside);

    // the contact's edge at most as far out as Hertz's relation a² = R* δ says
    const double kappa =
      result.yield.contact_radius / input.scene.radius * std::sqrt(value.approach);
    const double excess = value.approach / std::pow(level, 2. / 3) - 1;
    const auto   finite = finite_radius_errors(excess, kappa);
    result.coefficients = Coefficients::from(value.coefficients);
    for (std::size_t c = 0; c < coefficient_names.size(); ++c)
      {
        const double finite_radius    = std::abs(value.coefficients[c]) * finite[c];
        result.uncertainty[c]         = value.interpolation[c] + value.numerical[c] + finite_radius;
        result.parts.interpolation[c] = value.interpolation[c];
        result.parts.numerical[c]     = value.numerical[c];
        result.parts.finite_radius[c] = finite_radius;
        result.parts.power_law_misfit[c] = value.misfit[c];
      }
    const Coefficients &law = result.coefficients;
    result.published        = {
             published_coefficient(law.a, law.b), law.b, published_coefficient(law.m, law.n), law.n};
    result.published_uncertainty =
      converted_uncertainties(result.published, law, result.uncertainty);
    const double recovered = value.approach - value.residual_approach;
    const double at_peak = value.approach * finite_radius_error(value.approach, law.b, &finite[0]);
    const double on_return   = recovered * finite_radius_error(recovered, law.n, &finite[2]);
    const double residual    = result.elastic() ? 0 : value.residual_error + at_peak + on_return;
    result.peak_approach     = {value.approach * scale,
                                (value.approach * value.approach_error + at_peak) * scale};
    result.residual_approach = {value.residual_approach * scale, residual * scale};
    result.warnings          = doubts_about(input, kappa * input.scene.radius);
    result.residual_eq18     = value.residual_eq18 * scale;
    result.residual_of_law   = value.residual_of_law * scale;
    result.law_exponent      = value.law_exponent;
    for (unsigned int i = 0; i <= master_points; ++i)
      {
        CurvePoint   point;
        const double here = level * std::pow(double(i) / master_points, 1.5);
        point.force       = here * result.yield.force;
        point.approach    = family.approach(here, outside) * scale;
        result.loading.push_back(point);
      }
  }

  void LookupTable::Content::by_material(const Case   &input,
                                         const Outside outside,
                                         LookupResult &result) const
  {
    const MaterialPoint point = MaterialPoint::of(input.material);
    materials.check_inside(point, outside);
    check_range("radius", input.scene.radius, materials.radius, materials.radius, outside);
    check_range(
      "force-max", input.scene.force_max, materials.force_max, materials.force_max, outside);
    const MaterialEstimate   estimate = estimator->at(point);
    const MaterialTable::Row of_rows  = materials.errors_around(point);
    result.published                  = Coefficients::from(estimate.value);
    for (std::size_t c = 0; c < coefficient_names.size(); ++c)
      result.published_uncertainty[c] = estimate.uncertainty[c] + of_rows.error[c];
    const Coefficients &published = result.published;
    result.coefficients           = {consistent_coefficient(published.a, published.b),
                                     published.b,
                                     consistent_coefficient(published.m, published.n),
                                     published.n};
    result.uncertainty =
      converted_uncertainties(result.coefficients, published, result.published_uncertainty);
    enter_approaches(result);
    result.peak_approach.uncertainty += of_rows.peak_misfit * result.peak_approach.value;
    result.residual_approach.uncertainty += of_rows.residual_misfit * result.peak_approach.value;
    result.residual_of_law = result.residual_eq18;
    result.law_exponent    = published.n;
    result.warnings        = doubts_about(input);
  }

  LookupTable::LookupTable(const LookupMethod           method,
                           const std::filesystem::path &database,
                           const EstimatorMaker         make)
    : content(std::make_unique<Content>())
  {
    content->method = method;
    if (method == LookupMethod::similarity)
      {
        content->universal = read_checked_universal(database);
        return;
      }
    content->materials = MaterialTable::from_rows(read_checked_database(database));
    if (method == LookupMethod::table_2)
      content->estimator = make_regression(table_2());
    else if (make != nullptr)
      content->estimator = make(method, content->materials);
    else
      throw InputError(std::string("method ") + to_string(method) + " needs make_estimator()");
  }
  LookupTable::~LookupTable()                       = default;
  LookupTable::LookupTable(LookupTable &&) noexcept = default;

  LookupResult LookupTable::at(const Case &input, const Outside outside, const Laws laws) const
  {
    if (!is_tabulated_kind(input.material))
      throw InputError(std::string("lookup: the tables hold ") + tabulated_kind +
                       " only; solve computes the others");
    if (outside == Outside::refuse)
      return estimate(input, outside, laws);
    try
      {
        return estimate(input, Outside::refuse, laws);
      }
    catch (const InputError &)
      {
        LookupResult result = estimate(input, outside, laws);
        forget_uncertainty(result);
        result.warnings.emplace_back("the case lies outside the data: no uncertainty is known");
        return result;
      }
  }

  LookupResult
  LookupTable::estimate(const Case &input, const Outside outside, const Laws laws) const
  {
    LookupResult result;
    result.method     = content->method;
    result.yield      = first_yield(input.material, input.scene.radius);
    result.load_level = input.scene.force_max / result.yield.force;
    if (content->method == LookupMethod::similarity)
      content->by_similarity(input, outside, result);
    else
      content->by_material(input, outside, result);
    if (laws == Laws::possible)
      require_possible(result);
    return result;
  }
} // namespace dpcontact
