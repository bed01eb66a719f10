#include "solver/laws/criterion.h"
#include "solver/laws/strengths.h"

#include <algorithm>
#include <cmath>

namespace dpcontact
{
  namespace
  {
    MaterialParameter cohesion_parameter()
    {
      MaterialParameter p;
      p.name       = "cohesion";
      p.symbol     = "C";
      p.title      = "cohesion C";
      p.help       = "cohesion C, instead of sigma-c = 2 C cos(phi)/(1 - sin(phi))";
      p.dimension  = Dimension::pressure;
      p.instead_of = "sigma_c";
      p.get        = [](const Material &m) {
        return laws::mohr_coulomb_cohesion(m.friction_angle.radians(), m.compressive_strength);
      };
      p.set = [](Material &m, const double value) {
        m.compressive_strength =
          laws::mohr_coulomb_compressive_strength(m.friction_angle.radians(), value);
      };
      return p;
    }

    MaterialParameter tension_cutoff_parameter()
    {
      MaterialParameter p;
      p.name         = "tension_cutoff";
      p.symbol       = "T0";
      p.title        = "tension cut-off T0";
      p.help         = "largest tensile stress";
      p.description  = "largest tensile stress of Mohr-Coulomb; unset: no cut-off";
      p.dimension    = Dimension::pressure;
      p.default_text = "none";
      p.get          = [](const Material &m) { return m.tension_cutoff.value_or(std::nan("")); };
      p.set          = [](Material &m, const double value) {
        m.tension_cutoff.reset();
        if (!std::isnan(value))
          m.tension_cutoff = value;
      };
      return p;
    }
  } // namespace

  CriterionDefinition mohr_coulomb_criterion()
  {
    CriterionDefinition definition{};
    definition.criterion  = Criterion::mohr_coulomb;
    definition.parameters = {
      dilation_parameter(), cohesion_parameter(), tension_cutoff_parameter()};
    definition.check          = check_dilation;
    definition.shear_strength = [](const Material &m) {
      const double phi = m.friction_angle.radians();
      const double strength =
        std::cos(phi) * laws::mohr_coulomb_cohesion(phi, m.compressive_strength);
      return m.tension_cutoff ? std::min(strength, *m.tension_cutoff) : strength;
    };
    // √J₂ = (C cosφ − p sinφ)/(cosθ − sinθ sinφ/√3) is least at tanθ = −sinφ/√3, on a face
    definition.inscribed_cone = [](const Material &m) {
      const double sine = std::sin(m.friction_angle.radians());
      return (3 - sine) / std::sqrt(12 + 4 * sine * sine);
    };
    return definition;
  }
} // namespace dpcontact
