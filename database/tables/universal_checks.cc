#include "database/tables/universal_checks.h"

#include "meshing/errors.h"
#include "solver/closed_form/first_yield.h"

#include <cmath>
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
      if (!is_close(by_law, recovered, 0.1)) // of the shipped table 0.056 at most
        findings.add(Grade::error,
                     where,
                     versus("what the contact law recovers of the approach", by_law, recovered));
    }
  } // namespace

  std::vector<Finding> check(const UniversalTable &table)
  {
    Findings                  findings;
    std::vector<PlaceOnCurve> places;
    for (std::size_t i = 0; i < table.all().size(); ++i)
      {
        const UniversalNode &node  = table.all()[i];
        const std::string    where = "row " + std::to_string(i + 1);
        for (const UniversalColumn &column : universal_columns())
          findings.check_number(column.name, node.*column.member, column.range, where);
        check_yield(node, where, findings);
        check_laws(node, where, findings);
        places.push_back(
          {std::log(node.load_level), {std::log(node.a), node.b, std::log(node.m), node.n}, where});
        if (places.size() == table.load_level().size())
          check_smooth(std::exchange(places, {}), findings);
      }
    return findings.sorted();
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
