#include "solver/laws/von_mises.h"

#include "solver/laws/material.h"

#include <cmath>

namespace dpcontact::laws
{
  double VonMises::yield_function(const StressTensor &stress, const double hardening_variable) const
  {
    return std::sqrt(1.5) * dealii::deviator(stress).norm() -
           (yield_stress + hardening * hardening_variable);
  }

  Response VonMises::evaluate(const State &old_state, const StressTensor &strain) const
  {
    const double G              = shear_modulus;
    StressTensor elastic_strain = strain;
    elastic_strain -= old_state.plastic_strain;
    const double       p        = bulk_modulus * dealii::trace(elastic_strain);
    const StressTensor deviator = trial_deviator(elastic_strain, G);
    const double       q        = std::sqrt(1.5) * deviator.norm();
    const double       excess   = q - (yield_stress + hardening * old_state.hardening_variable);

    Response response;
    response.state = old_state;
    if (excess <= 0)
      {
        response.branch = Branch::elastic;
        response.stress = with_pressure(deviator, p);
        fill_isotropic_tangent(response.tangent, bulk_modulus, 2 * G);
        return response;
      }

    const double flow  = excess / (3 * G + hardening); // Δε̄ᵖ
    const double scale = 1 - 3 * G * flow / q;
    response.branch    = Branch::regular;
    response.stress    = with_pressure(scale * deviator, p);
    response.state.plastic_strain += 1.5 * flow / q * deviator;
    response.state.hardening_variable += flow;

    fill_isotropic_tangent(response.tangent, bulk_modulus, 2 * G * scale);
    const double  along = 9 * G * G * (flow / q - 1 / (3 * G + hardening)) / (q * q);
    double *const D     = response.tangent.begin_raw();
    for (unsigned int i = 0; i < 6; ++i)
      for (unsigned int j = 0; j < 6; ++j)
        D[6 * i + j] += along * (deviator.access_raw_entry(i) * deviator.access_raw_entry(j));
    return response;
  }

  VonMises
  VonMises::of(const Material &material, const double stress_unit, const double strain_unit)
  {
    return {material.shear_modulus(stress_unit, strain_unit),
            material.bulk_modulus(stress_unit, strain_unit),
            material.compressive_strength / stress_unit,
            material.hardening / (stress_unit / strain_unit)};
  }
} // namespace dpcontact::laws
