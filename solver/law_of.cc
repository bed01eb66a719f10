#include "solver/law_of.h"

#include <cmath>

namespace dpcontact
{
  laws::Law law_of(const Material &material, const double stress_unit, const double strain_unit)
  {
    const double modulus_unit = stress_unit / strain_unit;
    const double modulus      = material.youngs_modulus / modulus_unit;
    const double nu           = material.poisson_ratio;
    const double shear = modulus / (2 * (1 + nu)), bulk = modulus / (3 * (1 - 2 * nu));
    const double phi       = material.friction_angle;
    const double sigma_c   = material.compressive_strength / stress_unit;
    const double hardening = material.hardening / modulus_unit;
    switch (material.criterion)
      {
        case Criterion::von_mises:
          return laws::VonMises{shear, bulk, sigma_c, hardening};
        case Criterion::mohr_coulomb:
          {
            laws::MohrCoulomb law{shear, bulk, phi, laws::mohr_coulomb_cohesion(phi, sigma_c)};
            law.dilation_angle = material.dilation_angle;
            if (material.tension_cutoff)
              law.tension_cutoff = *material.tension_cutoff / stress_unit;
            return law;
          }
        case Criterion::drucker_prager:
          break;
      }
    laws::DruckerPrager law{
      shear, bulk, laws::drucker_prager_alpha(phi), laws::drucker_prager_strength(phi, sigma_c)};
    law.xi                = laws::drucker_prager_strength(phi, 1);
    law.hardening         = hardening;
    law.flow_stress_ratio = material.flow_stress_ratio;
    if (material.dilation_angle)
      law.flow_alpha = laws::drucker_prager_alpha(*material.dilation_angle);
    return law;
  }
} // namespace dpcontact
