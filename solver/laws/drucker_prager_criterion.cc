#include "solver/laws/criterion.h"
#include "solver/laws/strengths.h"

namespace dpcontact
{
  CriterionDefinition drucker_prager_criterion()
  {
    MaterialParameter ratio;
    ratio.name          = "flow_stress_ratio";
    ratio.symbol        = "K";
    ratio.title         = "flow stress ratio K";
    ratio.help          = "K, from 0.778 to 1 (the circular cone)";
    ratio.description   = "K of Drucker-Prager; 1 is the circular cone";
    ratio.range         = {0.778, 1};
    ratio.default_value = 1;
    ratio.get           = [](const Material &m) { return m.flow_stress_ratio; };
    ratio.set           = [](Material &m, const double value) { m.flow_stress_ratio = value; };

    CriterionDefinition definition{};
    definition.criterion      = Criterion::drucker_prager;
    definition.parameters     = {ratio, dilation_parameter(), hardening_parameter()};
    definition.check          = check_dilation;
    definition.shear_strength = [](const Material &m) {
      return laws::drucker_prager_strength(m.friction_angle.radians(), m.compressive_strength) * 2 /
             (1 + 1 / m.flow_stress_ratio);
    };
    // t = q in compression and q/K in extension, where the section is narrowest
    definition.inscribed_cone = [](const Material &m) { return m.flow_stress_ratio; };
    return definition;
  }
} // namespace dpcontact
