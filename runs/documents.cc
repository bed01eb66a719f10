#include "runs/documents.h"

#include "runs/row.h"
#include "solver/laws/mohr_coulomb.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace dpcontact
{
  Json material_json(const Case &input)
  {
    const Material &material = input.material;
    Json            json     = {{"criterion", to_string(material.criterion)},
                                {"E", material.youngs_modulus},
                                {"nu", material.poisson_ratio},
                                {"phi_deg", input.friction_angle_degrees},
                                {"sigma_c", material.compressive_strength}};
    if (material.criterion == Criterion::drucker_prager)
      json["flow_stress_ratio"] = material.flow_stress_ratio;
    if (material.criterion != Criterion::von_mises)
      json["dilation_deg"] = input.dilation_angle_degrees;
    if (material.criterion != Criterion::mohr_coulomb)
      json["hardening"] = material.hardening;
    else
      {
        json["cohesion"] =
          laws::mohr_coulomb_cohesion(material.friction_angle, material.compressive_strength);
        json["tension_cutoff"] = material.tension_cutoff ? Json(*material.tension_cutoff) : Json();
      }
    return json;
  }

  Json scene_json(const Case &input)
  {
    Json json = {{"radius", input.scene.radius}, {"force_max", input.scene.force_max}};
    if (const auto &second = input.scene.second)
      {
        Json &body = json["second"];
        body       = {{"radius", std::isinf(second->radius) ? Json("flat") : Json(second->radius)},
                      {"rigid", !second->material}};
        if (second->material)
          body.update({{"E", second->material->youngs_modulus},
                       {"nu", second->material->poisson_ratio},
                       {"phi_deg", second->material->friction_angle * (180 / M_PI)},
                       {"sigma_c", second->material->compressive_strength}});
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
    const auto on_off = [](const bool value) { return value ? "on" : "off"; };
    Json       json   = {
              {"mesh", to_string(used.mesh)},
              {"resolution", used.resolution},
              {"surface-halvings", used.surface_halvings ? std::to_string(*used.surface_halvings) : "auto"},
              {"element", to_string(used.element)},
              {"level", used.level},
              {"octaves", used.octaves},
              {"domain-radius", used.domain_radius},
              {"mesh-stretch", used.mesh_stretch},
              {"mesh-distortion", used.mesh_distortion},
              {"step-tolerance", used.step_tolerance},
              {"loading-steps", used.loading_steps},
              {"extrapolation", on_off(used.extrapolation)},
              {"predictor", on_off(used.predictor)},
              {"condensation", on_off(used.condensation)},
              {"closed-form", on_off(used.closed_form)},
              {"contact", used.contact == ContactMethod::penalty ? "penalty" : "augmented"},
              {"penalty-stiffness", used.penalty_stiffness},
              {"units", used.units == Units::si ? "si" : "scaled"},
              {"surface", used.surface == Surface::sphere ? "sphere" : "parabola"}};
    if (used.mesh == MeshKind::published)
      json["outer-radius"] = used.outer_radius;
    if (in_space(used.geometry))
      json.update({{"geometry", to_string(used.geometry)},
                   {"sector-angle", used.sector_angle},
                   {"linear-solver", to_string(used.linear_solver)}});
    return json;
  }

  Json fit_json(const Record &row)
  {
    const auto quality = [](const double r2, const double rmse) {
      return Json{{"r2", r2}, {"rmse", rmse}};
    };
    return {
      {"a", row.a},
      {"b", row.b},
      {"m", row.m},
      {"n", row.n},
      {"standard_error",
       {{"a", row.a_standard_error},
        {"b", row.b_standard_error},
        {"m", row.m_standard_error},
        {"n", row.n_standard_error}}},
      {"covariance", {{"ab", row.ab_covariance}, {"mn", row.mn_covariance}}},
      {"window_change",
       {{"a", row.a_window_change},
        {"b", row.b_window_change},
        {"m", row.m_window_change},
        {"n", row.n_window_change}}},
      {"r2_loading", row.r2_loading},
      {"r2_unloading", row.r2_unloading},
      {"rmse_loading", row.rmse_loading},
      {"rmse_unloading", row.rmse_unloading},
      {"stop_loading", row.stop_loading},
      {"stop_unloading", row.stop_unloading},
      {"residual_approach_eq18", row.approach_residual_eq18_m},
      {"three_parameter",
       {{"m", row.m_three_parameter},
        {"n", row.n_three_parameter},
        {"residual_approach", row.approach_residual_three_parameter_m},
        {"standard_error",
         {{"m", row.m_three_parameter_standard_error},
          {"n", row.n_three_parameter_standard_error},
          {"residual_approach", row.approach_residual_three_parameter_standard_error_m}}},
        {"r2", row.r2_three_parameter},
        {"rmse", row.rmse_three_parameter},
        {"stop", row.stop_three_parameter}}},
      {"alternatives",
       {{"loading",
         {{"exponential", quality(row.r2_exponential_loading, row.rmse_exponential_loading)},
          {"polynomial", quality(row.r2_polynomial_loading, row.rmse_polynomial_loading)},
          {"parabola", quality(row.r2_parabola_loading, row.rmse_parabola_loading)}}},
        {"unloading",
         {{"exponential", quality(row.r2_exponential_unloading, row.rmse_exponential_unloading)},
          {"polynomial", quality(row.r2_polynomial_unloading, row.rmse_polynomial_unloading)},
          {"parabola", quality(row.r2_parabola_unloading, row.rmse_parabola_unloading)}}}}}};
  }

  Json error_json(const Record &row)
  {
    static const char *const names[]   = {"a", "b", "m", "n"};
    static const char *const sources[] = {
      "mesh", "step", "contact", "far_field", "finite_radius", "fit", "total"};
    const auto columns = error_columns();
    Json       errors;
    for (std::size_t c = 0; c < columns.size(); ++c)
      for (std::size_t p = 0; p < columns[c].size(); ++p)
        errors[names[c]][sources[p]] = row.*columns[c][p];
    return errors;
  }

  Json published_json(const Record &row)
  {
    return {{"a", row.a_published},
            {"m", row.m_published},
            {"approach_yield", row.approach_yield_published_m}};
  }

  Json cost_json(const Record &row)
  {
    return {{"dofs", row.dofs},
            {"steps", row.steps},
            {"newton_iterations", row.newton_iterations},
            {"cut_backs", row.cut_backs},
            {"wall_seconds", row.wall_seconds},
            {"peak_memory_bytes", row.peak_memory_bytes}};
  }

  std::string label(const Case &input)
  {
    const Material &material = input.material;
    const bool      metal    = material.criterion == Criterion::von_mises;
    std::string     text;
    const auto      add = [&](const char *name, const double value, const Dimension dimension) {
      text +=
        (text.empty() ? "" : ", ") + std::string(name) + " = " + format_quantity(value, dimension);
    };
    add("E", material.youngs_modulus, Dimension::pressure);
    add("nu", material.poisson_ratio, Dimension::number);
    if (!metal)
      add("phi", input.friction_angle_degrees, Dimension::angle);
    add(metal ? "yield stress" : "sigma_c", material.compressive_strength, Dimension::pressure);
    if (material.flow_stress_ratio != 1)
      add("K", material.flow_stress_ratio, Dimension::number);
    if (material.dilation_angle)
      add("psi", input.dilation_angle_degrees, Dimension::angle);
    if (material.hardening != 0)
      add("H", material.hardening, Dimension::pressure);
    if (material.tension_cutoff)
      add("T0", *material.tension_cutoff, Dimension::pressure);
    add("R", input.scene.radius, Dimension::length);
    add("F_max", input.scene.force_max, Dimension::force);
    if (const auto &second = input.scene.second)
      {
        text += "; against ";
        text += std::isinf(second->radius)
                  ? "a flat"
                  : "R = " + format_quantity(second->radius, Dimension::length);
        if (!second->material)
          text += ", rigid";
        else
          {
            add("E", second->material->youngs_modulus, Dimension::pressure);
            add("nu", second->material->poisson_ratio, Dimension::number);
            if (!metal)
              add("phi", second->material->friction_angle * (180 / M_PI), Dimension::angle);
            add(metal ? "yield stress" : "sigma_c",
                second->material->compressive_strength,
                Dimension::pressure);
          }
      }
    return (material.criterion == Criterion::drucker_prager
              ? ""
              : std::string(to_string(material.criterion)) + ", ") +
           text;
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
    const auto with_error = [](const double value, const double standard_error) {
      return format_quantity(value, Dimension::number) + " +- " +
             format_quantity(standard_error, Dimension::number);
    };
    const auto quality = [](const double r2, const double rmse) {
      return ", R2 = " + format_quantity(r2, Dimension::number) +
             ", RMSE = " + format_quantity(rmse, Dimension::number) + " of the peak force";
    };
    return "loading   F/F_y = a (approach/approach_y)^b: a = " +
           with_error(row.a, row.a_standard_error) +
           ", b = " + with_error(row.b, row.b_standard_error) +
           quality(row.r2_loading, row.rmse_loading) +
           "\nunloading F/F_y = m ((approach - residual)/approach_y)^n: m = " +
           with_error(row.m, row.m_standard_error) +
           ", n = " + with_error(row.n, row.n_standard_error) +
           quality(row.r2_unloading, row.rmse_unloading) +
           "\n          published convention (approach_y per sphere): a = " +
           format_quantity(row.a_published, Dimension::number) +
           ", m = " + format_quantity(row.m_published, Dimension::number);
  }

  void print_document(const Json &document) { std::cout << document.dump(2) << '\n'; }
} // namespace dpcontact
