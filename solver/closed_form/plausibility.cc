#include "solver/closed_form/plausibility.h"

#include "meshing/errors.h"
#include "solver/closed_form/first_yield.h"
#include "solver/closed_form/hertz.h"
#include "solver/laws/criterion.h"
#include "solver/laws/strengths.h"
#include "solver/problem/quantity.h"

#include <algorithm>
#include <cmath>

namespace dpcontact
{
  namespace
  {
    // Rubber has 1 MPa, diamond 1 TPa. Rock has sigma_c/E = 1/1000 to 1/200, steel 1/1000, clay
    // 1/100.
    constexpr Range usual_modulus{1e6, 2e12};
    constexpr Range usual_strength_ratio{1e-5, 0.1};
    // From the finest powder to a boulder.
    constexpr Range usual_radius{1e-7, 1};
    // The universal table ends at 10⁴; below 10⁻³ nothing can have been meant to yield.
    constexpr Range usual_load_level{1e-3, 1e4};
    // 90 degrees are 1.57 radians. Dilation may be small, but not as small as that.
    constexpr double largest_radians = 1.6;
    constexpr double least_dilation  = 0.5;
    constexpr double largest_contact = 0.1; ///< a/R that small strain allows
    constexpr double widest_contact  = 1;   ///< a/R that a sphere has
    /// r/a out to which the surface may open. Measured at E = 10 GPa, nu = 0.2, phi = 30 degrees,
    /// sigma_c = 15 MPa, Lambda = 10: 17 is solved, 20 is not at the default resolution.
    constexpr double farthest_tension = 18;

    std::string number(const double value) { return format_quantity(value, Dimension::number); }
    std::string pressure_text(const double value)
    {
      return format_quantity(value, Dimension::pressure);
    }

    /// "below 1e-05" or "above 0.1"; empty where the value is usual.
    std::string
    outside(const double value, const Range &usual, const Dimension dimension = Dimension::number)
    {
      if (value < usual.low)
        return "below " + format_quantity(usual.low, dimension);
      if (value > usual.high)
        return "above " + format_quantity(usual.high, dimension);
      return "";
    }

    void doubt_angle(const std::string        &name,
                     const double              degrees,
                     const double              least,
                     std::vector<std::string> &doubts)
    {
      if (degrees > 0 && degrees < least)
        doubts.push_back(name + " is " + format_quantity(degrees, Dimension::angle) +
                         ": angles are in degrees, not in radians");
    }

    void doubt_cutoff(const Material &material, std::vector<std::string> &doubts)
    {
      if (!material.tension_cutoff)
        return;
      const double apex =
        laws::mohr_coulomb_apex(material.friction_angle.radians(), material.compressive_strength);
      if (*material.tension_cutoff >= apex)
        doubts.push_back("the tension cut-off T0 = " + pressure_text(*material.tension_cutoff) +
                         " cuts nothing off: the pyramid ends at " + pressure_text(apex));
    }

    void doubt_material(const Material &material, std::vector<std::string> &doubts)
    {
      const CriterionDefinition &criterion = definition_of(material.criterion);
      const double               modulus   = material.youngs_modulus;
      if (const auto text = outside(modulus, usual_modulus, Dimension::pressure); !text.empty())
        doubts.push_back("Young's modulus E is " + pressure_text(modulus) + ", " + text +
                         ": is its unit right?");
      const double ratio = material.compressive_strength / modulus;
      if (const auto text = outside(ratio, usual_strength_ratio); !text.empty())
        doubts.push_back(criterion.strength_symbol + "/E is " + number(ratio) + ", " + text +
                         ": is the unit of one of them wrong, or are they swapped?");
      if (criterion.has_friction_angle)
        doubt_angle(
          "friction angle phi", material.friction_angle.degrees(), largest_radians, doubts);
      if (material.dilation_angle)
        doubt_angle(
          "dilation angle psi", material.dilation_angle->degrees(), least_dilation, doubts);
      if (material.hardening > modulus)
        doubts.push_back("the hardening modulus H = " + pressure_text(material.hardening) +
                         " is above E: is its unit right?");
      doubt_cutoff(material, doubts);
    }

