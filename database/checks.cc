#include "database/checks.h"

#include "database/packages.h"
#include "database/schema.h"
#include "meshing/errors.h"
#include "solver/first_yield.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace dpcontact
{
  namespace
  {
    constexpr double rounding = 1e-7; ///< of closed forms that are stored beside their inputs

    /// Hertz's curve, sampled and fitted, or what discretisation leaves of it.
    constexpr double elastic_tolerance = 3e-3;

    struct Findings
    {
      std::vector<Finding> list;
      void                 add(const Grade grade, const std::string &where, const std::string &what)
      {
        list.push_back({grade, where, what});
      }
      std::vector<Finding> sorted()
      {
        std::stable_sort(list.begin(), list.end(), [](const Finding &p, const Finding &q) {
          return p.grade < q.grade;
        });
        return list;
      }
    };

    bool close(const double value, const double expected, const double tolerance = rounding)
    {
      return std::abs(value - expected) <= tolerance * std::abs(expected);
    }

    std::string versus(const std::string &name, const double value, const double expected)
    {
      return name + " is " + number_text(value) + ", it should be " + number_text(expected);
    }

    void check_number(const std::string &name,
                      const double       value,
                      const std::string &where,
                      Findings          &findings)
    {
      const ColumnRange range = range_of(name);
      if (std::isnan(value))
        return;
      if (value < range.low || value > range.high || (range.above_low && value == range.low))
        findings.add(Grade::error,
                     where,
                     name + " = " + number_text(value) + " is outside [" + number_text(range.low) +
                       ", " + number_text(range.high) + "]");
    }

    void require_close(const std::string &name,
                       const double       value,
                       const double       expected,
                       const std::string &where,
                       Findings          &findings,
                       const double       tolerance = rounding)
    {
      if (!close(value, expected, tolerance))
        findings.add(Grade::error, where, versus(name, value, expected));
    }

    Material material_of(const RowInputs &row)
    {
      Material material;
      material.youngs_modulus       = row.E_Pa;
      material.poisson_ratio        = row.nu;
      material.friction_angle       = row.phi_deg * (M_PI / 180);
      material.compressive_strength = row.sigma_c_Pa;
      material.criterion            = parse_criterion(row.criterion);
      material.flow_stress_ratio    = row.flow_stress_ratio;
      material.hardening            = row.hardening_Pa;
      if (row.dilation_deg != row.phi_deg)
        material.dilation_angle = row.dilation_deg * (M_PI / 180);
      if (!std::isnan(row.tension_cutoff_Pa))
        material.tension_cutoff = row.tension_cutoff_Pa;
      return material;
    }

    double work_of(const std::vector<CurvePoint> &branch)
    {
      double work = 0;
      for (std::size_t i = 1; i < branch.size(); ++i)
        work += (branch[i].force + branch[i - 1].force) / 2 *
                std::abs(branch[i].approach - branch[i - 1].approach);
      return work;
    }

    void check_branch(const std::vector<CurvePoint> &branch,
                      const char                    *name,
                      const double                   direction,
                      const std::string             &where,
                      Findings                      &findings)
    {
      for (std::size_t i = 1; i < branch.size(); ++i)
        if (!(direction * (branch[i].approach - branch[i - 1].approach) > 0) ||
            !(direction * (branch[i].force - branch[i - 1].force) > 0))
          {
            findings.add(Grade::error,
                         where,
                         std::string(name) + " is not monotone at point " + std::to_string(i));
            return;
          }
    }

    void check_curve(const Record &row, const std::string &where, Findings &findings)
    {
      const auto &loading = row.curve.loading, &unloading = row.curve.unloading;
      if (loading.empty() || unloading.empty())
        {
          // an export without curves: the laws themselves
          const double up = row.force_max_N * row.approach_peak_m / (row.b + 1);
          const double down =
            row.force_max_N * (row.approach_peak_m - row.approach_residual_m) / (row.n + 1);
          if (down > up * (1 + elastic_tolerance))
            findings.add(Grade::error, where, "unloading returns more work than loading took");
          return;
        }
      check_branch(loading, "loading", 1, where, findings);
      check_branch(unloading, "unloading", -1, where, findings);
      require_close(
        "the curve's peak approach", loading.back().approach, row.approach_peak_m, where, findings);
      require_close(
        "the curve's peak force", loading.back().force, row.force_max_N, where, findings, 1e-5);
      if (std::abs(unloading.back().approach - row.approach_residual_m) >
          rounding * row.approach_peak_m)
        findings.add(Grade::error,
                     where,
                     versus("the curve's residual approach",
                            unloading.back().approach,
                            row.approach_residual_m));
      // the trapezoidal rule over- and underestimates a convex curve by its steps
      if (work_of(unloading) > work_of(loading) * (1 + elastic_tolerance))
        findings.add(Grade::error, where, "unloading returns more work than loading took");
    }

    void check_row(const Record &row, const std::string &where, Findings &findings)
    {
      Material material;
      try
        {
          material = material_of(row);
          material.check();
          Scene{row.radius_m, row.force_max_N}.check();
        }
      catch (const InputError &error)
        {
          findings.add(Grade::error, where, error.what());
          return;
        }
      const FirstYield yield = first_yield(material, row.radius_m);
      require_close("force_yield_N", row.force_yield_N, yield.force, where, findings);
      require_close("approach_yield_m", row.approach_yield_m, yield.approach, where, findings);
      require_close("pressure_yield_Pa", row.pressure_yield_Pa, yield.pressure, where, findings);
      require_close("contact_radius_yield_m",
                    row.contact_radius_yield_m,
                    yield.contact_radius,
                    where,
                    findings);
      require_close("load_level", row.load_level, row.force_max_N / yield.force, where, findings);
      if (row.status != "converged" && row.status != "failed")
        findings.add(Grade::error, where, "status is '" + row.status + "'");
      if (row.status == "failed")
        findings.add(Grade::warning, where, "failed: " + row.reason);
      if (row.status != "converged")
        return;

      for (const auto &column : schema::columns())
        if (const auto *const member = std::get_if<double Record::*>(&column.member))
          {
            const double value        = row.*(*member);
            const bool   may_be_unset = std::string(column.name) == "tension_cutoff_Pa" ||
                                      std::string(column.name) == "wall_seconds" ||
                                      std::string(column.name).find("r2_") == 0;
            if (!std::isfinite(value) && !may_be_unset)
              findings.add(std::string(column.name).find("_error_") != std::string::npos ||
                               std::string(column.name).size() <= 1
                             ? Grade::error
                             : Grade::note,
                           where,
                           std::string(column.name) + " is missing");
            check_number(column.name, value, where, findings);
          }
      if (!(row.approach_residual_m >= -rounding * row.approach_peak_m) ||
          !(row.approach_residual_m < row.approach_peak_m))
        findings.add(Grade::error,
                     where,
                     "residual approach " + number_text(row.approach_residual_m) +
                       " m is not from 0 to below the peak's " + number_text(row.approach_peak_m));
      require_close("a_published", row.a_published, row.a * std::exp2(-row.b), where, findings);
      require_close("m_published", row.m_published, row.m * std::exp2(-row.n), where, findings);
      require_close("approach_yield_published_m",
                    row.approach_yield_published_m,
                    yield.approach / 2,
                    where,
                    findings);
      const std::pair<const char *, std::array<double, 7>> errors[] = {{"a",
                                                                        {row.a_error_mesh,
                                                                         row.a_error_step,
                                                                         row.a_error_contact,
                                                                         row.a_error_far_field,
                                                                         row.a_error_finite_radius,
                                                                         row.a_error_fit,
                                                                         row.a_error_total}},
                                                                       {"b",
                                                                        {row.b_error_mesh,
                                                                         row.b_error_step,
                                                                         row.b_error_contact,
                                                                         row.b_error_far_field,
                                                                         row.b_error_finite_radius,
                                                                         row.b_error_fit,
                                                                         row.b_error_total}},
                                                                       {"m",
                                                                        {row.m_error_mesh,
                                                                         row.m_error_step,
                                                                         row.m_error_contact,
                                                                         row.m_error_far_field,
                                                                         row.m_error_finite_radius,
                                                                         row.m_error_fit,
                                                                         row.m_error_total}},
                                                                       {"n",
                                                                        {row.n_error_mesh,
                                                                         row.n_error_step,
                                                                         row.n_error_contact,
                                                                         row.n_error_far_field,
                                                                         row.n_error_finite_radius,
                                                                         row.n_error_fit,
                                                                         row.n_error_total}}};
      for (const auto &[name, parts] : errors)
        {
          double sum = 0;
          for (std::size_t i = 0; i < 6; ++i)
            sum += parts[i];
          if (std::isfinite(sum))
            require_close(std::string(name) + "_error_total", parts[6], sum, where, findings, 1e-6);
        }
      if (material.onset_is_known() && row.force_max_N <= yield.onset_force())
        for (const auto &[name, value, expected] :
             {std::tuple{"a", row.a, 1.}, {"b", row.b, 1.5}, {"m", row.m, 1.}, {"n", row.n, 1.5}})
          if (!close(value, expected, elastic_tolerance))
            findings.add(
              Grade::error, where, "nothing yields, but " + versus(name, value, expected));
      // the fitted law, where the curve passes: a gross error in one coefficient
      const double law = row.a * std::pow(row.approach_peak_m / row.approach_yield_m, row.b);
      if (!close(law, row.load_level, 0.05))
        findings.add(
          Grade::error, where, versus("a (delta/delta_y)^b at the peak", law, row.load_level));
      const double down =
        row.m *
        std::pow((row.approach_peak_m - row.approach_residual_m) / row.approach_yield_m, row.n);
      if (!close(down, row.load_level, 0.05))
        findings.add(
          Grade::error, where, versus("the unloading law at the peak", down, row.load_level));
      check_curve(row, where, findings);
    }

    /// A row's place on the common curve of equal ν and φ.
    struct Place
    {
      double                log_level;
      std::array<double, 4> values; ///< ln a, b, ln m, n
      std::string           where;
    };

    /// Against the line through the neighbours, where these are near. The curves bend, so that the
    /// limits are wide: a misplaced value stands out much more.
    void check_smooth(std::vector<Place> places, Findings &findings)
    {
      constexpr double                      widest_gap = 3; ///< of ln Λ
      constexpr std::array<const char *, 4> names{"a", "b", "m", "n"};
      constexpr std::array<double, 4>       limits{.06, .03, .15, .04};
      std::sort(places.begin(), places.end(), [](const Place &p, const Place &q) {
        return p.log_level < q.log_level;
      });
      for (std::size_t i = 1; i + 1 < places.size(); ++i)
        {
          const Place &before = places[i - 1], &here = places[i], &after = places[i + 1];
          const double gap = after.log_level - before.log_level;
          if (gap > widest_gap || gap < 1e-9)
            continue;
          const double t = (here.log_level - before.log_level) / gap;
          for (std::size_t c = 0; c < 4; ++c)
            {
              const double line = before.values[c] + t * (after.values[c] - before.values[c]);
              if (std::abs(here.values[c] - line) >
                  limits[c] + 0.25 * std::abs(after.values[c] - before.values[c]))
                findings.add(Grade::warning,
                             here.where,
                             std::string(names[c]) +
                               " stands out from its neighbours in the load level");
            }
        }
    }
  } // namespace

  const char *to_string(const Grade grade)
  {
    return grade == Grade::error ? "error" : grade == Grade::warning ? "warning" : "note";
  }

  std::vector<Finding> check(const Database &database)
  {
    Findings                                                findings;
    std::map<RowInputs::Key, std::size_t>                   seen;
    std::map<std::pair<double, double>, std::vector<Place>> families;
    if (database.records.empty())
      findings.add(Grade::error, "database", "it has no rows");
    for (const char *const name : {"version_git_revision", "solver_settings"})
      if (database.provenance.count(name) == 0)
        findings.add(Grade::warning, "provenance", std::string(name) + " is missing");
    for (std::size_t i = 0; i < database.records.size(); ++i)
      {
        const Record     &row      = database.records[i];
        const std::string where    = "row " + std::to_string(i + 1);
        const auto [first, is_new] = seen.emplace(row.key(), i);
        if (!is_new)
          findings.add(Grade::error, where, "repeats row " + std::to_string(first->second + 1));
        check_row(row, where, findings);
        if (row.status == "converged" && row.criterion == "drucker-prager" &&
            row.hardening_Pa == 0 && row.flow_stress_ratio == 1 && row.dilation_deg == row.phi_deg)
          families[{row.nu, row.phi_deg}].push_back(
            {std::log(row.load_level), {std::log(row.a), row.b, std::log(row.m), row.n}, where});
      }
    for (auto &[key, places] : families)
      check_smooth(std::move(places), findings);
    return findings.sorted();
  }

  std::vector<Finding> check(const UniversalTable &table)
  {
    Findings           findings;
    std::vector<Place> places;
    for (std::size_t i = 0; i < table.all().size(); ++i)
      {
        const UniversalNode &node  = table.all()[i];
        const std::string    where = "row " + std::to_string(i + 1);
        for (const UniversalColumn &column : universal_columns())
          check_number(column.name, node.*column.member, where, findings);
        Material material;
        material.youngs_modulus       = 1e11;
        material.poisson_ratio        = node.nu;
        material.friction_angle       = node.phi_deg * (M_PI / 180);
        material.compressive_strength = 1e2;
        try
          {
            const FirstYield yield = first_yield(material, 0.1);
            require_close(
              "pressure_yield", node.pressure_yield, yield.pressure / 1e2, where, findings);
            require_close("ring_load_level",
                          node.ring_load_level,
                          yield.ring_force / yield.force,
                          where,
                          findings);
            if (node.load_level <= yield.onset_force() / yield.force)
              for (const auto &[name, value, expected] :
                   {std::tuple{"a", node.a, 1.},
                    {"b", node.b, 1.5},
                    {"m", node.m, 1.},
                    {"n", node.n, 1.5},
                    {"m_law", node.m_law, 1.},
                    {"n_law", node.n_law, 1.5},
                    {"approach", node.approach, std::pow(node.load_level, 2. / 3)}})
                if (!close(value, expected, elastic_tolerance))
                  findings.add(
                    Grade::error, where, "nothing yields, but " + versus(name, value, expected));
          }
        catch (const InputError &error)
          {
            findings.add(Grade::error, where, error.what());
          }
        if (!(node.residual_approach < node.approach))
          findings.add(Grade::error, where, "residual approach is not below the peak's");
        const double recovered = node.approach - node.residual_approach;
        if (recovered / (node.n + 1) > node.approach / (node.b + 1) * (1 + elastic_tolerance))
          findings.add(Grade::error, where, "unloading returns more work than loading took");
        for (const auto &[name, law] :
             {std::pair{"a (delta/delta_y)^b", node.a * std::pow(node.approach, node.b)},
              {"the unloading law at the peak", node.m * std::pow(recovered, node.n)}})
          if (!close(law, node.load_level, 0.05))
            findings.add(Grade::error, where, versus(name, law, node.load_level));
        const double by_law = std::pow(node.load_level / node.m_law, 1 / node.n_law);
        if (!close(by_law, recovered, 0.1)) // of the shipped table .056 at most
          findings.add(Grade::error,
                       where,
                       versus("what the contact law recovers of the approach", by_law, recovered));
        places.push_back(
          {std::log(node.load_level), {std::log(node.a), node.b, std::log(node.m), node.n}, where});
        if (places.size() == table.load_level().size())
          {
            check_smooth(std::move(places), findings);
            places.clear();
          }
      }
    return findings.sorted();
  }

  void refuse_errors(const std::vector<Finding> &findings, const std::filesystem::path &file)
  {
    std::size_t count = 0;
    while (count < findings.size() && findings[count].grade == Grade::error)
      ++count;
    if (count > 0)
      throw CorruptData(file.string() + ", " + findings[0].where + ": " + findings[0].what +
                        (count == 1 ? "" : ", and " + std::to_string(count - 1) + " more errors") +
                        "; `dpcontact check` lists what is wrong, export or table makes it again");
  }
} // namespace dpcontact
