#include "solver/laws/material.h"

#include "meshing/errors.h"
#include "solver/laws/criterion.h"

#include <algorithm>
#include <cmath>

namespace dpcontact
{
  namespace
  {
    MaterialParameter modulus_parameter()
    {
      MaterialParameter p;
      p.name           = "E";
      p.symbol         = "E";
      p.title          = "Young's modulus E";
      p.help           = "Young's modulus";
      p.description    = "Young's modulus";
      p.dimension      = Dimension::pressure;
      p.range.open_low = true;
      p.example        = "10GPa";
      p.get            = [](const Material &m) { return m.youngs_modulus; };
      p.set            = [](Material &m, const double value) { m.youngs_modulus = value; };
      p.second_word    = "rigid";
      return p;
    }

    MaterialParameter ratio_parameter()
    {
      MaterialParameter p;
      p.name        = "nu";
      p.symbol      = "nu";
      p.title       = "Poisson's ratio nu";
      p.help        = "Poisson's ratio, at least 0 and below 0.5";
      p.description = "Poisson's ratio";
      p.range       = {0, 0.5, false, true};
      p.get         = [](const Material &m) { return m.poisson_ratio; };
      p.set         = [](Material &m, const double value) { m.poisson_ratio = value; };
      return p;
    }

    MaterialParameter friction_parameter()
    {
      MaterialParameter p;
      p.name        = "phi";
      p.symbol      = "phi";
      p.title       = "friction angle phi";
      p.help        = "friction angle in degrees, at least 0 and below 90";
      p.description = "friction angle";
      p.dimension   = Dimension::angle;
      p.range       = {0, 90, false, true};
      p.get         = [](const Material &m) { return m.friction_angle.degrees(); };
      p.set         = [](Material &m, const double value) { m.friction_angle = Angle(value); };
      return p;
    }

    MaterialParameter strength_parameter()
    {
      MaterialParameter p;
      p.name           = "sigma_c";
      p.symbol         = "sigma_c";
      p.title          = "uniaxial compressive strength sigma_c";
      p.help           = "uniaxial compressive strength";
      p.description    = "uniaxial compressive strength";
      p.dimension      = Dimension::pressure;
      p.range.open_low = true;
      p.example        = "15MPa";
      p.get            = [](const Material &m) { return m.compressive_strength; };
      p.set            = [](Material &m, const double value) { m.compressive_strength = value; };
      return p;
    }

    const std::vector<MaterialParameter> &common_parameters()
    {
      static const std::vector<MaterialParameter> list = {
        modulus_parameter(), ratio_parameter(), friction_parameter(), strength_parameter()};
      return list;
    }
  } // namespace

  double Angle::radians() const { return value * M_PI / 180; }

  const std::vector<MaterialParameter> &material_parameters()
  {
    static const std::vector<MaterialParameter> list = [] {
      std::vector<MaterialParameter> all = common_parameters();
      for (const CriterionDefinition &definition : criteria())
        for (const MaterialParameter &own : definition.parameters)
          {
            const auto same = std::find_if(
              all.begin(), all.end(), [&](const auto &p) { return p.name == own.name; });
            auto &entry = same != all.end() ? *same : all.emplace_back(own);
            entry.owners.push_back(definition.criterion);
          }
      return all;
    }();
    return list;
  }

  std::string one_of(const std::vector<Criterion> &criteria)
  {
    std::vector<std::string> names;
    for (const Criterion criterion : criteria)
      names.emplace_back(to_string(criterion));
    return one_of(names);
  }

  bool is_default(const MaterialParameter &parameter, const Material &material)
  {
    if (!parameter.instead_of.empty())
      return true;
    Material standard = material;
    parameter.set(standard, parameter.default_value.value_or(std::nan("")));
    const double now = parameter.get(material), then = parameter.get(standard);
    return now == then || (std::isnan(now) && std::isnan(then));
  }

  bool has_default_parameters(const Material &material)
  {
    for (const MaterialParameter &parameter : material_parameters())
      if (!parameter.owners.empty() && !is_default(parameter, material))
        return false;
    return true;
  }

  bool is_tabulated_kind(const Material &material)
  {
    return material.criterion == Criterion::drucker_prager && has_default_parameters(material);
  }

  bool operator==(const Material &p, const Material &q)
  {
    if (p.criterion != q.criterion)
      return false;
    for (const MaterialParameter &parameter : material_parameters())
      if (parameter.instead_of.empty())
        {
          const double left = parameter.get(p), right = parameter.get(q);
          if (left != right && !(std::isnan(left) && std::isnan(right)))
            return false;
        }
    return true;
  }

  double Material::shear_modulus(const double stress_unit, const double strain_unit) const
  {
    return youngs_modulus / (stress_unit / strain_unit) / (2 * (1 + poisson_ratio));
  }

  double Material::bulk_modulus(const double stress_unit, const double strain_unit) const
  {
    return youngs_modulus / (stress_unit / strain_unit) / (3 * (1 - 2 * poisson_ratio));
  }

  void Material::check() const
  {
    for (const MaterialParameter &parameter : material_parameters())
      {
        if (!parameter.instead_of.empty())
          continue;
        if (!parameter.belongs_to(criterion))
          {
            if (!is_default(parameter, *this))
              throw InputError(parameter.title + " is set, but " + to_string(criterion) +
                               " has none: leave it out, or use " + one_of(parameter.owners) + ".");
            continue;
          }
        const double value = parameter.get(*this);
        if (!(std::isnan(value) && parameter.may_be_left_out()))
          check_range(parameter.title, value, parameter.dimension, parameter.range);
      }
    if (const auto rest = definition_of(criterion).check)
      rest(*this);
  }
} // namespace dpcontact
