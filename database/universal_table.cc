#include "database/universal_table.h"

#include "database/digest.h"
#include "database/files.h"
#include "database/text.h"
#include "fitting/power_law.h"
#include "fitting/resample.h"
#include "fitting/smooth_curve.h"
#include "meshing/errors.h"

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
    const char *const title = "dpcontact: universal table of elastic-plastic contact";

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
            if (point.force >= resolved_share * row->force_max_N)
              {
                const double level = point.force / row->force_yield_N;
                x.push_back(std::min(std::log(level), std::log(row->load_level)));
                y.push_back(std::log(point.approach / row->approach_yield_m) -
                            2. / 3 * std::log(level));
              }
        }
      const Record &any = *rows.front();
      return {SmoothCurve(knots, x, y), std::min(1., any.ring_force_N / any.force_yield_N)};
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
      return "nu = " + number_text(row.nu) + ", phi = " + number_text(row.phi_deg) +
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
      node.nu         = row.nu;
      node.phi_deg    = row.phi_deg;
      node.load_level = row.load_level;
      node.approach   = excess.approach(row.load_level);
      // A contact whose edge jumps errs alike, relatively, in the approach and in what is left of
      // it.
      node.residual_approach =
        row.load_level <= excess.onset
          ? 0.
          : node.approach * std::max(0., row.approach_residual_m / row.approach_peak_m);
      const PowerLawFit loading = fit_loading(excess, row.load_level);
      node.a                    = loading.law.coefficient;
      node.b                    = loading.law.exponent;
      node.m                    = row.m;
      node.n                    = row.n;
      enter_law(row, node);
      const double log_level = std::log(row.load_level);
      // what the step leaves in the force, as an approach
      node.approach_error =
        excess.curve.scatter(log_level - 0.6, log_level + 0.6) + row.step_error / row.b;
      node.residual_approach_error = node.approach_error * node.approach;
      const auto numerical =
        [](const double mesh, const double step, const double contact, const double far_field) {
          return mesh + step + contact + far_field;
        };
      node.a_error =
        numerical(row.a_error_mesh, row.a_error_step, row.a_error_contact, row.a_error_far_field);
      node.b_error =
        numerical(row.b_error_mesh, row.b_error_step, row.b_error_contact, row.b_error_far_field);
      node.m_error =
        numerical(row.m_error_mesh, row.m_error_step, row.m_error_contact, row.m_error_far_field);
      node.n_error =
        numerical(row.n_error_mesh, row.n_error_step, row.n_error_contact, row.n_error_far_field);
      node.a_misfit        = row.a_error_fit;
      node.b_misfit        = row.b_error_fit;
      node.m_misfit        = row.m_error_fit;
      node.n_misfit        = row.n_error_fit;
      node.rmse_loading    = loading.report.rmse;
      node.rmse_unloading  = row.rmse_unloading;
      node.pressure_yield  = row.pressure_yield_Pa / row.sigma_c_Pa;
      node.ring_load_level = row.ring_force_N / row.force_yield_N;
      return node;
    }

    void check_row(const Record &row)
    {
      if (row.status != "converged")
        throw InputError("universal table: the row " + place_of(row) + " failed: " + row.reason);
      if (row.criterion != "drucker-prager" || row.flow_stress_ratio != 1 ||
          row.dilation_deg != row.phi_deg || row.hardening_Pa != 0)
        throw InputError("universal table: similarity needs associated, perfectly plastic "
                         "drucker-prager with K = 1, in every row");
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
    using N                                        = UniversalNode;
    static const std::vector<UniversalColumn> list = {
      {"nu", "1", "Poisson's ratio", &N::nu},
      {"phi_deg", "deg", "friction angle", &N::phi_deg},
      {"load_level", "1", "Lambda: force over F_y", &N::load_level},
      {"approach",
       "1",
       "delta/delta_y at Lambda on the virgin loading curve, both mutual",
       &N::approach},
      {"residual_approach", "1", "delta_res/delta_y after release", &N::residual_approach},
      {"m", "1", "unloading F/F_y = m ((delta - delta_res)/delta_y)^n", &N::m},
      {"n", "1", "exponent of unloading", &N::n},
      {"m_law",
       "1",
       "unloading as the contact law does: through the peak, delta_res by eq (18)",
       &N::m_law},
      {"n_law", "1", "its exponent", &N::n_law},
      {"a", "1", "loading F/F_y = a (delta/delta_y)^b up to Lambda", &N::a},
      {"b", "1", "exponent of loading", &N::b},
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
      {"pressure_yield", "1", "Hertz peak pressure at F_y, over sigma_c", &N::pressure_yield},
      {"ring_load_level", "1", "load level at which the ring yields", &N::ring_load_level}};
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
    std::sort(nodes.begin(), nodes.end(), [](const UniversalNode &p, const UniversalNode &q) {
      return std::tie(p.nu, p.phi_deg, p.load_level) < std::tie(q.nu, q.phi_deg, q.load_level);
    });
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
        families[{row.nu, row.phi_deg}].push_back(&row);
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
      nlohmann::json json = nlohmann::json::parse(entry(table, "solver_settings"), nullptr, false);
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
    out << comment_lines(title);
    for (const auto &[name, text] : provenance)
      out << comment_lines(name + ": " + text);
    out << comment_lines("columns (name, unit, description):");
    std::string header;
    for (const UniversalColumn &column : universal_columns())
      {
        out << comment_lines("  " + std::string(column.name) + ", " + column.unit + ", " +
                             column.description);
        header += (header.empty() ? "" : ",") + std::string(column.name);
      }
    out << header << '\n';
    for (const UniversalNode &node : nodes)
      {
        std::string line;
        for (const UniversalColumn &column : universal_columns())
          line += (line.empty() ? "" : ",") + number_text(node.*column.member);
        out << line << '\n';
      }
  }

  void UniversalTable::write(const std::filesystem::path &file) const
  {
    std::ostringstream text;
    write(text);
    write_with_digest(file, text.str());
  }

  UniversalTable UniversalTable::read(const std::filesystem::path &file)
  {
    const std::string text = read_with_digest(file);
    const CsvTable    csv(file.string(), text);
    if (csv.comments().empty() || csv.comments().front() != title)
      throw CorruptData(file.string() + " is not a universal table of this program");
    Provenance provenance;
    for (const std::string &line : csv.comments())
      if (const auto colon = line.find(": ");
          colon != std::string::npos && line[0] != ' ' && line != title)
        provenance[line.substr(0, colon)] = line.substr(colon + 2);
    std::vector<UniversalNode> nodes(csv.rows());
    for (const UniversalColumn &column : universal_columns())
      for (std::size_t i = 0; i < nodes.size(); ++i)
        {
          const double value = csv.number(column.name, i);
          if (!std::isfinite(value))
            throw CorruptData(file.string() + ": " + column.name + " is not finite in row " +
                              std::to_string(i + 1));
          nodes[i].*column.member = value;
        }
    try
      {
        return UniversalTable(std::move(nodes), std::move(provenance));
      }
    catch (const InputError &error)
      {
        throw CorruptData(file.string() + ": " + error.what());
      }
  }
} // namespace dpcontact
