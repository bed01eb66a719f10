#include "database/rows/column_builder.h"

namespace dpcontact::schema
{
  Columns first_yield_columns()
  {
    return {
      column(
        "force_yield_N",
        "N",
        "F_y: force at first yield on the axis (eq 12)",
        [](auto &r) -> auto & { return r.yield.force; },
        positive),
      column(
        "approach_yield_m",
        "m",
        "delta_y: mutual approach at F_y (eq 13)",
        [](auto &r) -> auto & { return r.yield.approach; },
        positive),
      column(
        "pressure_yield_Pa",
        "Pa",
        "Hertz peak pressure at F_y",
        [](auto &r) -> auto & { return r.yield.pressure; },
        positive),
      column(
        "contact_radius_yield_m",
        "m",
        "contact radius at F_y",
        [](auto &r) -> auto & { return r.yield.contact_radius; },
        positive),
      column(
        "yield_strength_Pa",
        "Pa",
        "3 (1 - sin phi) / (3 - sin phi) sigma_c (eq 14)",
        [](auto &r) -> auto & { return r.yield.uniaxial_strength; },
        positive),
    };
  }

  Columns law_columns()
  {
    return {
      column(
        "a",
        "1",
        "loading F/F_y = a (delta/delta_y)^b, both approaches mutual",
        [](auto &r) -> auto & { return r.law.a; },
        positive,
        Absence::error),
      column(
        "b",
        "1",
        "exponent of loading",
        [](auto &r) -> auto & { return r.law.b; },
        Range{0.9, 1.6},
        Absence::error),
      column(
        "m",
        "1",
        "unloading F/F_y = m ((delta - delta_res)/delta_y)^n, all approaches mutual",
        [](auto &r) -> auto & { return r.law.m; },
        positive,
        Absence::error),
      column(
        "n",
        "1",
        "exponent of unloading",
        [](auto &r) -> auto & { return r.law.n; },
        Range{0.9, 1.7},
        Absence::error),
      column(
        "a_published",
        "1",
        "a 2^-b: delta mutual, delta_y of one sphere, as in the paper",
        [](auto &r) -> auto & { return r.fit.published.a; },
        positive),
      column(
        "m_published",
        "1",
        "m 2^-n: delta mutual, delta_y of one sphere, as in the paper",
        [](auto &r) -> auto & { return r.fit.published.m; },
        positive),
      column(
        "approach_residual_m", // nought to rounding, see checks.cc
        "m",
        "delta_res: mutual approach at separation, from the curve",
        [](auto &r) -> auto & { return r.state.approach_residual; },
        any),
      column(
        "approach_peak_m",
        "m",
        "mutual approach at the peak force",
        [](auto &r) -> auto & { return r.state.approach_peak; },
        positive),
    };
  }

  Columns status_columns()
  {
    Columns list = {
      column(
        "status", "", "converged or failed", [](auto &r) -> auto & { return r.status; }),
      column(
        "reason", "", "why the row failed", [](auto &r) -> auto & { return r.reason; }),
      column(
        "warnings",
        "",
        "what limits the trust in the row, separated by semicolons",
        [](auto &r) -> auto & { return r.warnings; }),
    };
    list.front().choices = {"converged", "failed"};
    return list;
  }

  Columns state_columns()
  {
    return {
      column(
        "load_level",
        "1",
        "Lambda: peak force over F_y",
        [](auto &r) -> auto & { return r.load_level; },
        positive),
      column(
        "depth_over_contact_radius",
        "1",
        "depth of first yield on the axis over the contact radius",
        [](auto &r) -> auto & { return r.yield.depth_over_contact_radius; }),
      column(
        "ring_force_N",
        "N",
        "force at which the ring around the contact edge yields",
        [](auto &r) -> auto & { return r.yield.ring_force; }),
      column(
        "approach_yield_published_m",
        "m",
        "delta_y of one sphere, as in the paper",
        [](auto &r) -> auto & { return r.fit.published.approach_yield; }),
      column(
        "approach_residual_eq18_m",
        "m",
        "delta_res that m, n and the peak give back (eq 18)",
        [](auto &r) -> auto & { return r.state.approach_residual_eq18; },
        any),
      column(
        "contact_radius_peak_m", "m", "contact radius at the peak", [](auto &r) -> auto & {
          return r.state.contact_radius_peak;
        }),
      column(
        "pressure_peak_Pa",
        "Pa",
        "largest contact pressure at the peak force",
        [](auto &r) -> auto & { return r.state.pressure_peak; }),
      column(
        "plastic_volume_m3",
        "m3",
        "volume of one sphere that yielded on the whole path",
        [](auto &r) -> auto & { return r.state.plastic_volume; }),
      column(
        "dissipated_energy_J",
        "J",
        "plastic work in both spheres on the whole path",
        [](auto &r) -> auto & { return r.state.dissipated_energy; }),
      column(
        "plastic_strain_max",
        "1",
        "largest accumulated plastic strain on the whole path",
        [](auto &r) -> auto & { return r.state.plastic_strain_max; }),
      column(
        "apex_points",
        "1",
        "converged states at the apex of the cone on the whole path",
        [](auto &r) -> auto & { return r.state.apex_points; }),
      column(
        "step_error",
        "1",
        "estimated error of F(approach) left by the load step, over the peak force",
        [](auto &r) -> auto & { return r.state.step_error; }),
    };
  }

  Columns cost_columns()
  {
    return {
      column(
        "dofs", "1", "degrees of freedom", [](auto &r) -> auto & { return r.cost.dofs; }),
      column(
        "steps", "1", "converged load steps of both branches", [](auto &r) -> auto & {
          return r.cost.steps;
        }),
      column(
        "newton_iterations", "1", "Newton iterations of both branches", [](auto &r) -> auto & {
          return r.cost.newton_iterations;
        }),
      column(
        "cut_backs", "1", "load steps that were cut back", [](auto &r) -> auto & {
          return r.cost.cut_backs;
        }),
      column(
        "wall_seconds",
        "s",
        "wall time of the solution",
        [](auto &r) -> auto & { return r.cost.wall_seconds; },
        not_negative,
        Absence::allowed),
      column(
        "peak_memory_bytes", "B", "peak memory of the process", [](auto &r) -> auto & {
          return r.cost.peak_memory_bytes;
        }),
    };
  }

  Columns error_columns()
  {
    Columns list;
    for (std::size_t c = 0; c < coefficient_names.size(); ++c)
      {
        const std::string name = coefficient_names[c];
        const std::string what = "estimated error of " + name + ": ";
        for (const ErrorSource &source : error_sources)
          list.push_back(column(
            name + "_error_" + source.name,
            "1",
            what + source.description,
            [ c, member = source.member ](auto &row) -> auto & {
              return row.error[c].parts.*member;
            },
            not_negative,
            Absence::error));
        list.push_back(column(
          name + "_error_total",
          "1",
          what + "sum of these",
          [c](auto &row) -> auto & { return row.error[c].total; },
          not_negative,
          Absence::error));
      }
    return list;
  }
} // namespace dpcontact::schema
