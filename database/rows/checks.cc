#include "database/rows/checks.h"

#include "database/rows/exports.h"
#include "database/rows/row_checks.h"
#include "database/rows/schema.h"
#include "fitting/conventions.h"
#include "meshing/errors.h"
#include "meshing/number_text.h"
#include "solver/closed_form/first_yield.h"

#include <cmath>
#include <map>

namespace dpcontact
{
  namespace
  {
    constexpr double rounding          = Findings::rounding;
    constexpr double elastic_tolerance = Findings::elastic_tolerance;

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
      const auto  &loading = row.curve.loading, &unloading = row.curve.unloading;
      const double force = row.input.scene.force_max, peak = row.state.approach_peak;
      const double residual = row.state.approach_residual;
      if (loading.empty() || unloading.empty())
        {
          // an export without curves: the laws themselves
          const double up   = force * peak / (row.law.b + 1);
          const double down = force * (peak - residual) / (row.law.n + 1);
          if (down > up * (1 + elastic_tolerance))
            findings.add(Grade::error, where, "unloading returns more work than loading took");
          return;
        }
      check_branch(loading, "loading", 1, where, findings);
      check_branch(unloading, "unloading", -1, where, findings);
      findings.require_close("the curve's peak approach", loading.back().approach, peak, where);
      findings.require_close("the curve's peak force", loading.back().force, force, where, 1e-5);
      if (std::abs(unloading.back().approach - residual) > rounding * peak)
        findings.add(Grade::error,
                     where,
                     versus("the curve's residual approach", unloading.back().approach, residual));
      // the trapezoidal rule over- and underestimates a convex curve by its steps
      if (work_of(unloading) > work_of(loading) * (1 + elastic_tolerance))
        findings.add(Grade::error, where, "unloading returns more work than loading took");
    }

    void check_yield(const Record      &row,
                     const FirstYield  &yield,
                     const std::string &where,
                     Findings          &findings)
    {
      findings.require_close("force_yield_N", row.yield.force, yield.force, where);
      findings.require_close("approach_yield_m", row.yield.approach, yield.approach, where);
      findings.require_close("pressure_yield_Pa", row.yield.pressure, yield.pressure, where);
      findings.require_close(
        "contact_radius_yield_m", row.yield.contact_radius, yield.contact_radius, where);
      findings.require_close(
        "load_level", row.load_level, row.input.scene.force_max / yield.force, where);
    }

    void check_columns(const Record &row, const std::string &where, Findings &findings)
    {
      for (const schema::Column &column : schema::columns())
        {
          const schema::Cell  cell  = column.get(row);
          const double *const value = std::get_if<double>(&cell);
          if (value == nullptr)
            continue;
          if (!std::isfinite(*value) && column.absence != schema::Absence::allowed)
            findings.add(column.absence == schema::Absence::error ? Grade::error : Grade::note,
                         where,
                         column.name + " is missing");
          findings.check_number(column.name, *value, column.range, where);
        }
      const double residual = row.state.approach_residual, peak = row.state.approach_peak;
      if (!(residual >= -rounding * peak) || !(residual < peak))
        findings.add(Grade::error,
                     where,
                     "residual approach " + number_text(residual) +
                       " m is not from 0 to below the peak's " + number_text(peak));
    }

    void check_conventions(const Record      &row,
                           const FirstYield  &yield,
                           const std::string &where,
                           Findings          &findings)
    {
      findings.require_close(
        "a_published", row.fit.published.a, published_coefficient(row.law.a, row.law.b), where);
      findings.require_close(
        "m_published", row.fit.published.m, published_coefficient(row.law.m, row.law.n), where);
      findings.require_close("approach_yield_published_m",
                             row.fit.published.approach_yield,
                             published_approach_yield(yield.approach),
                             where);
      for (std::size_t c = 0; c < coefficient_names.size(); ++c)
        if (const double sum = row.error[c].parts.total(); std::isfinite(sum))
          findings.require_close(std::string(coefficient_names[c]) + "_error_total",
                                 row.error[c].total,
                                 sum,
                                 where,
                                 1e-6);
    }