    void doubt_radius(const double radius, std::vector<std::string> &doubts)
    {
      if (std::isinf(radius)) // a flat
        return;
      if (const auto text = outside(radius, usual_radius, Dimension::length); !text.empty())
        doubts.push_back("the sphere radius R is " + format_quantity(radius, Dimension::length) +
                         ", " + text + ": is its unit right?");
    }

    double hertz_contact_radius(const Case &input)
    {
      return hertz::contact_radius(
        input.scene, hertz::approach(input.material, input.scene, input.scene.force_max));
    }

    double hertz_pressure(const Case &input)
    {
      return hertz::peak_pressure(input.scene.force_max, hertz_contact_radius(input));
    }

    /// Outside the contact Hertz's radial stress is tension, (1 − 2ν) P₀ a²/(3 r²); the cut-off
    /// limits it out to the radius r. P₀ is the pressure at the peak, or that of first yield,
    /// beyond which it grows little.
    void check_tension(const Case &input, const Material &material)
    {
      if (!material.tension_cutoff)
        return;
      const double reached  = hertz_pressure(input);
      const double pressure = std::min(reached, first_yield(material, input.scene.radius).pressure);
      const double at_edge  = (1 - 2 * material.poisson_ratio) * pressure / 3;
      const double least    = at_edge / (farthest_tension * farthest_tension);
      if (*material.tension_cutoff < least)
        throw InputError(
          "the tension cut-off T0 = " + pressure_text(*material.tension_cutoff) +
          " is too small to be solved for: the surface would open out to more than " +
          number(farthest_tension) +
          " contact radii, where nothing but the cut-off limits its tension; give at "
          "least " +
          pressure_text(least));
    }
  } // namespace

  std::vector<std::string> doubts_about(const Case &input, const double contact_radius)
  {
    std::vector<std::string> doubts;
    const auto              &second = input.scene.second;
    doubt_material(input.material, doubts);
    if (second && second->material)
      doubt_material(*second->material, doubts);
    doubt_radius(input.scene.radius, doubts);
    if (second)
      doubt_radius(second->radius, doubts);
    std::sort(doubts.begin(), doubts.end());
    doubts.erase(std::unique(doubts.begin(), doubts.end()), doubts.end());

    const double level = input.scene.force_max / first_yield(input.material, input.scene).force;
    if (const auto text = outside(level, usual_load_level); !text.empty())
      doubts.push_back("the peak force F_max is " + number(level) +
                       " of the force at first yield, " + text +
                       (level < 1 ? ": far from yield" : ": beyond the universal table"));
    const bool   known = !std::isnan(contact_radius);
    const double width =
      (known ? contact_radius : hertz_contact_radius(input)) / input.scene.smaller_radius();
    if (width > largest_contact)
      doubts.push_back("small strain is left behind: contact radius over sphere radius is " +
                       std::string(known ? "" : "at least ") + number(width) + " (> 0.1)");
    return doubts;
  }

  std::vector<std::string> doubts_about(const Material &material, const double radius)
  {
    std::vector<std::string> doubts;
    doubt_material(material, doubts);
    doubt_radius(radius, doubts);
    return doubts;
  }

  void check_possible(const Case &input)
  {
    check_tension(input, input.material);
    if (const auto &second = input.scene.second; second && second->material)
      check_tension(input, *second->material);
    const double radius = input.scene.smaller_radius(), contact = hertz_contact_radius(input);
    if (contact > widest_contact * radius)
      throw InputError(
        "peak force F_max is " + format_quantity(input.scene.force_max, Dimension::force) +
        ", under which even an elastic contact would have a radius of " +
        format_quantity(contact, Dimension::length) +
        ", more than the sphere's R = " + format_quantity(radius, Dimension::length) +
        ": is the unit of one of them, or of E, wrong?");
    const double yield = first_yield(input.material, input.scene).force;
    if (input.scene.force_max > largest_load_level * yield)
      throw InputError(
        "peak force F_max is " + number(input.scene.force_max / yield) +
        " times the force at first yield, F_y = " + format_quantity(yield, Dimension::force) +
        "; at most " + number(largest_load_level) +
        " times is computed: is the unit of F_max, R or " +
        definition_of(input.material.criterion).strength_symbol + " wrong?");
  }

  std::string joined(const std::vector<std::string> &sentences)
  {
    std::string text;
    for (const std::string &sentence : sentences)
      text += (text.empty() ? "" : "; ") + sentence;
    return text;
  }
} // namespace dpcontact
