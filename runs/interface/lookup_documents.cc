#include "runs/interface/lookup_documents.h"

#include "database/files/csv.h"
#include "solver/closed_form/plausibility.h"
#include "solver/problem/quantity.h"

#include <algorithm>
#include <cmath>

namespace dpcontact
{
  namespace
  {
    /// Without what is not known: numbers that are not set, and what holds no other.
    Json known(const Json &whole)
    {
      Json part = Json::object();
      for (const auto &[name, value] : whole.items())
        if (value.is_object())
          {
            if (Json inner = known(value); !inner.empty())
              part[name] = std::move(inner);
          }
        else if (!(value.is_number_float() && std::isnan(value.get<double>())))
          part[name] = value;
      return part;
    }

    void add_point(Json &branch, const double approach, const double force)
    {
      branch.push_back({{"approach", approach}, {"force", force}});
    }

    /// The approach of the master curve at a share of its points.
    double master_approach(const std::vector<CurvePoint> &loading, const double share)
    {
      const double      at    = share * static_cast<double>(loading.size() - 1);
      const auto        below = std::min(static_cast<std::size_t>(at), loading.size() - 2);
      const double      t     = at - static_cast<double>(below);
      const CurvePoint &p = loading[below], &q = loading[below + 1];
      return p.approach + t * (q.approach - p.approach);
    }
  } // namespace

  std::filesystem::path default_database(const LookupMethod method)
  {
    return std::filesystem::path(DPCONTACT_DATABASE_DIRECTORY) /
           (method == LookupMethod::similarity ? "universal.csv" : "wang2018.csv");
  }

  Json lookup_curve_json(const LookupResult &result, const unsigned int curve_points)
  {
    const Coefficients &law   = result.coefficients;
    const double        force = result.yield.force, approach = result.yield.approach;
    Json                curve{{"loading", Json::array()}, {"unloading", Json::array()}};
    for (unsigned int i = 0; i <= curve_points; ++i)
      if (!result.loading.empty())
        {
          const double share = double(i) / curve_points;
          add_point(curve["loading"],
                    master_approach(result.loading, share),
                    result.load_level * force * std::pow(share, 1.5));
        }
      else
        {
          const double x = result.peak_approach.value / approach * i / curve_points;
          add_point(curve["loading"], x * approach, law.a * std::pow(x, law.b) * force);
        }
    for (unsigned int i = curve_points + 1; i-- > 0;)
      {
        const double share = double(i) / curve_points, residual = result.residual_of_law;
        add_point(curve["unloading"],
                  residual + share * (result.peak_approach.value - residual),
                  result.load_level * force * std::pow(share, result.law_exponent));
      }
    return curve;
  }

  Json lookup_json(const Case &input, const LookupResult &result, const unsigned int curve_points)
  {
    Json fit                      = by_name(result.coefficients);
    fit["residual_approach_eq18"] = result.residual_eq18;
    Json document                 = {
                      {"method", to_string(result.method)},
                      {"material", material_json(input)},
                      {"scene", scene_json(input)},
                      {"yield", yield_json(result.yield)},
                      {"load_level", result.load_level},
                      {"fit", fit},
                      {"uncertainty", by_name(result.uncertainty)},
                      {"published_convention",
                       published_json({result.published.a, result.published.m, result.yield.approach / 2})},
                      {"published_uncertainty", by_name(result.published_uncertainty)},
                      {"peak",
                       {{"force", input.scene.force_max},
                        {"approach", result.peak_approach.value},
                        {"approach_uncertainty", result.peak_approach.uncertainty}}},
                      {"residual_approach", result.residual_approach.value},
                      {"residual_approach_uncertainty", result.residual_approach.uncertainty},
                      // closed forms; the place on the axis is found to rounding
                      {"yield_uncertainty",
                       {{"force", 1e-9 * result.yield.force}, {"approach", 1e-9 * result.yield.approach}}}};
    if (result.method == LookupMethod::similarity)
      document["uncertainty_parts"] = {
        {"interpolation", by_name(result.parts.interpolation)},
        {"numerical", by_name(result.parts.numerical)},
        {"finite_radius", by_name(result.parts.finite_radius)},
        {"power_law_misfit", by_name(result.parts.power_law_misfit)}};
    document             = known(document);
    document["elastic"]  = result.elastic();
    document["warnings"] = joined(result.warnings);
    if (curve_points > 0)
      document["curve"] = lookup_curve_json(result, curve_points);
    return document;
  }

