#include "solver/problem/case.h"

#include "solver/laws/criterion.h"
#include "solver/problem/quantity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace dpcontact
{
  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();

    CaseParameter of_material(const MaterialParameter &own)
    {
      CaseParameter p;
      p.name           = own.name;
      p.symbol         = own.symbol;
      p.title          = own.title;
      p.help           = own.help;
      p.description    = own.description;
      p.dimension      = own.dimension;
      p.range          = own.range;
      p.example        = own.example;
      p.owners         = own.owners;
      p.default_value  = own.default_value;
      p.default_text   = own.default_text;
      p.instead_of     = own.instead_of;
      p.makes_needless = own.makes_needless;
      p.second_word    = own.second_word;
      if (own.get)
        p.get = [get = own.get](const Case &c) { return get(c.material); };
      p.set = [set = own.set](Case &c, const double value) { set(c.material, value); };
      return p;
    }

    CaseParameter radius_parameter()
    {
      CaseParameter p;
      p.name           = "radius";
      p.symbol         = "R";
      p.title          = "sphere radius R";
      p.help           = "radius of each sphere";
      p.description    = "radius of each of the two identical spheres";
      p.dimension      = Dimension::length;
      p.range.open_low = true;
      p.default_value  = Scene{}.radius;
      p.get            = [](const Case &c) { return c.scene.radius; };
      p.of_scene       = true;
      p.set            = [](Case &c, const double value) { c.scene.radius = value; };
      p.second_word    = "flat";
      return p;
    }

    CaseParameter force_parameter()
    {
      CaseParameter p;
      p.name           = "force_max";
      p.symbol         = "F_max";
      p.title          = "peak force F_max";
      p.help           = "peak normal force";
      p.description    = "peak normal force";
      p.dimension      = Dimension::force;
      p.range.open_low = true;
      p.default_value  = Scene{}.force_max;
      p.get            = [](const Case &c) { return c.scene.force_max; };
      p.of_scene       = true;
      p.of_second_body = false;
      p.set            = [](Case &c, const double value) { c.scene.force_max = value; };
      return p;
    }

    /// Its value counts in units of F_y, which only a reader of the whole case can know.
    CaseParameter load_level_parameter()
    {
      CaseParameter p;
      p.name   = "load_level";
      p.symbol = "Lambda";
      p.title  = "load level Lambda";
      p.help   = "instead of force-max: Lambda, the peak force over F_y of the material and radius";
      p.instead_of     = "force_max";
      p.of_scene       = true;
      p.of_second_body = false;
      p.set            = [](Case &c, const double value) { c.scene.force_max = value; };
      return p;
    }

    std::vector<CaseParameter> stored(const std::vector<CaseParameter> &all)
    {
      std::vector<CaseParameter> result;
      std::copy_if(all.begin(), all.end(), std::back_inserter(result), [](const CaseParameter &p) {
        return p.instead_of.empty();
      });
      return result;
    }
  } // namespace

  bool operator==(const Case &p, const Case &q)
  {
    return p.material == q.material && p.scene == q.scene;
  }

  const std::vector<CaseParameter> &case_parameters()
  {
    static const std::vector<CaseParameter> list = [] {
      std::vector<CaseParameter> all;
      for (const MaterialParameter &own : material_parameters())
        all.push_back(of_material(own));
      all.push_back(radius_parameter());
      all.push_back(force_parameter());
      all.push_back(load_level_parameter());
      return all;
    }();
    return list;
  }

  const std::vector<CaseParameter> &stored_parameters()
  {
    static const std::vector<CaseParameter> list = stored(case_parameters());
    return list;
  }

  const CaseParameter &case_parameter(const std::string &name)
  {
    for (const CaseParameter &parameter : case_parameters())
      if (parameter.name == name)
        return parameter;
    throw std::out_of_range("there is no parameter " + name);
  }

  CaseKey key_of(const Case &input)
  {
    CaseKey key{to_string(input.material.criterion), {}};
    for (const CaseParameter &parameter : stored_parameters())
      {
        const double value = parameter.get(input);
        key.second.push_back(std::isnan(value) ? infinity : value);
      }
    return key;
  }

  std::string label(const Case &input)
  {
    const CriterionDefinition &criterion = definition_of(input.material.criterion);
    std::string                text;
    const auto add = [&text](const std::string &symbol, const double value, const Dimension what) {
      text += (text.empty() ? "" : ", ") + symbol + " = " + format_quantity(value, what);
    };
    const auto add_parameter = [&](const CaseParameter &parameter, const Case &of) {
      if (parameter.name == "phi" && !criterion.has_friction_angle)
        return;
      add(parameter.name == "sigma_c" ? criterion.strength_symbol : parameter.symbol,
          parameter.get(of),
          parameter.dimension);
    };

    const auto is_left_out = [](const CaseParameter &parameter, const Case &of) {
      if (parameter.of_scene || !parameter.may_be_left_out())
        return false;
      Case standard = of;
      parameter.set(standard, parameter.default_value.value_or(std::nan("")));
      const double value = parameter.get(of), usual = parameter.get(standard);
      return value == usual || (std::isnan(value) && std::isnan(usual));
    };

    for (const CaseParameter &parameter : stored_parameters())
      if (!is_left_out(parameter, input))
        add_parameter(parameter, input);
    if (const auto &second = input.scene.second)
      {
        text += "; against ";
        text += std::isinf(second->radius)
                  ? "a flat"
                  : "R = " + format_quantity(second->radius, Dimension::length);
        if (!second->material)
          text += ", rigid";
        else
          for (const CaseParameter &parameter : stored_parameters())
            if (const Case body{*second->material, {}};
                !parameter.of_scene && !is_left_out(parameter, body))
              add_parameter(parameter, body);
      }
    return (input.material.criterion == Criterion::drucker_prager
              ? ""
              : std::string(to_string(input.material.criterion)) + ", ") +
           text;
  }
} // namespace dpcontact
