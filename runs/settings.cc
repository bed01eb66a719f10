#include "runs/settings.h"

#include "meshing/errors.h"

#include <algorithm>
#include <optional>
#include <sstream>

namespace dpcontact
{
  namespace
  {
    using Kind = Setting::Kind;

    std::vector<std::string> split_list(const std::string &text)
    {
      std::vector<std::string> parts;
      std::istringstream       stream(text);
      for (std::string part; std::getline(stream, part, ',');)
        parts.push_back(part);
      if (text.empty() || text.back() == ',')
        parts.emplace_back();
      return parts;
    }

    std::string joined(const std::vector<std::string> &words)
    {
      std::string result;
      for (const std::string &word : words)
        result += (result.empty() ? "" : ", ") + word;
      return result;
    }

    std::optional<std::string> find(const SettingTexts &texts, const std::string &name)
    {
      const auto found = texts.find(name);
      return found == texts.end() ? std::nullopt : std::make_optional(found->second);
    }

    /// The values of a material or scene setting, or its default.
    std::vector<double> read_list(const SettingTexts   &texts,
                                  const std::string    &name,
                                  const Dimension       dimension,
                                  std::optional<double> default_value = std::nullopt)
    {
      const auto text = find(texts, name);
      if (!text && !default_value)
        throw InputError(name + " is missing: give --" + name + " or 'set " + name +
                         " = …' in a parameter file");
      if (!text)
        return {*default_value};
      std::vector<double> values;
      for (const std::string &part : split_list(*text))
        {
          const double value = parse_quantity(name, part, dimension);
          if (std::find(values.begin(), values.end(), value) != values.end())
            throw InputError(name + ": '" + part + "' stands twice in the list '" + *text + "'");
          values.push_back(value);
        }
      return values;
    }

    std::string
    choose(const SettingTexts &texts, const std::string &name, const char *default_choice)
    {
      const auto text = find(texts, name);
      if (!text)
        return default_choice;
      for (const Setting &setting : solver_settings())
        if (setting.name == name)
          setting.check(*text);
      return *text;
    }
  } // namespace

  void Setting::check(const std::string &value) const
  {
    switch (kind)
      {
        case Kind::quantity:
          for (const std::string &part : list ? split_list(value) : std::vector{value})
            parse_quantity(name, part, dimension);
          break;
        case Kind::count:
          parse_count(name, value);
          break;
        case Kind::choice:
          if (std::find(choices.begin(), choices.end(), value) == choices.end())
            throw InputError(name + ": '" + value + "' is not one of " + joined(choices));
          break;
        case Kind::text:
          if (value.empty())
            throw InputError(name + ": is empty");
          break;
      }
  }

  std::vector<Setting> scene_settings()
  {
    const Scene scene;
    const auto quantity = [](const char *name, const Dimension dimension, const std::string &help) {
      return Setting{name, Kind::quantity, help, dimension, {}, true};
    };
    return {
      quantity("E", Dimension::pressure, "Young's modulus (10GPa)"),
      quantity("nu", Dimension::number, "Poisson's ratio, at least 0 and below 0.5"),
      quantity("phi", Dimension::angle, "friction angle in degrees, at least 0 and below 90"),
      quantity("sigma-c", Dimension::pressure, "uniaxial compressive strength (15MPa)"),
      quantity("radius",
               Dimension::length,
               "radius of each sphere [" + format_quantity(scene.radius, Dimension::length) + "]"),
      quantity("force-max",
               Dimension::force,
               "peak normal force [" + format_quantity(scene.force_max, Dimension::force) + "]")};
  }

