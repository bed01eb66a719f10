#include "runs/interface/documents.h"

#include "solver/closed_form/first_yield.h"
#include "solver/laws/criterion.h"
#include "solver/output/plastic_zone.h"
#include "solver/problem/option_list.h"
#include "solver/problem/quantity.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace dpcontact
{
  namespace
  {
    /// What is not known, or not there, is null.
    Json number_json(const double value) { return std::isnan(value) ? Json() : Json(value); }

    /// Those of all criteria, then the criterion's own.
    void enter_parameters(const Material &material, Json &json)
    {
      const auto enter = [&](const MaterialParameter &parameter) {
        if (parameter.get)
          json[parameter.key()] = number_json(parameter.get(material));
      };
      for (const MaterialParameter &parameter : material_parameters())
        if (parameter.owners.empty())
          enter(parameter);
      for (const MaterialParameter &own : definition_of(material.criterion).parameters)
        enter(own);
    }
  } // namespace

  Json material_json(const Case &input)
  {
    Json json = {{"criterion", to_string(input.material.criterion)}};
    enter_parameters(input.material, json);
    return json;
  }

  Json scene_json(const Case &input)
  {
    Json json;
    for (const CaseParameter &parameter : stored_parameters())
      if (parameter.of_scene)
        json[parameter.key()] = parameter.get(input);
    if (const auto &second = input.scene.second)
      {
        Json &body = json["second"];
        body       = {{"radius", std::isinf(second->radius) ? Json("flat") : Json(second->radius)},
                      {"rigid", !second->material}};
        if (second->material)
          enter_parameters(*second->material, body);
      }
    return json;
  }

  std::string describe_checks(const PathChecks &checks)
  {
    if (checks.largest_work == 0)
      return "";
    const auto number = [](const double value) {
      return format_quantity(value, Dimension::number);
    };
    return "checks    residual " + number(checks.residual) + ", yield exceeded by " +
           number(std::max(0., checks.yield_excess)) + " of the strength, contact violated by " +
           number(checks.penetration) + " of the approach, energy balance " +
           number(checks.energy_error / checks.largest_work) +
           " of the work (backward Euler's gap " + number(checks.energy_gap()) + ")\n";
  }

  Json checks_json(const PathChecks &checks)
  {
    return {{"residual", checks.residual},
            {"yield_excess", checks.yield_excess},
            {"penetration", checks.penetration},
            {"work", checks.work},
            {"largest_work", checks.largest_work},
            {"elastic_energy", checks.elastic_energy},
            {"dissipation", checks.dissipation},
            {"mean_dissipation", checks.mean_dissipation},
            {"energy_error", checks.energy_error},
            {"energy_gap", checks.energy_gap()}};
  }

  Json yield_json(const FirstYield &yield)
  {
    return {{"force", yield.force},
            {"approach", yield.approach},
            {"pressure", yield.pressure},
            {"contact_radius", yield.contact_radius},
            {"depth_over_contact_radius", yield.depth_over_contact_radius},
            {"ring_force", yield.ring_force},
            {"ring_pressure", yield.ring_pressure},
            {"body_forces",
             {yield.body_force[0],
              std::isinf(yield.body_force[1]) ? Json() : Json(yield.body_force[1])}}};
  }

  namespace
  {
    Json region_json(const std::optional<PlasticRegion> &region)
    {
      if (!region)
        return nullptr;
      Json json = {{"radius_min", region->radius_min},
                   {"radius_max", region->radius_max},
                   {"depth_min", region->depth_min},
                   {"depth_max", region->depth_max},
                   {"volume", region->volume},
                   {"cells", region->cells},
                   {"surface", nullptr}};
      if (region->surface)
        json["surface"] = {{"radius_min", region->surface->radius_min},
                           {"radius_max", region->surface->radius_max}};
      return json;
    }
  } // namespace

  Json plastic_zone_json(const std::optional<PlasticZone> &zone)
  {
    if (!zone)
      return nullptr;
    return {{"contact_radius", zone->contact_radius},
            {"cell_size", zone->cell_size},
            {"core", region_json(zone->core)},
            {"ring", region_json(zone->ring)},
            {"ring_parts", zone->ring_parts},
            {"other_regions", zone->other_regions},
            {"axis_depth_min", zone->axis_depth_min},
            {"axis_depth_max", zone->axis_depth_max},
            {"core_reaches_free_surface", zone->core_reaches_free_surface},
            {"elastic_cap", zone->elastic_cap}};
  }

  Json options_json(const SolverOptions &used)
  {
    Json json;
    for (const SolverOption &option : solver_options())
      if (option.counts(used))
        std::visit([&](const auto &value) { json[option.name] = value; }, option.get(used));
    return json;
  }

  Json by_name(const Coefficients &values)
  {
    Json json;
    for (std::size_t c = 0; c < coefficient_names.size(); ++c)
      json[coefficient_names[c]] = values[c];
    return json;
  }

  namespace
  {
    Json quality_json(const FitQuality &quality)
    {
      return {{"r2", quality.r2}, {"rmse", quality.rmse}};
    }

    Json three_parameter_json(const ThreeParameterRow &fit)
    {
      return {{"m", fit.m},
              {"n", fit.n},
              {"residual_approach", fit.approach_residual},
              {"standard_error",
               {{"m", fit.m_standard_error},
                {"n", fit.n_standard_error},
                {"residual_approach", fit.approach_residual_standard_error}}},
              {"r2", fit.quality.r2},
              {"rmse", fit.quality.rmse},
              {"stop", fit.stop}};
    }

    Json rival_forms_json(const BranchFitRow &branch)
    {
      return {{"exponential", quality_json(branch.exponential)},
              {"polynomial", quality_json(branch.polynomial)},
              {"parabola", quality_json(branch.parabola)}};
    }
  } // namespace

  Json fit_json(const Record &row)
  {
    const BranchFitRow &loading = row.fit.loading, &unloading = row.fit.unloading;
    Json                json = by_name(row.law);
    json.update(
      {{"standard_error", by_name(row.fit.standard_error)},
       {"covariance", {{"ab", loading.covariance}, {"mn", unloading.covariance}}},
       {"window_change", by_name(row.fit.window_change)},
       {"r2_loading", loading.power_law.r2},
       {"r2_unloading", unloading.power_law.r2},
       {"rmse_loading", loading.power_law.rmse},
       {"rmse_unloading", unloading.power_law.rmse},
       {"stop_loading", loading.stop},
       {"stop_unloading", unloading.stop},
       {"residual_approach_eq18", row.state.approach_residual_eq18},
       {"three_parameter", three_parameter_json(row.fit.three_parameter)},
       {"alternatives",
        {{"loading", rival_forms_json(loading)}, {"unloading", rival_forms_json(unloading)}}}});
    return json;
  }

  Json error_json(const ErrorParts &parts, const double total)
  {
    Json json;
    for (const ErrorSource &source : error_sources)
      json[source.name] = parts.*source.member;
    json["total"] = total;
    return json;
  }

  Json error_json(const Record &row)
  {
    Json json;
    for (std::size_t c = 0; c < coefficient_names.size(); ++c)
      json[coefficient_names[c]] = error_json(row.error[c].parts, row.error[c].total);
    return json;
  }

  Json published_json(const PublishedRow &published)
  {
    return {{"a", published.a}, {"m", published.m}, {"approach_yield", published.approach_yield}};
  }

  Json cost_json(const Record &row)
  {
    return {{"dofs", row.cost.dofs},
            {"steps", row.cost.steps},
            {"newton_iterations", row.cost.newton_iterations},
            {"cut_backs", row.cost.cut_backs},
            {"wall_seconds", row.cost.wall_seconds},
            {"peak_memory_bytes", row.cost.peak_memory_bytes}};
  }

  std::string describe(const FirstYield &yield)
  {
    return "yield     on the axis at F = " + format_quantity(yield.force, Dimension::force) +
           ", approach " + format_quantity(yield.approach, Dimension::length) +
           " (mutual), Hertz pressure " + format_quantity(yield.pressure, Dimension::pressure) +
           ", contact radius " + format_quantity(yield.contact_radius, Dimension::length) +
           ", depth " + format_quantity(yield.depth_over_contact_radius, Dimension::number) +
           " contact radii\n          on the ring at F = " +
           format_quantity(yield.ring_force, Dimension::force) + ", Hertz pressure " +
           format_quantity(yield.ring_pressure, Dimension::pressure);
  }

  std::string describe_fit(const Record &row)
  {
    const auto with_error = [&row](const std::size_t c) {
      return format_uncertain(row.law[c], row.error[c].total, Dimension::number);
    };
    const auto quality = [](const FitQuality &of) {
      return ", R2 = " + format_quantity(of.r2, Dimension::number) +
             ", RMSE = " + format_quantity(of.rmse, Dimension::number) + " of the peak force";
    };
    return "loading   F/F_y = a (approach/approach_y)^b: a = " + with_error(0) +
           ", b = " + with_error(1) + quality(row.fit.loading.power_law) +
           "\nunloading F/F_y = m ((approach - residual)/approach_y)^n: m = " + with_error(2) +
           ", n = " + with_error(3) + quality(row.fit.unloading.power_law) +
           "\n          published convention (approach_y per sphere): a = " +
           format_quantity(row.fit.published.a, Dimension::number) +
           ", m = " + format_quantity(row.fit.published.m, Dimension::number);
  }

  void print_document(const Json &document) { std::cout << document.dump(2) << '\n'; }
} // namespace dpcontact
