#include "solver/problem/option_list.h"

#include "meshing/errors.h"
#include "solver/problem/quantity.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace dpcontact
{
  namespace
  {
    using Allows = std::function<bool(double)>;

    Allows within(const double low, const double high)
    {
      return [low, high](const double value) { return value >= low && value <= high; };
    }

    SolverOption count(const char  *name,
                       const char  *help,
                       unsigned int SolverOptions::*const member,
                       const Allows                      &allows,
                       const char                        *range_text)
    {
      SolverOption option;
      option.name       = name;
      option.help       = help;
      option.is_count   = true;
      option.allows     = allows;
      option.range_text = range_text;
      option.get        = [member](const SolverOptions &o) { return o.*member; };
      option.read       = [member, key = option.name](SolverOptions &o, const std::string &text) {
        o.*member = parse_count(key, text);
      };
      return option;
    }

    SolverOption number(const char *name,
                        const char *help,
                        double SolverOptions::*const member,
                        const Allows                &allows,
                        const char                  *range_text,
                        const Dimension              dimension = Dimension::number)
    {
      SolverOption option;
      option.name       = name;
      option.help       = help;
      option.dimension  = dimension;
      option.allows     = allows;
      option.range_text = range_text;
      option.get        = [member](const SolverOptions &o) { return o.*member; };
      option.read       = [member, dimension, key = option.name](SolverOptions     &o,
                                                           const std::string &text) {
        o.*member = parse_quantity(key, text, dimension);
      };
      return option;
    }

    template <class Enum>
    SolverOption word(const char *name, const char *help, Enum SolverOptions::*const member)
    {
      SolverOption option;
      option.name    = name;
      option.help    = help;
      option.choices = enum_names<Enum>();
      option.get  = [member](const SolverOptions &o) { return std::string(to_string(o.*member)); };
      option.read = [member](SolverOptions &o, const std::string &text) {
        o.*member = parse_enum<Enum>(text);
      };
      return option;
    }

    /// @throws InputError unless the text is one of the option's choices.
    void check_choice(const SolverOption &option, const std::string &text)
    {
      if (std::find(option.choices.begin(), option.choices.end(), text) == option.choices.end())
        throw InputError(option.name + ": '" + text + "' is not one of " + one_of(option.choices));
    }

    SolverOption on_off(const char *name, const char *help, bool SolverOptions::*const member)
    {
      SolverOption option;
      option.name    = name;
      option.help    = std::string(help) + ": on or off";
      option.choices = {"on", "off"};
      option.get     = [member](const SolverOptions &o) {
        return std::string(o.*member ? "on" : "off");
      };
      option.read = [member, option](SolverOptions &o, const std::string &text) {
        check_choice(option, text);
        o.*member = text == "on";
      };
      return option;
    }

    SolverOption surface_halvings()
    {
      SolverOption option;
      option.name    = "surface-halvings";
      option.help    = "further halvings of the cells at the surface: auto (1 where strongly "
                       "plastic), 0 to 4";
      option.choices = {"auto", "0", "1", "2", "3", "4"};
      option.get     = [](const SolverOptions &o) {
        return o.surface_halvings ? std::to_string(*o.surface_halvings) : std::string("auto");
      };
      option.read = [option](SolverOptions &o, const std::string &text) {
        check_choice(option, text);
        o.surface_halvings.reset();
        if (text != "auto")
          o.surface_halvings = parse_count(option.name, text);
      };
      return option;
    }

    SolverOption geometry()
    {
      SolverOption option = word("geometry",
                                 "axisymmetric; in space a sector, the whole disc, or a quarter on "
                                 "the published mesh",
                                 &SolverOptions::geometry);
      option.read         = [](SolverOptions &o, const std::string &text) {
        o = SolverOptions::of(parse_enum<Geometry>(text)); // its defaults, so it is read first
      };
      return option;
    }

    SolverOption where(std::function<bool(const SolverOptions &)> applies, SolverOption option)
    {
      option.applies = std::move(applies);
      return option;
    }

    bool is_in_space(const SolverOptions &options) { return in_space(options.geometry); }

    bool has_published_mesh(const SolverOptions &options)
    {
      return options.mesh == MeshKind::published;
    }

    std::vector<SolverOption> geometry_options()
    {
      using O = SolverOptions;
      return {
        where(is_in_space, geometry()),
        where(is_in_space,
              number(
                "sector-angle",
                "of a sector in degrees: 90 or 45",
                &O::sector_angle,
                [](const double v) { return v == 90 || v == 45; },
                "90 or 45")),
        where(is_in_space,
              word("linear-solver",
                   "in space: auto (by size), direct or iterative",
                   &O::linear_solver)),
      };
    }

    std::vector<SolverOption> mesh_options()
    {
      using O = SolverOptions;
      return {
        word("mesh", "fitted to the contact, or published: the paper's three zones", &O::mesh),
        count("resolution",
              "elements across the contact radius at the peak",
              &O::resolution,
              within(2, 1024),
              "from 2 to 1024"),
        surface_halvings(),
        word("element",
             "serendipity (8 nodes, 2x2 points), quadratic (9, 3x3; in space 27, 3x3x3), brick (4 "
             "or 8, mean dilatation) or linear (4 or 8: locks)",
             &O::element),
        count("level",
              "uniform refinements of the whole mesh on top",
              &O::refinements,
              within(0, 6),
              "at most 6"),
        count("octaves",
              "contacts down to 2^-octaves of the largest are resolved as well, for families",
              &O::octaves,
              within(0, 12),
              "at most 12"),
        number(
          "domain-radius",
          "far boundary of the fitted mesh, in contact radii",
          &O::domain_radius,
          [](const double v) { return std::isfinite(v) && v >= 10; },
          "finite and at least 10 contact radii"),
        where(has_published_mesh,
              number(
                "outer-radius",
                "of the published mesh, which the paper does not print",
                &O::outer_radius,
                [](const double v) { return std::isfinite(v) && v > 0; },
                "finite and greater than 0",
                Dimension::length)),
        number("mesh-stretch",
               "stretches the fitted mesh by a factor",
               &O::mesh_stretch,
               within(0.5, 2),
               "from 0.5 to 2"),
        number("mesh-distortion",
               "moves interior vertices at random by up to this share of an edge",
               &O::mesh_distortion,
               within(0, 0.3),
               "from 0 to 0.3"),
      };
    }

    std::vector<SolverOption> path_options()
    {
      using O = SolverOptions;
      return {
        number(
          "step-tolerance",
          "accuracy of the force in the load step, relative to the peak force",
          &O::step_tolerance,
          [](const double v) { return v > 0 && v <= 1; },
          "above 0 and at most 1"),
        // The run with half as many steps needs a curve that can be fitted as well.
        count(
          "loading-steps",
          "loading steps of the finest run, even; 0: as many as step-tolerance needs",
          &O::loading_steps,
          [](const double v) { return v == 0 || (std::fmod(v, 2) == 0 && v >= 16 && v <= 4096); },
          "even, from 16 to 4096 (0: as many as step-tolerance needs)"),
        on_off("extrapolation", "extrapolate in the load step", &O::extrapolation),
        on_off("predictor", "start a step from the extrapolated last one", &O::predictor),
        on_off("condensation", "condense what neither yields nor touches", &O::condensation),
        on_off(
          "closed-form", "Hertz where nothing yields and no fields are asked for", &O::closed_form),
      };
    }

    std::vector<SolverOption> contact_options()
    {
      using O = SolverOptions;
      return {
        word("contact", "how the contact is enforced: augmented or penalty", &O::contact),
        number(
          "penalty-stiffness",
          "contact stiffness in units of E/a",
          &O::penalty_stiffness,
          [](const double v) { return v > 0 && v <= 1e9; },
          "above 0 and at most 1e9, beyond which the rounding of the gap moves the force"),
        word("units", "units in which the equations are solved: scaled or si", &O::units),
        word("surface",
             "half-space under a parabola, or the sphere itself (needs domain-radius <= R/a): "
             "parabola or sphere",
             &O::surface),
      };
    }

    /// A member that is added to SolverOptions breaks this line, and reminds of the lists above.
    void every_member_has_an_entry(const SolverOptions &options)
    {
      [[maybe_unused]] const auto &[geometry,
                                    sector_angle,
                                    linear_solver,
                                    mesh,
                                    resolution,
                                    surface_halvings,
                                    element,
                                    refinements,
                                    octaves,
                                    domain_radius,
                                    outer_radius,
                                    mesh_stretch,
                                    mesh_distortion,
                                    step_tolerance,
                                    loading_steps,
                                    extrapolation,
                                    predictor,
                                    condensation,
                                    closed_form,
                                    contact,
                                    penalty_stiffness,
                                    units,
                                    surface] = options;
    }
  } // namespace

  std::string SolverOption::text(const SolverOptions &options) const
  {
    const OptionValue value = get(options);
    if (const auto *const given = std::get_if<std::string>(&value))
      return *given;
    if (const auto *const given = std::get_if<unsigned int>(&value))
      return std::to_string(*given);
    return format_quantity(std::get<double>(value), dimension);
  }

  const std::vector<SolverOption> &solver_options()
  {
    static const std::vector<SolverOption> list = [] {
      every_member_has_an_entry({});
      std::vector<SolverOption> all;
      for (const auto &part :
           {geometry_options(), mesh_options(), path_options(), contact_options()})
        all.insert(all.end(), part.begin(), part.end());
      return all;
    }();
    return list;
  }

  std::string default_text(const SolverOption &option)
  {
    std::string text = option.text({});
    if (option.name == "geometry")
      return text;
    const std::string in_space  = option.text(SolverOptions::of(Geometry::sector));
    const std::string published = option.text(SolverOptions::of(Geometry::published));
    if (in_space != text)
      text += "; in space " + in_space;
    if (published != in_space)
      text += "; of the published geometry " + published;
    return text;
  }

  void check_option_ranges(const SolverOptions &options)
  {
    for (const SolverOption &option : solver_options())
      {
        if (!option.allows)
          continue;
        const OptionValue given = option.get(options);
        const auto *const count = std::get_if<unsigned int>(&given);
        const double      value = count != nullptr ? *count : std::get<double>(given);
        if (option.allows(value))
          continue;
        std::ostringstream message;
        message << "option " << option.name << " is " << value << "; it must be "
                << option.range_text;
        throw InputError(message.str());
      }
  }
} // namespace dpcontact
