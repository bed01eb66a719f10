#include "database/tables/universal_table.h"

#include "database/files/csv.h"
#include "database/files/digest.h"
#include "database/files/json_text.h"
#include "fitting/power_law.h"
#include "fitting/resample.h"
#include "fitting/smooth_curve.h"
#include "meshing/errors.h"
#include "meshing/number_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <set>
#include <sstream>

namespace dpcontact
{
  namespace
  {
    constexpr unsigned int n_fit_points = 200; ///< equidistant in the approach, as fit_curve()

    /// ln(δ/δ_y) − ⅔ ln Λ over ln Λ: nought where the contact is elastic.
    struct Excess
    {
      SmoothCurve curve;
      double      onset; ///< load level of first yield; below it Hertz holds exactly

      double approach(const double load_level) const
      {
        return std::pow(load_level, 2. / 3) *
               (load_level <= onset ? 1. : std::exp(curve(std::log(load_level))));
      }

      /// The load level of an approach up to that of `highest`, by bisection.
      double load_level(const double delta, const double highest) const
      {
        double low = -40, high = std::log(highest);
        for (int i = 0; i < 60; ++i)
          {
            const double middle                               = (low + high) / 2;
            (approach(std::exp(middle)) < delta ? low : high) = middle;
          }
        return std::exp((low + high) / 2);
      }
    };

    /// All loading states of one (ν, φ), each row's while its contact is well resolved.
    Excess excess_of(const std::vector<const Record *> &rows)
    {
      constexpr double    resolved_share = 0.3; ///< of a row's peak force
      std::vector<double> knots, x, y;
      for (const Record *row : rows)
        {
          knots.push_back(std::log(row->load_level));
          for (const CurvePoint &point : row->curve.loading)
            if (point.force >= resolved_share * row->input.scene.force_max)
              {
                const double level = point.force / row->yield.force;
                x.push_back(std::min(std::log(level), std::log(row->load_level)));
                y.push_back(std::log(point.approach / row->yield.approach) -
                            2. / 3 * std::log(level));
              }
        }
      const Record &any = *rows.front();
      return {SmoothCurve(knots, x, y), std::min(1., any.yield.ring_force / any.yield.force)};
    }

    /// Loading law of the path to `level`.
    PowerLawFit fit_loading(const Excess &excess, const double level)
    {
      const double        peak = excess.approach(level);
      std::vector<double> x, y;
      for (unsigned int i = 1; i <= n_fit_points; ++i)
        {
          x.push_back(peak * i / n_fit_points);
          y.push_back(i == n_fit_points ? level : excess.load_level(x.back(), level));
        }
      return fit_power_law(x, y);
    }

    std::string place_of(const Record &row)
    {
      const Material &material = row.input.material;
      return "nu = " + number_text(material.poisson_ratio) +
             ", phi = " + number_text(material.friction_angle.degrees()) +
             ", Lambda = " + number_text(row.load_level);
    }

    /// Enters the branch that a contact law goes down, its width relative to the approach as the
    /// row's.
    void enter_law(const Record &row, UniversalNode &node)
    {
      try
        {
          const double          peak   = row.curve.loading.back().approach;
          const ResampledBranch branch = resample(row.curve, Branch::unloading, n_fit_points);
          const PowerLaw        law    = fit_through_peak(branch.x, branch.force, peak);
          const double          width  = (branch.x.back() - law.origin) / peak * node.approach;
          node.n_law                   = law.exponent;
          node.m_law                   = node.load_level / std::pow(width, node.n_law);
        }
      catch (const SolverError &error)
        {
          throw SolverError("universal table: the row " + place_of(row) + ": " + error.what());
        }
      catch (const InputError &error)
        {
          throw InputError("universal table: the row " + place_of(row) + ": " + error.what());
        }
    }

