#include "database/tables/universal_checks.h"

#include "database/contact_law/contact_law.h"
#include "database/rows/checks.h"
#include "meshing/errors.h"
#include "solver/closed_form/first_yield.h"

#include <cmath>
#include <sstream>
#include <utility>

namespace dpcontact
{
  namespace
  {
    /// First yield against closed form, and Hertz where nothing yields.
    void check_yield(const UniversalNode &node, const std::string &where, Findings &findings)
    {
      Material material;
      material.youngs_modulus       = 1e11;
      material.poisson_ratio        = node.nu;
      material.friction_angle       = Angle(node.phi_deg);
      material.compressive_strength = 1e2;
      try
        {
          const FirstYield yield = first_yield(material, 0.1);
          findings.require_close(
            "pressure_yield", node.pressure_yield, yield.pressure / 1e2, where);
          findings.require_close(
            "ring_load_level", node.ring_load_level, yield.ring_force / yield.force, where);
          if (node.load_level > yield.onset_force() / yield.force)
            return;
          for (const auto &[name, value, expected] :
               {std::tuple{"a", node.a, 1.},
                {"b", node.b, 1.5},
                {"m", node.m, 1.},
                {"n", node.n, 1.5},
                {"m_law", node.m_law, 1.},
                {"n_law", node.n_law, 1.5},
                {"approach", node.approach, std::pow(node.load_level, 2. / 3)}})
            if (!is_close(value, expected, Findings::elastic_tolerance))
              findings.add(
                Grade::error, where, "nothing yields, but " + versus(name, value, expected));
        }
      catch (const InputError &error)
        {
          findings.add(Grade::error, where, error.what());
        }
    }

    /// The power laws and the contact law where they pass: a gross error in one coefficient.
    void check_laws(const UniversalNode &node, const std::string &where, Findings &findings)
    {
      if (!(node.residual_approach < node.approach))
        findings.add(Grade::error, where, "residual approach is not below the peak's");
      const double recovered = node.approach - node.residual_approach;
      if (recovered / (node.n + 1) >
          node.approach / (node.b + 1) * (1 + Findings::elastic_tolerance))
        findings.add(Grade::error, where, "unloading returns more work than loading took");
      for (const auto &[name, law] :
           {std::pair{"a (delta/delta_y)^b", node.a * std::pow(node.approach, node.b)},
            {"the unloading law at the peak", node.m * std::pow(recovered, node.n)}})
        if (!is_close(law, node.load_level, 0.05))
          findings.add(Grade::error, where, versus(name, law, node.load_level));
      const double by_law = std::pow(node.load_level / node.m_law, 1 / node.n_law);
      // As ContactTable::read() asks; of the shipped table 0.0077 at most.
      if (!(std::abs(by_law - recovered) <= 0.015 * node.approach))
        findings.add(Grade::error,
                     where,
                     versus("what the contact law recovers of the approach", by_law, recovered));
    }

    /// Stated errors and misfits: of the order of what they belong to. The limits are at least
    /// three times what the shipped table has.
    void check_errors(const UniversalNode &node, const std::string &where, Findings &findings)
    {
      const auto require = [&](const std::string &name, const double value, const Range &range) {
        findings.check_number(name, std::isnan(value) ? -1 : value, range, where);
      };
      require("approach_error", node.approach_error, {0, 0.2});
      // As an approach, and what keeps the residual approach from falling with Lambda.
      const double share = node.approach_error * node.approach;
      require("residual_approach_error over approach_error of the approach",
              (node.residual_approach_error - share) / node.approach,
              {-1e-9, 1e-3});
      for (const auto &[name, value, error, misfit] :
           {std::tuple{"a", node.a, node.a_error, node.a_misfit},
            {"b", node.b, node.b_error, node.b_misfit},
            {"m", node.m, node.m_error, node.m_misfit},
            {"n", node.n, node.n_error, node.n_misfit}})
        {
          const bool is_exponent = name[0] == 'b' || name[0] == 'n';
          require(
            std::string(name) + "_error over it", error / value, {0, is_exponent ? 0.03 : 0.6});
          require(
            std::string(name) + "_misfit over it", misfit / value, {0, is_exponent ? 0.012 : 0.1});
        }
      require("rmse_loading", node.rmse_loading, {0, 0.01});
      require("rmse_unloading", node.rmse_unloading, {0, 0.03});
      // The misfit is a standard error, which follows from the rmse, and the change with the
      // window.
      if (node.rmse_unloading > 1e-8)
        {
          require("m_misfit over m rmse_unloading",
                  node.m_misfit / node.m / node.rmse_unloading,
                  {0.05, 20});
          require("n_misfit over n rmse_unloading",
                  node.n_misfit / node.n / node.rmse_unloading,
                  {0.25, 1.5});
        }
      else
        for (const double misfit : {node.m_misfit, node.n_misfit})
          require("misfit where the law is exact", misfit, {0, 1e-6});
    }
  } // namespace

  std::vector<Finding> check(const UniversalTable &table)
  {
    Findings                  findings;
    std::vector<PlaceOnCurve> places;
    check_rows_said(table.made_from(), table.all().size(), findings);
    if (!table.was_read_in_order())
      findings.add(Grade::warning, "table", "the rows do not stand in the order of their grid");
    for (std::size_t i = 0; i < table.all().size(); ++i)
      {
        const UniversalNode &node  = table.all()[i];
        const std::string    where = "row " + std::to_string(i + 1);
        for (const UniversalColumn &column : universal_columns())
          findings.check_number(column.name, node.*column.member, column.range, where);
        check_yield(node, where, findings);
        check_laws(node, where, findings);
        check_errors(node, where, findings);
        places.push_back(
          {std::log(node.load_level), {std::log(node.a), node.b, std::log(node.m), node.n}, where});
        if (places.size() == table.load_level().size())
          check_smooth(std::exchange(places, {}), findings);
      }
    return findings.sorted();
  }

  std::vector<Finding> check_universal(const std::string &name, const std::string &text)
  {
    if (text.rfind(std::string("# ") + universal_title, 0) == 0)
      return check(UniversalTable::from_text(name, text));
    Findings           findings;
    std::istringstream stream(text);
    try
      {
        ContactTable::read(stream);
      }
    catch (const std::runtime_error &error)
      {
        throw CorruptData("'" + name + "': " + error.what());
      }
    findings.add(Grade::note, "table", "an excerpt: only the columns of the contact law are there");
    return findings.sorted();
  }

  UniversalTable read_checked_universal(const std::filesystem::path &file)
  {
    UniversalTable table = UniversalTable::read(file);
    refuse_errors(check(table), file);
    return table;
  }

  PackageContent package_of(const UniversalTable &table)
  {
    PackageContent content{universal_title, table.made_from(), {}, {"nu", "phi_deg", "load_level"}};
    for (const UniversalColumn &column : universal_columns())
      content.fields.push_back(
        {column.name, "number", column.unit, column.description, column.range, {}});
    return content;
  }
} // namespace dpcontact
