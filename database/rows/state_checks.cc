#include "database/rows/row_checks.h"
#include "meshing/number_text.h"
#include "solver/laws/strengths.h"

#include <cmath>
#include <utility>

namespace dpcontact
{
  namespace
  {
    constexpr double pi = 3.14159265358979323846;

    /// Adds a finding unless low ≤ value ≤ high; NaN is one.
    void require_within(const Grade        grade,
                        const std::string &name,
                        const double       value,
                        const double       low,
                        const double       high,
                        const std::string &where,
                        Findings          &findings)
    {
      if (!(value >= low && value <= high))
        findings.add(grade,
                     where,
                     name + " is " + number_text(value) + ", it should be from " +
                       number_text(low) + " to " + number_text(high));
    }

    void check_closed_forms(const Record      &row,
                            const FirstYield  &yield,
                            const std::string &where,
                            Findings          &findings)
    {
      const Material &material = row.input.material;
      findings.require_close("yield_strength_Pa",
                             row.yield.uniaxial_strength,
                             std::sqrt(3.) *
                               laws::drucker_prager_strength(material.friction_angle.radians(),
                                                             material.compressive_strength),
                             where);
      findings.require_close("depth_over_contact_radius",
                             row.yield.depth_over_contact_radius,
                             yield.depth_over_contact_radius,
                             where);
      findings.require_close("ring_force_N", row.yield.ring_force, yield.ring_force, where);
      const double peak = row.state.approach_peak;
      const double back =
        peak - yield.approach * std::pow(row.load_level / row.law.m, 1 / row.law.n);
      if (!(std::abs(row.state.approach_residual_eq18 - back) <= Findings::rounding * peak))
        findings.add(Grade::error,
                     where,
                     versus("approach_residual_eq18_m", row.state.approach_residual_eq18, back));
    }

    /// Contact radius and pressure at the peak against Hertz's of the same load. The bounds are
    /// found, not derived: wide enough for a coarse mesh, and narrow enough for a lost digit or
    /// unit. What lies outside is a warning.
    void check_peak(const Record      &row,
                    const FirstYield  &yield,
                    const std::string &where,
                    Findings          &findings)
    {
      const double radius = row.state.contact_radius_peak;
      const double hertz  = yield.contact_radius * std::cbrt(row.load_level);
      // Yielding spreads the contact; a²/(R* δ) is 1 after Hertz, 1.75 at most over the shipped
      // rows, where material piles up at the edge, and 6.8 over rows far beyond first yield
      // (E 10 GPa, σc 5 MPa, 3 kN, Mohr–Coulomb φ = 30°, resolution 12).
      require_within(Grade::warning,
                     "contact_radius_peak_m over Hertz's",
                     radius / hertz,
                     0.8,
                     10,
                     where,
                     findings);
      const double effective = std::pow(yield.contact_radius, 2) / yield.approach;
      require_within(Grade::warning,
                     "a^2/(R* delta) at the peak",
                     radius * radius / (effective * row.state.approach_peak),
                     0.6,
                     10,
                     where,
                     findings);
      // The largest pressure is at least the mean one, and 3/2 of it after Hertz.
      const double mean = row.input.scene.force_max / (pi * radius * radius);
      require_within(Grade::warning,
                     "pressure_peak_Pa over the mean pressure",
                     row.state.pressure_peak / mean,
                     0.7,
                     3,
                     where,
                     findings);
    }