  std::vector<Setting> solver_settings()
  {
    const SolverOptions defaults;
    const auto number = [](const char *name, const std::string &help, const double default_value) {
      return Setting{name,
                     Kind::quantity,
                     help + " [" + format_quantity(default_value, Dimension::number) + "]"};
    };
    const auto count = [](const char *name, const std::string &help, const unsigned int value) {
      return Setting{name, Kind::count, help + " [" + std::to_string(value) + "]"};
    };
    const auto on_off = [](const char *name, const std::string &help) {
      return Setting{name, Kind::choice, help + ": on or off [on]", Dimension::number, {"on", "off"}};
    };
    return {
      Setting{"mesh",
              Kind::choice,
              "fitted to the contact, or published: the paper's three zones [fitted]",
              Dimension::number,
              {"fitted", "published"}},
      count("resolution", "elements across the contact radius at the peak", defaults.resolution),
      Setting{"surface-halvings",
              Kind::choice,
              "further halvings of the cells at the surface: auto (1 where strongly plastic), 0 to 4 [auto]",
              Dimension::number,
              {"auto", "0", "1", "2", "3", "4"}},
      Setting{"element",
              Kind::choice,
              "serendipity (8 nodes, 2x2 points), quadratic (9, 3x3) or linear (4, 2x2: locks) [serendipity]",
              Dimension::number,
              {"serendipity", "quadratic", "linear"}},
      count("level", "uniform refinements of the whole mesh on top", defaults.level),
      number("domain-radius", "far boundary, in contact radii", defaults.domain_radius),
      number("mesh-stretch", "stretches the fitted mesh by a factor", defaults.mesh_stretch),
      number("step-tolerance",
             "accuracy of the force in the load step, relative to the peak force",
             defaults.step_tolerance),
      count("loading-steps",
            "loading steps of the finest run, even; 0: as many as step-tolerance needs",
            defaults.loading_steps),
      on_off("extrapolation", "extrapolate in the load step"),
      on_off("predictor", "start a step from the extrapolated last one"),
      on_off("condensation", "condense what neither yields nor touches"),
      on_off("closed-form", "Hertz where nothing yields and no fields are asked for"),
      Setting{"contact",
              Kind::choice,
              "how the contact is enforced: augmented or penalty [augmented]",
              Dimension::number,
              {"augmented", "penalty"}},
      number("penalty-stiffness", "contact stiffness in units of E/a", defaults.penalty_stiffness),
      Setting{"units",
              Kind::choice,
              "units in which the equations are solved: scaled or si [scaled]",
              Dimension::number,
              {"scaled", "si"}},
      Setting{"surface",
              Kind::choice,
              "half-space under a parabola, or the sphere itself (needs domain-radius <= R/a): "
              "parabola or sphere [parabola]",
              Dimension::number,
              {"parabola", "sphere"}}};
  }

  std::vector<Case> read_grid(const SettingTexts &texts)
  {
    const auto moduli    = read_list(texts, "E", Dimension::pressure);
    const auto ratios    = read_list(texts, "nu", Dimension::number);
    const auto angles    = read_list(texts, "phi", Dimension::angle);
    const auto strengths = read_list(texts, "sigma-c", Dimension::pressure);
    const auto radii     = read_list(texts, "radius", Dimension::length, Scene{}.radius);
    const auto forces    = read_list(texts, "force-max", Dimension::force, Scene{}.force_max);

    std::vector<Case> cases;
    for (const double modulus : moduli)
      for (const double ratio : ratios)
        for (const double angle : angles)
          for (const double strength : strengths)
            for (const double radius : radii)
              for (const double force : forces)
                {
                  Case next{};
                  next.material.youngs_modulus       = modulus;
                  next.material.poisson_ratio        = ratio;
                  next.material.friction_angle       = radians(angle);
                  next.material.compressive_strength = strength;
                  next.scene.radius                  = radius;
                  next.scene.force_max               = force;
                  next.friction_angle_degrees        = angle;
                  next.material.check();
                  next.scene.check();
                  cases.push_back(next);
                }
    return cases;
  }

  Case read_case(const SettingTexts &texts)
  {
    for (const Setting &setting : scene_settings())
      if (const auto text = find(texts, setting.name))
        parse_quantity(setting.name, *text, setting.dimension); // a list is no number
    return read_grid(texts).front();
  }

  SolverOptions read_solver_options(const SettingTexts &texts)
  {
    SolverOptions options;
    const auto    read_count = [&](const char *name, unsigned int &value) {
      if (const auto text = find(texts, name))
        value = parse_count(name, *text);
    };
    const auto read_number = [&](const char *name, double &value) {
      if (const auto text = find(texts, name))
        value = parse_quantity(name, *text, Dimension::number);
    };
    options.mesh = parse_mesh_kind(choose(texts, "mesh", to_string(options.mesh)));
    read_count("resolution", options.resolution);
    const std::string halvings = choose(texts, "surface-halvings", "auto");
    if (halvings != "auto")
      options.surface_halvings = parse_count("surface-halvings", halvings);
    options.element = parse_element(choose(texts, "element", to_string(options.element)));
    read_count("level", options.level);
    read_number("domain-radius", options.domain_radius);
    read_number("mesh-stretch", options.mesh_stretch);
    read_number("step-tolerance", options.step_tolerance);
    read_count("loading-steps", options.loading_steps);
    read_number("penalty-stiffness", options.penalty_stiffness);
    const auto read_switch = [&](const char *name, bool &value) {
      value = choose(texts, name, value ? "on" : "off") == "on";
    };
    read_switch("extrapolation", options.extrapolation);
    read_switch("predictor", options.predictor);
    read_switch("condensation", options.condensation);
    read_switch("closed-form", options.closed_form);
    options.contact = choose(texts, "contact", "augmented") == "penalty" ? ContactMethod::penalty
                                                                         : ContactMethod::augmented;
    options.units   = choose(texts, "units", "scaled") == "si" ? Units::si : Units::scaled;
    options.surface =
      choose(texts, "surface", "parabola") == "sphere" ? Surface::sphere : Surface::parabola;
    options.check();
    return options;
  }
} // namespace dpcontact
