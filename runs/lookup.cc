#include "runs/lookup.h"

#include "database/checks.h"
#include "database/exports.h"
#include "database/text.h"
#include "fitting/curve_fit.h"
#include "fitting/uncertainty.h"
#include "meshing/errors.h"

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

    /// Of c 2^−p from those of c and p, and back.
    double converted_uncertainty(const double value, const double relative, const double exponent)
    {
      return std::abs(value) * std::hypot(relative, std::log(2.) * exponent);
    }

    void require_similar(const Case &input)
    {
      const Material &material = input.material;
      if (material.criterion != Criterion::drucker_prager || material.flow_stress_ratio != 1 ||
          material.flow_angle() != material.friction_angle || material.hardening != 0)
        throw InputError(
          "lookup: the tables hold associated, perfectly plastic drucker-prager with K = 1 "
          "only; solve computes the others");
    }

    /// Outside the data none is known.
    void forget_uncertainty(LookupResult &result)
    {
      constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
      result.uncertainty.fill(unknown);
      result.published_uncertainty.fill(unknown);
      for (auto &part : result.parts)
        part.fill(unknown);
      result.peak_approach_uncertainty = result.residual_approach_uncertainty = unknown;
    }

    /// Approaches of the power laws, and the first order of their uncertainty.
    void enter_approaches(LookupResult &result)
    {
      const auto [a, b, m, n]     = result.coefficients;
      const auto [ua, ub, um, un] = result.uncertainty;
      const double level = result.load_level, scale = result.yield.approach;
      const double peak      = power_law_approach(a, b, level),
                   recovered = power_law_approach(m, n, level);
      const auto spread =
        [&](const double value, const double c, const double p, const double uc, const double up) {
          return std::hypot(value / p * uc / c, value * std::log(value) / p * up);
        };
      result.peak_approach             = peak * scale;
      result.peak_approach_uncertainty = spread(peak, a, b, ua, ub) * scale;
      result.residual_eq18 = result.residual_approach = (peak - recovered) * scale;
      result.residual_approach_uncertainty =
        std::hypot(result.peak_approach_uncertainty, spread(recovered, m, n, um, un) * scale);
    }
  } // namespace

  const char *to_string(const LookupMethod method)
  {
    switch (method)
      {
        case LookupMethod::similarity:
          return "similarity";
        case LookupMethod::kriging:
          return "kriging";
        case LookupMethod::natural_neighbour:
          return "natural-neighbour";
        case LookupMethod::regression:
          return "regression";
        case LookupMethod::table_2:
          break;
      }
    return "table-2";
  }

  LookupMethod parse_lookup_method(const std::string &name)
  {
    for (const LookupMethod method : {LookupMethod::similarity,
                                      LookupMethod::kriging,
                                      LookupMethod::natural_neighbour,
                                      LookupMethod::regression,
                                      LookupMethod::table_2})
      if (name == to_string(method))
        return method;
    throw InputError("method: '" + name +
                     "' is not one of similarity, kriging, natural-neighbour, regression, table-2");
  }

  std::filesystem::path default_database(const LookupMethod method)
  {
    return std::filesystem::path(DPCONTACT_DATABASE_DIRECTORY) /
           (method == LookupMethod::similarity ? "universal.csv" : "wang2018.csv");
  }

  struct LookupTable::Content
  {
    LookupMethod                    method;
    std::optional<UniversalTable>   universal;
    MaterialTable                   materials;
    std::unique_ptr<MaterialMethod> estimator;

    LookupResult by_similarity(const Case &input, LookupResult result, const Outside outside) const
    {
      const UniversalFamily family(
        *universal, input.material.poisson_ratio, input.friction_angle_degrees, outside);
      const double         level = result.load_level, scale = result.yield.approach;
      const UniversalValue value = family.at(level, outside);

      // the contact's edge at most as far out as Hertz's relation a² = R* δ says
      const double kappa =
        result.yield.contact_radius / input.scene.radius * std::sqrt(value.approach);
      const double excess = value.approach / std::pow(level, 2. / 3) - 1;
      const auto   finite = finite_radius_errors(excess, kappa);
      result.coefficients = value.coefficients;
      for (std::size_t c = 0; c < 4; ++c)
        {
          const double finite_radius = std::abs(value.coefficients[c]) * finite[c];
          result.uncertainty[c]      = value.interpolation[c] + value.numerical[c] + finite_radius;
          result.parts[0][c]         = value.interpolation[c];
          result.parts[1][c]         = value.numerical[c];
          result.parts[2][c]         = finite_radius;
          result.parts[3][c]         = value.misfit[c];
        }
      result.peak_approach                 = value.approach * scale;
      result.peak_approach_uncertainty     = value.approach * value.approach_error * scale;
      result.residual_approach             = value.residual_approach * scale;
      result.residual_approach_uncertainty = value.residual_error * scale;
      result.residual_eq18                 = value.residual_eq18 * scale;
      result.residual_of_law               = value.residual_of_law * scale;
      result.law_exponent                  = value.law_exponent;
      for (unsigned int i = 0; i <= master_points; ++i)
        {
          CurvePoint   point;
          const double here = level * std::pow(double(i) / master_points, 1.5);
          point.force       = here * result.yield.force;
          point.approach    = family.approach(here, outside) * scale;
          result.loading.push_back(point);
        }
      return result;
    }

    LookupResult by_material(const Case &input, LookupResult result, const Outside outside) const
    {
      const MaterialPoint point{input.material.youngs_modulus,
                                input.material.poisson_ratio,
                                input.friction_angle_degrees,
                                input.material.compressive_strength};
      materials.check_inside(point, outside);
      check_range("radius", input.scene.radius, materials.radius, materials.radius, outside);
      check_range(
        "force-max", input.scene.force_max, materials.force_max, materials.force_max, outside);
      const MaterialEstimate estimate = estimator->at(point);
      result.published                = estimate.value;
      result.published_uncertainty    = estimate.uncertainty;
      const auto [a, b, m, n]         = estimate.value;
      const auto &u                   = estimate.uncertainty;
      result.coefficients             = {a * std::exp2(b), b, m * std::exp2(n), n};
      result.uncertainty = {converted_uncertainty(result.coefficients[0], u[0] / a, u[1]),
                            u[1],
                            converted_uncertainty(result.coefficients[2], u[2] / m, u[3]),
                            u[3]};
      enter_approaches(result);
      result.residual_of_law = result.residual_eq18;
      result.law_exponent    = n;
      return result;
    }
  };

  LookupTable::LookupTable(const LookupMethod method, const std::filesystem::path &database)
    : content(std::make_unique<Content>())
  {
    content->method = method;
    if (method == LookupMethod::similarity)
      {
        content->universal = UniversalTable::read(database);
        refuse_errors(check(*content->universal), database);
        return;
      }
    const Database rows = read_database(database);
    refuse_errors(check(rows), database);
    content->materials = MaterialTable::from_rows(rows);
    content->estimator =
      method == LookupMethod::kriging             ? make_kriging(content->materials)
      : method == LookupMethod::natural_neighbour ? make_natural_neighbour(content->materials)
      : method == LookupMethod::regression        ? make_regression(regress(content->materials))
                                                  : make_regression(table_2());
  }
  LookupTable::~LookupTable()                       = default;
  LookupTable::LookupTable(LookupTable &&) noexcept = default;

  LookupResult LookupTable::at(const Case &input, const Outside outside) const
  {
    require_similar(input);
    if (outside == Outside::refuse)
      return estimate(input, outside);
    try
      {
        return estimate(input, Outside::refuse);
      }
    catch (const InputError &)
      {
        LookupResult result = estimate(input, outside);
        forget_uncertainty(result);
        return result;
      }
  }

  LookupResult LookupTable::estimate(const Case &input, const Outside outside) const
  {
    LookupResult result{};
    result.method     = content->method;
    result.yield      = first_yield(input.material, input.scene.radius);
    result.load_level = input.scene.force_max / result.yield.force;
    for (auto &part : result.parts)
      part.fill(std::numeric_limits<double>::quiet_NaN());
    if (content->method != LookupMethod::similarity)
      return content->by_material(input, result, outside);
    result                       = content->by_similarity(input, result, outside);
    const auto [a, b, m, n]      = result.coefficients;
    const auto &u                = result.uncertainty;
    result.published             = {a * std::exp2(-b), b, m * std::exp2(-n), n};
    result.published_uncertainty = {converted_uncertainty(result.published[0], u[0] / a, u[1]),
                                    u[1],
                                    converted_uncertainty(result.published[2], u[2] / m, u[3]),
                                    u[3]};
    return result;
  }

  namespace
  {
    /// Without what is not known: numbers that are not set, empty texts, and what holds no other.
    Json known(const Json &whole)
    {
      Json part = Json::object();
      for (const auto &[name, value] : whole.items())
        if (value.is_object())
          {
            if (Json inner = known(value); !inner.empty())
              part[name] = std::move(inner);
          }
        else if (!(value.is_number_float() && std::isnan(value.get<double>())) && value != "")
          part[name] = value;
      return part;
    }

    Json by_name(const std::array<double, 4> &values)
    {
      return {{"a", values[0]}, {"b", values[1]}, {"m", values[2]}, {"n", values[3]}};
    }

    /// Of similarity the master curve and the contact law's unloading, else the power laws.
    Json curve_json(const LookupResult &result, const unsigned int points)
    {
      const auto [a, b, m, n] = result.coefficients;
      const double force = result.yield.force, approach = result.yield.approach;
      Json         curve{{"loading", Json::array()}, {"unloading", Json::array()}};
      const auto   add = [](Json &branch, const double d, const double f) {
        branch.push_back({{"approach", d}, {"force", f}});
      };
      if (!result.loading.empty())
        {
          const auto interpolate = [&](const double share) {
            const double at     = share * static_cast<double>(result.loading.size() - 1);
            const auto   below  = std::min(static_cast<std::size_t>(at), result.loading.size() - 2);
            const double t      = at - static_cast<double>(below);
            const CurvePoint &p = result.loading[below], &q = result.loading[below + 1];
            return p.approach + t * (q.approach - p.approach);
          };
          for (unsigned int i = 0; i <= points; ++i)
            {
              const double share = double(i) / points;
              add(curve["loading"],
                  interpolate(share),
                  result.load_level * force * std::pow(share, 1.5));
            }
        }
      else
        for (unsigned int i = 0; i <= points; ++i)
          {
            const double x = result.peak_approach / approach * i / points;
            add(curve["loading"], x * approach, a * std::pow(x, b) * force);
          }
      for (unsigned int i = points + 1; i-- > 0;)
        {
          const double share = double(i) / points, residual = result.residual_of_law;
          add(curve["unloading"],
              residual + share * (result.peak_approach - residual),
              result.load_level * force * std::pow(share, result.law_exponent));
        }
      return curve;
    }
  } // namespace

  Json lookup_json(const Case &input, const LookupResult &result, const unsigned int curve_points)
  {
    Record row;
    row.a                          = result.coefficients[0];
    row.b                          = result.coefficients[1];
    row.m                          = result.coefficients[2];
    row.n                          = result.coefficients[3];
    row.approach_residual_eq18_m   = result.residual_eq18;
    row.a_published                = result.published[0];
    row.m_published                = result.published[2];
    row.approach_yield_published_m = result.yield.approach / 2;
    Json document                  = {
                       {"method", to_string(result.method)},
                       {"material", material_json(input)},
                       {"scene", scene_json(input)},
                       {"yield", yield_json(result.yield)},
                       {"load_level", result.load_level},
                       {"fit", fit_json(row)},
                       {"uncertainty", by_name(result.uncertainty)},
                       {"published_convention", published_json(row)},
                       {"published_uncertainty", by_name(result.published_uncertainty)},
                       {"peak",
                        {{"force", input.scene.force_max},
                         {"approach", result.peak_approach},
                         {"approach_uncertainty", result.peak_approach_uncertainty}}},
                       {"residual_approach", result.residual_approach},
                       {"residual_approach_uncertainty", result.residual_approach_uncertainty},
                       // closed forms; the place on the axis is found to rounding
                       {"yield_uncertainty",
                        {{"force", 1e-9 * result.yield.force}, {"approach", 1e-9 * result.yield.approach}}}};
    if (result.method == LookupMethod::similarity)
      document["uncertainty_parts"] = {{"interpolation", by_name(result.parts[0])},
                                       {"numerical", by_name(result.parts[1])},
                                       {"finite_radius", by_name(result.parts[2])},
                                       {"power_law_misfit", by_name(result.parts[3])}};
    document = known(document);
    if (curve_points > 0)
      document["curve"] = curve_json(result, curve_points);
    return document;
  }

  std::string describe(const Case &input, const LookupResult &result)
  {
    const auto number = [](const double value) {
      return format_quantity(value, Dimension::number);
    };
    const auto length = [](const double value) {
      return format_quantity(value, Dimension::length);
    };
    const auto plus_minus = [](const double uncertainty, const Dimension dimension) {
      return std::isnan(uncertainty) ? "" : " +- " + format_quantity(uncertainty, dimension);
    };
    std::string text = label(input) + "\n" + describe(result.yield) + "\nby        " +
                       to_string(result.method) + ", F_max/F_y = " + number(result.load_level) +
                       "\nlaw       ";
    for (std::size_t c = 0; c < 4; ++c)
      text += (c ? ", " : "") + std::string(1, "abmn"[c]) + " = " + number(result.coefficients[c]) +
              plus_minus(result.uncertainty[c], Dimension::number);
    text += "\n          published convention (approach_y per sphere): a = " +
            number(result.published[0]) +
            plus_minus(result.published_uncertainty[0], Dimension::number) +
            ", m = " + number(result.published[2]) +
            plus_minus(result.published_uncertainty[2], Dimension::number);
    if (std::isnan(result.uncertainty[0]))
      text += "\n          of unknown uncertainty";
    return text + "\npeak      approach " + length(result.peak_approach) +
           plus_minus(result.peak_approach_uncertainty, Dimension::length) +
           "\nreleased  residual approach " + length(result.residual_approach) +
           plus_minus(result.residual_approach_uncertainty, Dimension::length) + ", by eq (18) " +
           length(result.residual_eq18) + "\n";
  }

  std::string lookup_csv(const std::vector<std::pair<Case, LookupResult>> &answers)
  {
    std::string text =
      "# Force laws of like spheres: F/F_y = a (delta/delta_y)^b, unloading F/F_y = m ((delta - "
      "delta_res)/delta_y)^n.\n"
      "# Of *_published delta_y is that of one sphere. Quantities in SI, angles in degrees.\n"
      "method,E_Pa,nu,phi_deg,sigma_c_Pa,radius_m,force_max_N,load_level,force_yield_N,"
      "approach_yield_m,a,b,m,n,a_uncertainty,b_uncertainty,m_uncertainty,n_uncertainty,"
      "a_published,m_published,a_published_uncertainty,m_published_uncertainty,approach_peak_m,"
      "approach_peak_uncertainty_m,approach_residual_m,approach_residual_uncertainty_m\n";
    for (const auto &[input, found] : answers)
      {
        text += to_string(found.method);
        const auto &c = found.coefficients, &u = found.uncertainty;
        for (const double value : {input.material.youngs_modulus,
                                   input.material.poisson_ratio,
                                   input.friction_angle_degrees,
                                   input.material.compressive_strength,
                                   input.scene.radius,
                                   input.scene.force_max,
                                   found.load_level,
                                   found.yield.force,
                                   found.yield.approach,
                                   c[0],
                                   c[1],
                                   c[2],
                                   c[3],
                                   u[0],
                                   u[1],
                                   u[2],
                                   u[3],
                                   found.published[0],
                                   found.published[2],
                                   found.published_uncertainty[0],
                                   found.published_uncertainty[2],
                                   found.peak_approach,
                                   found.peak_approach_uncertainty,
                                   found.residual_approach,
                                   found.residual_approach_uncertainty})
          text += std::isnan(value) ? "," : "," + number_text(value);
        text += '\n';
      }
    return text;
  }
} // namespace dpcontact