    /// What is dissipated is not got back; the rest stays in the bodies as residual stress, 15 % of
    /// the work of loading at most over the shipped rows.
    void check_energy(const Record &row, const std::string &where, Findings &findings)
    {
      const StateRow &state   = row.state;
      const double    force   = row.input.scene.force_max;
      const double    loading = force * state.approach_peak / (row.law.b + 1);
      const double    unloading =
        force * (state.approach_peak - state.approach_residual) / (row.law.n + 1);
      require_within(
        Grade::warning,
        "dissipated_energy_J less what loading took and unloading gave, over the former",
        (state.dissipated_energy - (loading - unloading)) / loading,
        -0.35,
        0.05,
        where,
        findings);
      require_within(Grade::error,
                     "dissipated_energy_J over the work of loading",
                     state.dissipated_energy / loading,
                     0,
                     1,
                     where,
                     findings);
      // Within a body there is no more than the body, and small strains are far from 100.
      constexpr double most_strain = 100;
      require_within(Grade::error,
                     "plastic_volume_m3 over a sphere's volume",
                     state.plastic_volume / (4. / 3 * pi * std::pow(row.input.scene.radius, 3)),
                     0,
                     1,
                     where,
                     findings);
      require_within(Grade::error,
                     "plastic_strain_max",
                     state.plastic_strain_max,
                     0,
                     most_strain,
                     where,
                     findings);
      // 5 contact radii across at most over the shipped rows.
      require_within(Grade::warning,
                     "plastic_volume_m3 over a half-ball of 20 contact radii",
                     state.plastic_volume /
                       (2. / 3 * pi * std::pow(20 * state.contact_radius_peak, 3)),
                     0,
                     1,
                     where,
                     findings);
      // Strains are of the order of a/R: 0.42 of it over the shipped rows.
      require_within(Grade::warning,
                     "plastic_strain_max over a/R",
                     state.plastic_strain_max * row.input.scene.radius / state.contact_radius_peak,
                     0,
                     10,
                     where,
                     findings);
      const bool yielded = state.dissipated_energy > 0;
      if (yielded != (state.plastic_volume > 0) || yielded != (state.plastic_strain_max > 0))
        findings.add(
          Grade::error,
          where,
          "dissipated energy, plastic volume and plastic strain are not positive together");
      // In both bodies no more than the largest strain times the largest stress, everywhere that
      // yielded: 0.31 of it at most over the shipped rows.
      if (yielded)
        require_within(Grade::warning,
                       "dissipated_energy_J over 2 V strain p",
                       state.dissipated_energy / (2 * state.plastic_volume *
                                                  state.plastic_strain_max * state.pressure_peak),
                       1e-6,
                       3,
                       where,
                       findings);
      require_within(Grade::warning, "step_error", state.step_error, 0, 0.5, where, findings);
    }

    void check_ends_of_curve(const Record &row, const std::string &where, Findings &findings)
    {
      if (row.curve.loading.empty() || row.curve.unloading.empty())
        return;
      const CurvePoint &peak = row.curve.loading.back(), &release = row.curve.unloading.back();
      const StateRow   &state = row.state;
      for (const auto &[name, value, on_curve] :
           {std::tuple{"contact_radius_peak_m", state.contact_radius_peak, peak.contact_radius},
            {"pressure_peak_Pa", state.pressure_peak, peak.pressure_max},
            {"plastic_volume_m3", state.plastic_volume, release.plastic_volume},
            {"dissipated_energy_J", state.dissipated_energy, release.dissipated_energy},
            {"plastic_strain_max", state.plastic_strain_max, release.plastic_strain_max}})
        findings.require_close(name, value, on_curve, where);
    }

    /// Of a solution in closed form, nothing; else each step has iterations, and each iteration
    /// less than a machine can do.
    void check_cost(const Record &row, const std::string &where, Findings &findings)
    {
      const CostRow &cost   = row.cost;
      const bool     closed = cost.dofs == 0;
      if (closed != (cost.steps == 0) || closed != (cost.newton_iterations == 0) ||
          (closed && (cost.cut_backs > 0 || row.state.apex_points > 0)))
        findings.add(
          Grade::error, where, "degrees of freedom, steps and iterations are not there together");
      const auto   count = [](const std::uint64_t value) { return static_cast<double>(value); };
      const double dofs = count(cost.dofs), steps = count(cost.steps),
                   tries         = steps + count(cost.cut_backs);
      constexpr double most_dofs = 1e9, most_steps = 1e6, most_iterations_of_a_step = 50;
      for (const auto &[name, value, low, high] :
           {std::tuple{"dofs", dofs, 0., most_dofs},
            {"steps", steps, 0., most_steps},
            {"newton_iterations",
             count(cost.newton_iterations),
             steps,
             most_iterations_of_a_step * tries},
            {"cut_backs", count(cost.cut_backs), 0., most_steps},
            // Of the converged states at no more integration points than four an element.
            {"apex_points", count(row.state.apex_points), 0., 4 * dofs * tries},
            {"peak_memory_bytes", count(cost.peak_memory_bytes), 0., 0x1p50}})
        require_within(Grade::error, name, value, low, high, where, findings);
      if (!std::isnan(cost.wall_seconds)) // not every row has one
        require_within(Grade::warning, "wall_seconds", cost.wall_seconds, 0, 1e9, where, findings);
    }
  } // namespace

  void check_state(const Record      &row,
                   const FirstYield  &yield,
                   const std::string &where,
                   Findings          &findings)
  {
    check_closed_forms(row, yield, where, findings);
    check_peak(row, yield, where, findings);
    check_energy(row, where, findings);
    check_ends_of_curve(row, where, findings);
    check_cost(row, where, findings);
  }
} // namespace dpcontact