    UniversalNode node_of(const Record &row, const Excess &excess)
    {
      UniversalNode node;
      node.nu         = row.input.material.poisson_ratio;
      node.phi_deg    = row.input.material.friction_angle.degrees();
      node.load_level = row.load_level;
      node.approach   = excess.approach(row.load_level);
      // A contact whose edge jumps errs alike, relatively, in the approach and in what is left of
      // it.
      node.residual_approach =
        row.load_level <= excess.onset
          ? 0.
          : node.approach * std::max(0., row.state.approach_residual / row.state.approach_peak);
      const PowerLawFit loading = fit_loading(excess, row.load_level);
      node.a                    = loading.law.coefficient;
      node.b                    = loading.law.exponent;
      node.m                    = row.law.m;
      node.n                    = row.law.n;
      enter_law(row, node);
      const double log_level = std::log(row.load_level);
      // what the step leaves in the force, as an approach
      node.approach_error =
        excess.curve.scatter(log_level - 0.6, log_level + 0.6) + row.state.step_error / row.law.b;
      node.residual_approach_error = node.approach_error * node.approach;
      node.a_error                 = row.error[0].parts.numerical();
      node.b_error                 = row.error[1].parts.numerical();
      node.m_error                 = row.error[2].parts.numerical();
      node.n_error                 = row.error[3].parts.numerical();
      node.a_misfit                = row.error[0].parts.fit;
      node.b_misfit                = row.error[1].parts.fit;
      node.m_misfit                = row.error[2].parts.fit;
      node.n_misfit                = row.error[3].parts.fit;
      node.rmse_loading            = loading.report.rmse;
      node.rmse_unloading          = row.fit.unloading.power_law.rmse;
      node.pressure_yield          = row.yield.pressure / row.input.material.compressive_strength;
      node.ring_load_level         = row.yield.ring_force / row.yield.force;
      return node;
    }

    void check_row(const Record &row)
    {
      if (!row.converged())
        throw InputError("universal table: the row " + place_of(row) + " failed: " + row.reason);
      if (!is_tabulated_kind(row.input.material))
        throw InputError(std::string("universal table: similarity needs ") + tabulated_kind +
                         ", in every row");
    }

    /// The order of the nodes in a file.
    bool is_before(const UniversalNode &p, const UniversalNode &q)
    {
      return std::tie(p.nu, p.phi_deg, p.load_level) < std::tie(q.nu, q.phi_deg, q.load_level);
    }

    /// Load levels that differ by rounding only are one.
    double rounded(const double value)
    {
      std::ostringstream stream;
      stream.precision(9);
      stream << value;
      return std::stod(stream.str());
    }
  } // namespace

  const std::vector<UniversalColumn> &universal_columns()
  {
    using N = UniversalNode;
    constexpr Range positive{0, std::numeric_limits<double>::infinity(), true, false};
    static const std::vector<UniversalColumn> list = {
      {"nu", "1", "Poisson's ratio", &N::nu, {0, 0.5}},
      {"phi_deg", "deg", "friction angle", &N::phi_deg, {0, 90}},
      {"load_level", "1", "Lambda: force over F_y", &N::load_level, positive},
      {"approach",
       "1",
       "delta/delta_y at Lambda on the virgin loading curve, both mutual",
       &N::approach,
       positive},
      {"residual_approach", "1", "delta_res/delta_y after release", &N::residual_approach},
      {"m", "1", "unloading F/F_y = m ((delta - delta_res)/delta_y)^n", &N::m, positive},
      {"n", "1", "exponent of unloading", &N::n, {0.9, 1.7}},
      {"m_law",
       "1",
       "unloading as the contact law does: through the peak, delta_res by eq (18)",
       &N::m_law,
       positive},
      {"n_law", "1", "its exponent", &N::n_law, {0.9, 1.7}},
      {"a", "1", "loading F/F_y = a (delta/delta_y)^b up to Lambda", &N::a, positive},
      {"b", "1", "exponent of loading", &N::b, {0.9, 1.6}},
      {"approach_error", "1", "numerical error of ln(approach)", &N::approach_error},
      {"residual_approach_error",
       "1",
       "numerical error of residual_approach",
       &N::residual_approach_error},
      {"m_error", "1", "numerical error of m", &N::m_error},
      {"n_error", "1", "numerical error of n", &N::n_error},
      {"a_error", "1", "numerical error of a", &N::a_error},
      {"b_error", "1", "numerical error of b", &N::b_error},
      {"m_misfit", "1", "of the power law: m's standard error and window change", &N::m_misfit},
      {"n_misfit", "1", "of the power law: n's standard error and window change", &N::n_misfit},
      {"a_misfit", "1", "of the power law: a's standard error and window change", &N::a_misfit},
      {"b_misfit", "1", "of the power law: b's standard error and window change", &N::b_misfit},
      {"rmse_loading", "1", "of the loading law, over the peak force", &N::rmse_loading},
      {"rmse_unloading", "1", "of the unloading law, over the peak force", &N::rmse_unloading},
      {"pressure_yield",
       "1",
       "Hertz peak pressure at F_y, over sigma_c",
       &N::pressure_yield,
       positive},
      {"ring_load_level",
       "1",
       "load level at which the ring yields",
       &N::ring_load_level,
       positive}};
    return list;
  }

