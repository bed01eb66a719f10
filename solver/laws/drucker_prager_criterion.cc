#include "solver/laws/criterion.h"
#include "solver/laws/drucker_prager.h"

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
    definition.onset_is_known = [](const Material &m) { return m.flow_stress_ratio == 1; };
    return definition;
  }

  namespace laws
  {
    DruckerPrager
    DruckerPrager::of(const Material &material, const double stress_unit, const double strain_unit)
    {
      const double  phi     = material.friction_angle.radians();
      const double  sigma_c = material.compressive_strength / stress_unit;
      DruckerPrager law{material.shear_modulus(stress_unit, strain_unit),
                        material.bulk_modulus(stress_unit, strain_unit),
                        drucker_prager_alpha(phi),
                        drucker_prager_strength(phi, sigma_c)};
      law.xi                = drucker_prager_strength(phi, 1);
      law.hardening         = material.hardening / (stress_unit / strain_unit);
      law.flow_stress_ratio = material.flow_stress_ratio;
      if (material.dilation_angle)
        law.flow_alpha = drucker_prager_alpha(material.dilation_angle->radians());
      return law;
    }
  } // namespace laws
} // namespace dpcontact
