#include "solver/laws/drucker_prager.h"

#include <algorithm>
#include <cmath>

namespace dpcontact::laws
{
  namespace
  {
    using dealii::TableIndices;

    // D = (volumetric) I⊗I + (deviatoric) P + (flow) N⊗N + (coupling) (N⊗I + I⊗N), where P projects
    // on deviators and N = s/√J₂. Written straight into the 6×6 storage of SymmetricTensor<4,3>,
    // whose entries are plain components in the order 11, 22, 33, 12, 13, 23.
    void fill_tangent(Tangent            &tangent,
                      const double        volumetric,
                      const double        deviatoric,
                      const double        flow     = 0,
                      const double        coupling = 0,
                      const StressTensor &N        = {})
    {
      double *const D      = tangent.begin_raw();
      const double  normal = volumetric - deviatoric / 3;

      double n[6];
      for (unsigned int i = 0; i < 6; ++i)
        n[i] = N.access_raw_entry(i);

      for (unsigned int i = 0; i < 6; ++i)
        for (unsigned int j = 0; j < 6; ++j)
          D[6 * i + j] = flow * (n[i] * n[j]);
      for (unsigned int i = 0; i < 3; ++i)
        {
          for (unsigned int j = 0; j < 3; ++j)
            D[6 * i + j] += normal + coupling * (n[i] + n[j]);
          for (unsigned int j = 3; j < 6; ++j)
            {
              D[6 * i + j] += coupling * n[j];
              D[6 * j + i] += coupling * n[j];
            }
          D[7 * i] += deviatoric;
          D[7 * (i + 3)] += deviatoric / 2;
        }
    }
  } // namespace

  double DruckerPrager::yield_function(const StressTensor &stress,
                                       const double        hardening_variable) const
  {
    const StressTensor s = dealii::deviator(stress);
    return std::sqrt((s * s) / 2) + alpha * dealii::trace(stress) -
           (strength + xi * hardening * hardening_variable);
  }

  DruckerPrager::Response DruckerPrager::evaluate(const State        &old_state,
                                                  const StressTensor &strain) const
  {
    const double G   = shear_modulus;
    const double K   = bulk_modulus;
    const double eta = 3 * alpha;

    Response response;
    response.state = old_state;

    // Elastic trial state: deviator s and pressure p (tension positive).
    StressTensor elastic_strain = strain;
    elastic_strain -= old_state.plastic_strain;
    const double volume   = dealii::trace(elastic_strain);
    const double p        = K * volume;
    StressTensor deviator = elastic_strain;
    for (unsigned int d = 0; d < 3; ++d)
      deviator.access_raw_entry(d) -= volume / 3;
    deviator *= 2 * G;
    const double root_J2 = std::sqrt((deviator * deviator) / 2);
    const double k       = strength + xi * hardening * old_state.hardening_variable;

    const double overstress = root_J2 + eta * p - k;
    if (overstress <= 0)
      {
        response.branch = Branch::elastic;
        response.stress = deviator;
        for (unsigned int d = 0; d < 3; ++d)
          response.stress.access_raw_entry(d) += p;
        fill_tangent(response.tangent, K, 2 * G);
        return response;
      }

    // The regular return would turn the deviator round where G Δγ > √J₂, that is (without a
    // division that fails as α → 0) where √J₂ (Kη² + ξ²H) < G (ηp − k). Never with α = 0, as then k
    // > 0.
    const double cone = K * eta * eta + xi * xi * hardening;
    if (root_J2 * cone < G * (eta * p - k))
      {
        // de Souza Neto et al. eqs 8.119–8.120, solved for linear hardening: pₙ₊₁ = p − K Δεᵖ_v is
        // the pressure k/η of the apex, and Δε̄ᵖ = (ξ/η) Δεᵖ_v.
        response.branch               = Branch::apex;
        const double plastic_multiple = (eta * p - k) / cone; // Δεᵖ_v/η
        const double p_new            = p - K * eta * plastic_multiple;
        for (unsigned int d = 0; d < 3; ++d)
          response.stress.access_raw_entry(d) = p_new;
        response.state.plastic_strain = strain;
        for (unsigned int d = 0; d < 3; ++d)
          response.state.plastic_strain.access_raw_entry(d) -= p_new / (3 * K);
        response.state.hardening_variable += xi * plastic_multiple;
        fill_tangent(response.tangent, K * (xi * xi * hardening / cone), 0);
        return response;
      }

    // Regular return along N/2 + (η/3) I with N = s/√J₂ (eqs 8.107–8.113); √J₂ > 0 here, because
    // √J₂ = 0 with a positive overstress is the apex.
    response.branch           = Branch::regular;
    const double compliance   = 1 / (G + cone);
    const double multiplier   = overstress * compliance; // Δγ
    const double scaling_back = std::min(1., G * multiplier / root_J2);

    StressTensor N = deviator;
    N /= root_J2;
    response.stress = deviator;
    response.stress *= 1 - scaling_back;
    for (unsigned int d = 0; d < 3; ++d)
      response.stress.access_raw_entry(d) += p - K * eta * multiplier;

    for (unsigned int i = 0; i < 6; ++i)
      response.state.plastic_strain.access_raw_entry(i) +=
        multiplier * (N.access_raw_entry(i) / 2 + (i < 3 ? alpha : 0.));
    response.state.hardening_variable += xi * multiplier;

    fill_tangent(response.tangent,
                 K * ((G + xi * xi * hardening) * compliance),
                 2 * G * (1 - scaling_back),
                 G * (scaling_back - G * compliance),
                 -G * K * eta * compliance,
                 N);
    return response;
  }

  double drucker_prager_alpha(const double friction_angle)
  {
    const double sine = std::sin(friction_angle);
    return 2 * sine / (std::sqrt(3.) * (3 - sine));
  }

  double drucker_prager_strength(const double friction_angle, const double compressive_strength)
  {
    // 1 − √3 α = 3 (1 − sinφ)/(3 − sinφ), with 1 − sinφ = 2 sin²(45° − φ/2) so that no digit is
    // lost towards φ = 90°.
    const double half_angle_sine = std::sin((M_PI / 2 - friction_angle) / 2);
    return compressive_strength * std::sqrt(3.) * 2 * half_angle_sine * half_angle_sine /
           (3 - std::sin(friction_angle));
  }
} // namespace dpcontact::laws