  UniversalTable::UniversalTable(std::vector<UniversalNode> nodes_, Provenance provenance_)
    : nodes(std::move(nodes_))
    , provenance(std::move(provenance_))
  {
    std::array<std::set<double>, 3> values;
    for (const UniversalNode &node : nodes)
      {
        values[0].insert(node.nu);
        values[1].insert(node.phi_deg);
        values[2].insert(node.load_level);
      }
    for (std::size_t i = 0; i < 3; ++i)
      axes[i].assign(values[i].begin(), values[i].end());
    if (nodes.empty() || nodes.size() != axes[0].size() * axes[1].size() * axes[2].size())
      throw InputError("universal table: " + std::to_string(nodes.size()) +
                       " nodes are no grid of nu, phi and Lambda");
    std::sort(nodes.begin(), nodes.end(), is_before);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      {
        const UniversalNode &node = nodes[i];
        const std::size_t    k = i % axes[2].size(), j = i / axes[2].size() % axes[1].size();
        if (node.nu != axes[0][i / axes[2].size() / axes[1].size()] || node.phi_deg != axes[1][j] ||
            node.load_level != axes[2][k])
          throw InputError("universal table: a node stands twice, another is missing");
        if (k > 0 && !(node.approach > nodes[i - 1].approach &&
                       node.residual_approach >= nodes[i - 1].residual_approach))
          throw InputError(
            "universal table: approach or residual approach falls with Lambda at nu = " +
            number_text(node.nu) + ", phi = " + number_text(node.phi_deg) +
            ", Lambda = " + number_text(node.load_level));
      }
  }

  UniversalTable UniversalTable::from_rows(const Database &database, const std::string &revision)
  {
    std::map<std::pair<double, double>, std::vector<const Record *>> families;
    for (const Record &row : database.records)
      {
        check_row(row);
        families[{row.input.material.poisson_ratio, row.input.material.friction_angle.degrees()}]
          .push_back(&row);
      }
    std::vector<UniversalNode> nodes;
    for (auto &[key, rows] : families)
      {
        std::sort(rows.begin(), rows.end(), [](const Record *p, const Record *q) {
          return p->load_level < q->load_level;
        });
        const Excess excess = excess_of(rows);
        for (const Record *row : rows)
          {
            nodes.push_back(node_of(*row, excess));
            nodes.back().load_level = rounded(row->load_level);
            // next to first yield the residual approach is below what the computation resolves
            if (row != rows.front())
              {
                const double before = nodes[nodes.size() - 2].residual_approach;
                double      &now    = nodes.back().residual_approach;
                nodes.back().residual_approach_error += std::max(0., before - now);
                now = std::max(now, before);
              }
          }
      }
    Provenance text            = database.provenance;
    text["version_made_table"] = revision; // that of the sweep stands in the database's own entry
    return UniversalTable(std::move(nodes), std::move(text));
  }

