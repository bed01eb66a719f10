#include "meshing/errors.h"
#include "solver/laws/criterion.h"
#include "solver/laws/strengths.h"

namespace dpcontact
{
  CriterionDefinition von_mises_criterion()
  {
    MaterialParameter yield_stress;
    yield_stress.name       = "yield_stress";
    yield_stress.symbol     = "yield stress";
    yield_stress.title      = "uniaxial yield stress";
    yield_stress.help       = "uniaxial yield stress, instead of 3 (1 - sin(phi))/(3 - sin(phi)) "
                              "sigma-c";
    yield_stress.dimension  = Dimension::pressure;
    yield_stress.instead_of = "sigma_c";
    yield_stress.makes_needless = "phi";
    yield_stress.set            = [](Material &m, const double value) {
      m.friction_angle       = Angle(0);
      m.compressive_strength = value;
    };

    CriterionDefinition definition{};
    definition.criterion          = Criterion::von_mises;
    definition.parameters         = {yield_stress, hardening_parameter()};
    definition.has_friction_angle = false;
    definition.strength_symbol    = yield_stress.symbol;
    definition.from_rock          = [](Material &m) {
      m.compressive_strength =
        laws::von_mises_yield_stress(m.friction_angle.radians(), m.compressive_strength);
      m.friction_angle = Angle(0);
    };
    definition.check = [](const Material &m) {
      if (m.friction_angle != Angle(0))
        throw InputError("friction angle phi is set, but von-mises has none: leave it out, or use "
                         "drucker-prager or mohr-coulomb.");
    };
    definition.shear_strength = [](const Material &m) {
      return laws::drucker_prager_strength(0, m.compressive_strength);
    };
    definition.inscribed_cone = [](const Material &) { return 1.; };
    return definition;
  }
} // namespace dpcontact
