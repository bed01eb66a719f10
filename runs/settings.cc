#include "runs/settings.h"

#include "meshing/errors.h"
#include "solver/laws/mohr_coulomb.h"
#include "solver/laws/von_mises.h"

#include <algorithm>
#include <cmath>
#include <limits>
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
      Setting{"criterion",
              Kind::choice,
              "yield criterion: drucker-prager, von-mises or mohr-coulomb [drucker-prager]",
              Dimension::number,
              {"drucker-prager", "von-mises", "mohr-coulomb"}},
      quantity("E", Dimension::pressure, "Young's modulus (10GPa)"),
      quantity("nu", Dimension::number, "Poisson's ratio, at least 0 and below 0.5"),
      quantity("phi", Dimension::angle, "friction angle in degrees, at least 0 and below 90"),
      quantity("sigma-c", Dimension::pressure, "uniaxial compressive strength (15MPa)"),
      quantity("cohesion",
               Dimension::pressure,
               "mohr-coulomb: cohesion C, instead of sigma-c = 2 C cos(phi)/(1 - sin(phi))"),
      quantity(
        "yield-stress",
        Dimension::pressure,
        "von-mises: uniaxial yield stress, instead of 3 (1 - sin(phi))/(3 - sin(phi)) sigma-c"),
      quantity("flow-stress-ratio",
               Dimension::number,
               "drucker-prager: K, from 0.778 to 1 (the circular cone) [1]"),
      quantity(
        "dilation",
        Dimension::angle,
        "drucker-prager, mohr-coulomb: dilation angle in degrees, 0 to phi [phi: associated]"),
      quantity(
        "hardening",
        Dimension::pressure,
        "drucker-prager, von-mises: growth of the uniaxial strength with plastic strain [0Pa]"),
      quantity(
        "tension-cutoff", Dimension::pressure, "mohr-coulomb: largest tensile stress [none]"),
      quantity("radius",
               Dimension::length,
               "radius of each sphere [" + format_quantity(scene.radius, Dimension::length) + "]"),
      quantity("force-max",
               Dimension::force,
               "peak normal force [" + format_quantity(scene.force_max, Dimension::force) + "]"),
      quantity("load-level",
               Dimension::number,
               "instead of force-max: Lambda, the peak force over F_y of the material and radius")};
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
      return Setting{
        name, Kind::choice, help + ": on or off [on]", Dimension::number, {"on", "off"}};
    };
    return {
      Setting{"geometry",
              Kind::choice,
              "axisymmetric; in space a sector, the whole disc, or a quarter on the published mesh "
              "[axisymmetric]",
              Dimension::number,
              {"axisymmetric", "sector", "disc", "published"}},
      number("sector-angle", "of a sector in degrees: 90 or 45", defaults.sector_angle),
      Setting{"linear-solver",
              Kind::choice,
              "in space: auto (by size), direct or iterative [auto]",
              Dimension::number,
              {"auto", "direct", "iterative"}},
      Setting{
        "mesh",
        Kind::choice,
        "fitted to the contact, or published: the paper's three zones [fitted; of the published "
        "geometry published]",
        Dimension::number,
        {"fitted", "published"}},
      count("resolution",
            "elements across the contact radius at the peak; in space [" +
              std::to_string(SolverOptions::of(Geometry::sector).resolution) + "], otherwise",
            defaults.resolution),
      Setting{"surface-halvings",
              Kind::choice,
              "further halvings of the cells at the surface: auto (1 where strongly plastic), 0 to "
              "4 [auto]",
              Dimension::number,
              {"auto", "0", "1", "2", "3", "4"}},
      Setting{
        "element",
        Kind::choice,
        "serendipity (8 nodes, 2x2 points), quadratic (9, 3x3; in space 27, 3x3x3), brick (4 or "
        "8, mean dilatation) or linear (4 or 8: locks) [serendipity; in space quadratic, of the "
        "published geometry brick]",
        Dimension::number,
        {"serendipity", "quadratic", "brick", "linear"}},
      count("level", "uniform refinements of the whole mesh on top", defaults.level),
      count("octaves",
            "contacts down to 2^-octaves of the largest are resolved as well, for families",
            defaults.octaves),
      number("domain-radius",
             "far boundary of the fitted mesh, in contact radii",
             defaults.domain_radius),
      Setting{"outer-radius",
              Kind::quantity,
              "of the published mesh, which the paper does not print [" +
                format_quantity(defaults.outer_radius, Dimension::length) + "]",
              Dimension::length},
      number("mesh-stretch", "stretches the fitted mesh by a factor", defaults.mesh_stretch),
      number("mesh-distortion",
             "moves interior vertices at random by up to this share of an edge",
             defaults.mesh_distortion),
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

  namespace
  {
    /// The criterion, refusing what it does not have.
    Criterion read_criterion(const SettingTexts &texts)
    {
      const auto      text      = find(texts, "criterion");
      const Criterion criterion = text ? parse_criterion(*text) : Criterion::drucker_prager;
      const auto      refuse =
        [&](const char *name, const char *owners, const bool has, const char *why) {
          if (find(texts, name) && !has)
            throw InputError(std::string(name) + " is a parameter of " + owners + ", not of " +
                             to_string(criterion) + why + ": leave it out");
        };
      const bool cone    = criterion == Criterion::drucker_prager;
      const bool metal   = criterion == Criterion::von_mises;
      const bool pyramid = criterion == Criterion::mohr_coulomb;
      refuse("cohesion", "mohr-coulomb", pyramid, "");
      refuse("yield-stress", "von-mises", metal, "");
      refuse("flow-stress-ratio", "drucker-prager", cone, "");
      refuse("dilation", "drucker-prager and mohr-coulomb", !metal, "");
      refuse("hardening", "drucker-prager and von-mises", !pyramid, "");
      refuse("tension-cutoff", "mohr-coulomb", pyramid, "");
      for (const char *const instead : {"cohesion", "yield-stress"})
        if (find(texts, instead) && find(texts, "sigma-c"))
          throw InputError(std::string(instead) + " and sigma-c say the same: give one of them");
      if (find(texts, "yield-stress") && find(texts, "phi"))
        throw InputError(
          "phi is set, but von-mises with a yield-stress has no friction angle: leave "
          "it out");
      return criterion;
    }

    /// All combinations of one value of each list, the first list varying slowest.
    std::vector<std::vector<double>> combinations(const std::vector<std::vector<double>> &lists)
    {
      std::vector<std::vector<double>> result{{}};
      for (const auto &list : lists)
        {
          std::vector<std::vector<double>> longer;
          for (const auto &start : result)
            for (const double value : list)
              {
                longer.push_back(start);
                longer.back().push_back(value);
              }
          result = std::move(longer);
        }
      return result;
    }
  } // namespace

  std::vector<Case> read_grid(const SettingTexts &texts)
  {
    constexpr double unset         = std::numeric_limits<double>::quiet_NaN();
    const Criterion  criterion     = read_criterion(texts);
    const bool       by_load_level = find(texts, "load-level").has_value();
    if (by_load_level && find(texts, "force-max"))
      throw InputError("load-level and force-max say the same: give one of them");
    const bool  by_yield_stress = find(texts, "yield-stress").has_value();
    const bool  by_cohesion     = find(texts, "cohesion").has_value();
    const char *strength = by_yield_stress ? "yield-stress" : by_cohesion ? "cohesion" : "sigma-c";
    const Material defaults;

    std::vector<Case> cases;
    for (const std::vector<double> &value : combinations(
           {read_list(texts, "E", Dimension::pressure),
            read_list(texts, "nu", Dimension::number),
            by_yield_stress ? std::vector<double>{0.} : read_list(texts, "phi", Dimension::angle),
            read_list(texts, strength, Dimension::pressure),
            read_list(texts, "flow-stress-ratio", Dimension::number, defaults.flow_stress_ratio),
            read_list(texts, "dilation", Dimension::angle, unset),
            read_list(texts, "hardening", Dimension::pressure, defaults.hardening),
            read_list(texts, "tension-cutoff", Dimension::pressure, unset),
            read_list(texts, "radius", Dimension::length, Scene{}.radius),
            by_load_level ? read_list(texts, "load-level", Dimension::number)
                          : read_list(texts, "force-max", Dimension::force, Scene{}.force_max)}))
      {
        Case next{};
        next.friction_angle_degrees        = value[2];
        next.dilation_angle_degrees        = std::isnan(value[5]) ? value[2] : value[5];
        next.material.criterion            = criterion;
        next.material.youngs_modulus       = value[0];
        next.material.poisson_ratio        = value[1];
        next.material.friction_angle       = radians(value[2]);
        next.material.compressive_strength = value[3];
        next.material.flow_stress_ratio    = value[4];
        if (!std::isnan(value[5]) && value[5] != value[2])
          next.material.dilation_angle = radians(value[5]);
        next.material.hardening = value[6];
        if (!std::isnan(value[7]))
          next.material.tension_cutoff = value[7];
        if (by_cohesion)
          next.material.compressive_strength =
            laws::mohr_coulomb_compressive_strength(next.material.friction_angle, value[3]);
        if (criterion == Criterion::von_mises && !by_yield_stress)
          {
            next.material.compressive_strength =
              laws::von_mises_yield_stress(next.material.friction_angle, value[3]);
            next.material.friction_angle  = next.friction_angle_degrees =
              next.dilation_angle_degrees = 0;
          }
        next.scene.radius    = value[8];
        next.scene.force_max = value[9]; // Λ is one that F_y, known below, turns into a force
        next.material.check();
        if (by_load_level)
          next.scene.force_max = value[9] * first_yield(next.material, value[8]).force;
        next.scene.check();
        cases.push_back(next);
      }
    return cases;
  }

  Case read_case(const SettingTexts &texts)
  {
    for (const Setting &setting : scene_settings())
      if (const auto text = find(texts, setting.name); text && setting.kind == Kind::quantity)
        parse_quantity(setting.name, *text, setting.dimension); // a list is no number
    return read_grid(texts).front();
  }

  SolverOptions read_solver_options(const SettingTexts &texts)
  {
    SolverOptions options =
      SolverOptions::of(parse_geometry(choose(texts, "geometry", "axisymmetric")));
    const auto read_count = [&](const char *name, unsigned int &value) {
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
    read_number("sector-angle", options.sector_angle);
    options.linear_solver =
      parse_linear_solver(choose(texts, "linear-solver", to_string(options.linear_solver)));
    read_count("level", options.level);
    read_count("octaves", options.octaves);
    read_number("domain-radius", options.domain_radius);
    if (const auto text = find(texts, "outer-radius"))
      options.outer_radius = parse_quantity("outer-radius", *text, Dimension::length);
    read_number("mesh-stretch", options.mesh_stretch);
    read_number("mesh-distortion", options.mesh_distortion);
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