  UniversalTable UniversalTable::joined(const UniversalTable &other) const
  {
    const auto entry = [](const UniversalTable &table, const std::string &key) {
      const auto found = table.provenance.find(key);
      return found == table.provenance.end() ? std::string() : found->second;
    };
    const auto settings = [&](const UniversalTable &table) {
      auto json = parse_json<nlohmann::json>(entry(table, "solver_settings"),
                                             "what a universal table says of solver_settings");
      if (json.is_object())
        json.erase("grid_sha256");
      return json;
    };
    if (settings(*this) != settings(other))
      throw InputError("universal table: nodes of different settings are no one table: " +
                       settings(*this).dump() + " and " + settings(other).dump());
    std::vector<UniversalNode> all_nodes = nodes;
    all_nodes.insert(all_nodes.end(), other.nodes.begin(), other.nodes.end());
    Provenance text         = provenance;
    text["rows"]            = std::to_string(all_nodes.size());
    text["solver_settings"] = settings(*this).dump();
    text["joined"] = std::to_string(other.nodes.size()) + " of the rows made by revision " +
                     entry(other, "version_git_revision");
    if (const std::string before = entry(other, "joined"); !before.empty())
      text["joined"] += ", of these " + before;
    return UniversalTable(std::move(all_nodes), std::move(text));
  }

  void UniversalTable::write(std::ostream &out) const
  {
    CsvWriter csv;
    csv.comment(universal_title);
    for (const auto &[name, text] : provenance)
      csv.comment(name + ": " + text);
    csv.comment("columns (name, unit, description):");
    std::vector<std::string> names;
    for (const UniversalColumn &column : universal_columns())
      {
        csv.comment(column_comment(column.name, column.unit, column.description));
        names.emplace_back(column.name);
      }
    csv.header(names);
    for (const UniversalNode &node : nodes)
      {
        for (const UniversalColumn &column : universal_columns())
          csv.add(node.*column.member);
        csv.end_row();
      }
    out << csv.text();
  }

  void UniversalTable::write(const std::filesystem::path &file) const
  {
    std::ostringstream text;
    write(text);
    write_with_digest(file, text.str());
  }

  UniversalTable UniversalTable::read(const std::filesystem::path &file)
  {
    return from_text(file.string(), read_with_digest(file));
  }

  UniversalTable UniversalTable::from_text(const std::string &name, const std::string &text)
  {
    const CsvTable csv(name, text);
    if (csv.comments().empty() || csv.comments().front() != universal_title)
      throw CorruptData(name + " is not a universal table, as `dpcontact table` writes it");
    Provenance provenance;
    for (const std::string &line : csv.comments())
      if (const auto colon = line.find(": ");
          colon != std::string::npos && line[0] != ' ' && line != universal_title)
        provenance[line.substr(0, colon)] = line.substr(colon + 2);
    std::vector<UniversalNode> nodes(csv.rows());
    for (const UniversalColumn &column : universal_columns())
      csv.require_unit(column.name, column.unit);
    for (const UniversalColumn &column : universal_columns())
      for (std::size_t i = 0; i < nodes.size(); ++i)
        {
          const double value = csv.number(column.name, i);
          if (!std::isfinite(value))
            throw CorruptData(name + ": " + column.name + " is not finite in row " +
                              std::to_string(i + 1));
          nodes[i].*column.member = value;
        }
    const bool in_order = std::is_sorted(nodes.begin(), nodes.end(), is_before);
    try
      {
        UniversalTable table(std::move(nodes), std::move(provenance));
        table.was_in_order = in_order;
        return table;
      }
    catch (const InputError &error)
      {
        throw CorruptData(name + ": " + error.what());
      }
  }
} // namespace dpcontact