  std::string describe(const Case &input, const LookupResult &result)
  {
    const auto with = [](const Uncertain &number, const Dimension dimension) {
      return format_uncertain(number.value, number.uncertainty, dimension);
    };
    std::string text = label(input) + "\n" + describe(result.yield) + "\nby        " +
                       to_string(result.method) +
                       ", F_max/F_y = " + format_quantity(result.load_level, Dimension::number) +
                       (result.elastic() ? "; nothing yields: Hertz" : "") + "\nlaw       ";
    for (std::size_t c = 0; c < coefficient_names.size(); ++c)
      text += (c > 0 ? ", " : "") + std::string(coefficient_names[c]) + " = " +
              with({result.coefficients[c], result.uncertainty[c]}, Dimension::number);
    text +=
      "\n          published convention (approach_y per sphere): a = " +
      with({result.published.a, result.published_uncertainty.a}, Dimension::number) +
      ", m = " + with({result.published.m, result.published_uncertainty.m}, Dimension::number);
    if (std::isnan(result.uncertainty.a))
      text += "\n          of unknown uncertainty";
    return text + "\npeak      approach " + with(result.peak_approach, Dimension::length) +
           "\nreleased  residual approach " + with(result.residual_approach, Dimension::length) +
           ", by eq (18) " + format_quantity(result.residual_eq18, Dimension::length) + "\n";
  }

  std::string lookup_csv(const std::vector<LookupAnswer> &answers)
  {
    CsvFormat format;
    format.nan = CsvFormat::NotANumber::empty;
    CsvWriter csv(format);
    csv.comment(
      "Force laws of like spheres: F/F_y = a (delta/delta_y)^b, unloading F/F_y = m ((delta - "
      "delta_res)/delta_y)^n.\n"
      "Of *_published delta_y is that of one sphere. Quantities in SI, angles in degrees.");
    std::vector<std::string> names = {"method"};
    for (const CaseParameter &parameter : stored_parameters())
      if (parameter.owners.empty()) // what the tables hold has no others
        names.push_back(parameter.column());
    names.insert(names.end(),
                 {"load_level",
                  "force_yield_N",
                  "approach_yield_m",
                  "a",
                  "b",
                  "m",
                  "n",
                  "a_uncertainty",
                  "b_uncertainty",
                  "m_uncertainty",
                  "n_uncertainty",
                  "a_published",
                  "m_published",
                  "a_published_uncertainty",
                  "m_published_uncertainty",
                  "approach_peak_m",
                  "approach_peak_uncertainty_m",
                  "approach_residual_m",
                  "approach_residual_uncertainty_m",
                  "warnings",
                  "status"});
    csv.header(names);
    for (const auto &[input, found, refused] : answers)
      {
        csv.add(std::string(to_string(found.method)));
        for (const CaseParameter &parameter : stored_parameters())
          if (parameter.owners.empty())
            csv.add(parameter.get(input));
        for (const double value : {found.load_level, found.yield.force, found.yield.approach})
          csv.add(value);
        for (const Coefficients *const values : {&found.coefficients, &found.uncertainty})
          for (std::size_t c = 0; c < coefficient_names.size(); ++c)
            csv.add((*values)[c]);
        for (const double value : {found.published.a,
                                   found.published.m,
                                   found.published_uncertainty.a,
                                   found.published_uncertainty.m,
                                   found.peak_approach.value,
                                   found.peak_approach.uncertainty,
                                   found.residual_approach.value,
                                   found.residual_approach.uncertainty})
          csv.add(value);
        csv.add(joined(found.warnings));
        csv.add(refused.empty() ? std::string("answered") : refused);
        csv.end_row();
      }
    return csv.text();
  }
} // namespace dpcontact