    void check_law(const Record      &row,
                   const FirstYield  &yield,
                   const std::string &where,
                   Findings          &findings)
    {
      constexpr Coefficients elastic{1., 1.5, 1., 1.5};
      if (row.input.scene.force_max <= yield.elastic_force)
        for (std::size_t c = 0; c < coefficient_names.size(); ++c)
          if (!is_close(row.law[c], elastic[c], elastic_tolerance))
            findings.add(Grade::error,
                         where,
                         "nothing yields, but " +
                           versus(coefficient_names[c], row.law[c], elastic[c]));
      // the fitted law, where the curve passes: a gross error in one coefficient
      const double law =
        row.law.a * std::pow(row.state.approach_peak / row.yield.approach, row.law.b);
      if (!is_close(law, row.load_level, 0.05))
        findings.add(
          Grade::error, where, versus("a (delta/delta_y)^b at the peak", law, row.load_level));
      const double down =
        row.law.m *
        std::pow((row.state.approach_peak - row.state.approach_residual) / row.yield.approach,
                 row.law.n);
      if (!is_close(down, row.load_level, 0.05))
        findings.add(
          Grade::error, where, versus("the unloading law at the peak", down, row.load_level));
    }

    void check_row(const Record &row, const std::string &where, Findings &findings)
    {
      try
        {
          row.input.material.check();
          row.input.scene.check();
        }
      catch (const InputError &error)
        {
          findings.add(Grade::error, where, error.what());
          return;
        }
      const FirstYield yield = first_yield(row.input.material, row.input.scene);
      check_yield(row, yield, where, findings);
      if (row.status != "converged" && row.status != "failed")
        findings.add(Grade::error, where, "status is '" + row.status + "'");
      if (row.status == "failed")
        findings.add(Grade::warning, where, "failed: " + row.reason);
      if (!row.converged())
        return;
      check_columns(row, where, findings);
      check_conventions(row, yield, where, findings);
      check_law(row, yield, where, findings);
      check_curve(row, where, findings);
      check_fit(row, where, findings);
      check_state(row, yield, where, findings);
    }
  } // namespace

  namespace
  {
    /// What rows say themselves, once.
    void warn_of_warnings(const std::vector<Record> &rows, Findings &findings)
    {
      std::size_t   warned = 0;
      const Record *first  = nullptr;
      for (const Record &row : rows)
        if (!row.warnings.empty() && warned++ == 0)
          first = &row;
      if (warned > 0)
        findings.add(Grade::warning,
                     "rows",
                     std::to_string(warned) + " of " + std::to_string(rows.size()) +
                       " were computed with a warning, as " + label(first->input) + ": " +
                       first->warnings);
    }
  } // namespace

  void check_rows_said(const Provenance &provenance, const std::size_t rows, Findings &findings)
  {
    const auto said = provenance.find("rows");
    if (said == provenance.end())
      findings.add(Grade::warning, "provenance", "rows is missing");
    else if (said->second != std::to_string(rows))
      findings.add(Grade::error,
                   "provenance",
                   "it says '" + said->second + "' rows, there are " + std::to_string(rows));
  }

  std::vector<Finding> check(const Database &database)
  {
    Findings                                                       findings;
    std::map<CaseKey, std::size_t>                                 seen;
    std::map<std::pair<double, double>, std::vector<PlaceOnCurve>> families;
    if (database.records.empty())
      findings.add(Grade::error, "database", "it has no rows");
    for (const char *const name : {"version_git_revision", "solver_settings"})
      if (database.provenance.count(name) == 0)
        findings.add(Grade::warning, "provenance", std::string(name) + " is missing");
    check_rows_said(database.provenance, database.records.size(), findings);
    check_grid(database.records, findings);
    for (std::size_t i = 0; i < database.records.size(); ++i)
      {
        const Record     &row      = database.records[i];
        const std::string where    = "row " + std::to_string(i + 1);
        const auto [first, is_new] = seen.emplace(key_of(row.input), i);
        if (!is_new)
          findings.add(Grade::error, where, "repeats row " + std::to_string(first->second + 1));
        check_row(row, where, findings);
        const Material &material = row.input.material;
        if (row.converged() && is_tabulated_kind(material))
          families[{material.poisson_ratio, material.friction_angle.degrees()}].push_back(
            {std::log(row.load_level),
             {std::log(row.law.a), row.law.b, std::log(row.law.m), row.law.n},
             where});
      }
    warn_of_warnings(database.records, findings);
    for (auto &[key, places] : families)
      check_smooth(std::move(places), findings);
    return findings.sorted();
  }

  Database read_checked_store(const std::filesystem::path &file)
  {
    Database database = read_store(file);
    refuse_errors(check(database), file);
    for (std::size_t i = 0; i < database.records.size(); ++i)
      if (const Record &row = database.records[i];
          row.converged() && (row.curve.loading.empty() || row.curve.unloading.empty()))
        throw CorruptData(file.string() + ", row " + std::to_string(i + 1) + ": it has no curve");
    return database;
  }

  Database read_checked_database(const std::filesystem::path &file)
  {
    Database database = read_database(file);
    refuse_errors(check(database), file);
    return database;
  }
} // namespace dpcontact
