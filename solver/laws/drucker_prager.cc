#include "solver/laws/drucker_prager.h"

#include "solver/laws/material.h"
#include "solver/laws/strengths.h"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>

namespace dpcontact::laws
{
  namespace
  {
    // Adds (flow) N⊗N + (by_volume) N⊗I + (of_pressure) I⊗N to D, whose 6×6 storage holds plain
    // components.
    void add_flow_tangent(Tangent            &tangent,
                          const double        flow,
                          const double        by_volume,
                          const double        of_pressure,
                          const StressTensor &N)
    {
      double *const D = tangent.begin_raw();
      double        n[6];
      for (unsigned int i = 0; i < 6; ++i)
        n[i] = N.access_raw_entry(i);
      for (unsigned int i = 0; i < 6; ++i)
        for (unsigned int j = 0; j < 6; ++j)
          D[6 * i + j] += flow * (n[i] * n[j]);
      for (unsigned int i = 0; i < 6; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          {
            D[6 * i + j] += by_volume * n[i];
            D[6 * j + i] += of_pressure * n[i];
          }
    }

    double root_J2(const StressTensor &deviator) { return std::sqrt((deviator * deviator) / 2); }

    double J3(const StressTensor &s)
    {
      return s[0][0] * (s[1][1] * s[2][2] - s[1][2] * s[1][2]) -
             s[0][1] * (s[0][1] * s[2][2] - s[1][2] * s[0][2]) +
             s[0][2] * (s[0][1] * s[1][2] - s[1][1] * s[0][2]);
    }

    // M = ∂J₃/∂s = dev s²
    StressTensor gradient_of_J3(const StressTensor &s)
    {
      StressTensor M;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = i; j < 3; ++j)
          for (unsigned int k = 0; k < 3; ++k)
            M[i][j] += s[i][k] * s[k][j];
      return dealii::deviator(M);
    }

    // The section √J₂ h(θ) of the cone, by the Lode angle θ in [0, 60°]: 0 is triaxial extension,
    // 60° compression. As h depends on cos 3θ it is smooth across both.
    struct Section
    {
      double ratio; // 1/K − 1

      double h(const double theta) const { return 1 + ratio * (1 + std::cos(3 * theta)) / 2; }
      double slope(const double theta) const { return -1.5 * ratio * std::sin(3 * theta); }

      // √J₂ h = (1 + ratio/2) √J₂ + b J₃/J₂
      double b() const { return 0.75 * std::sqrt(3.) * ratio; }
      double value(const StressTensor &s) const
      {
        const double J2 = (s * s) / 2;
        return J2 > 0 ? (1 + ratio / 2) * std::sqrt(J2) + b() * (J3(s) / J2) : 0.;
      }
    };

    // A deviator in polar coordinates of its deviatoric plane: s = |s| radial; `hoop` is the unit
    // vector along increasing Lode angle. On a triaxial meridian (θ = 0, 60°) there is none; near
    // one it is as uncertain as sin 3θ is small, and with it the angle left to the meridian.
    struct PolarAxes
    {
      StressTensor radial, hoop;
      double       angle;

      PolarAxes(const StressTensor &s, const double root_J2)
        : radial(s / (root_J2 * std::sqrt(2.)))
      {
        // cos 3θ = 3√6 J₃ and ∂J₃/∂θ = −sin 3θ/√6 at |s| = 1
        const StressTensor M = gradient_of_J3(radial);
        hoop                 = (radial * M) * radial - M;
        const double length  = hoop.norm();
        angle = std::atan2(std::sqrt(6.) * length, 3 * std::sqrt(6.) * J3(radial)) / 3;
        if (length > 0)
          hoop /= length;
      }
    };

    // Zero of a function that is ≥ 0 at `low` and ≤ 0 at `high`, to the last digit.
    template <class Function>
    double zero(const Function &function, const double low, const double high)
    {
      const double at_low = function(low), at_high = function(high);
      if (at_low <= 0)
        return low;
      if (at_high >= 0)
        return high;
      std::uintmax_t iterations = 100;
      const auto     bracket    = boost::math::tools::toms748_solve(
        function,
        low,
        high,
        at_low,
        at_high,
        boost::math::tools::eps_tolerance<double>(std::numeric_limits<double>::digits),
        iterations);
      return (bracket.first + bracket.second) / 2;
    }
  } // namespace

  double DruckerPrager::yield_function(const StressTensor &stress,
                                       const double        hardening_variable) const
  {
    const StressTensor s = dealii::deviator(stress);
    return Section{1 / flow_stress_ratio - 1}.value(s) + alpha * dealii::trace(stress) -
           (strength + xi * hardening * hardening_variable);
  }

  Response DruckerPrager::evaluate(const State &old_state, const StressTensor &strain) const
  {
    StressTensor elastic_strain = strain;
    elastic_strain -= old_state.plastic_strain;
    const double       p        = bulk_modulus * dealii::trace(elastic_strain);
    const StressTensor deviator = trial_deviator(elastic_strain, shear_modulus);
    const double       k        = strength + xi * hardening * old_state.hardening_variable;

    const bool   circular = flow_stress_ratio == 1;
    const double section =
      circular ? root_J2(deviator) : Section{1 / flow_stress_ratio - 1}.value(deviator);
    if (section + 3 * alpha * p - k <= 0)
      {
        Response response;
        response.state  = old_state;
        response.branch = Branch::elastic;
        response.stress = with_pressure(deviator, p);
        fill_isotropic_tangent(response.tangent, bulk_modulus, 2 * shear_modulus);
        return response;
      }
    return circular ? return_to_circular_cone(old_state, strain, deviator, p)
                    : return_to_rounded_cone(old_state, strain, deviator, p);
  }

  Response DruckerPrager::return_to_apex(const State        &old_state,
                                         const StressTensor &strain,
                                         const double        multiplier_of_deviator,
                                         const double        p) const
  {
    // de Souza Neto et al. eqs 8.119–8.120, solved for linear hardening: pₙ₊₁ = p − K η̄ Δγ is the
    // pressure k/η of the apex. Without hardening the apex stays where it is, whatever η̄.
    const double K = bulk_modulus, eta = 3 * alpha, flow_eta = 3 * flow_alpha.value_or(alpha);
    const double k          = strength + xi * hardening * old_state.hardening_variable;
    const double overstress = eta * p - k;
    const double cone       = K * eta * flow_eta + xi * xi * hardening;
    const double hardens    = cone > 0 ? xi * xi * hardening / cone : 0.;
    const double p_new      = p - (1 - hardens) * overstress / eta;
    Response     response;
    response.branch               = Branch::apex;
    response.stress               = with_pressure({}, p_new);
    response.state.plastic_strain = with_pressure(strain, -p_new / (3 * K));
    response.state.hardening_variable =
      old_state.hardening_variable + xi * (cone > 0 ? overstress / cone : multiplier_of_deviator);
    fill_isotropic_tangent(response.tangent, K * hardens, 0);
    return response;
  }

  Response DruckerPrager::return_to_circular_cone(const State        &old_state,
                                                  const StressTensor &strain,
                                                  const StressTensor &deviator,
                                                  const double        p) const
  {
    const double G = shear_modulus, K = bulk_modulus;
    const double eta = 3 * alpha, flow_eta = 3 * flow_alpha.value_or(alpha);
    const double root = root_J2(deviator);
    const double k    = strength + xi * hardening * old_state.hardening_variable;
    const double cone = K * eta * flow_eta + xi * xi * hardening;

    // The regular return would turn the deviator round where G Δγ > √J₂, that is (without a
    // division that fails as α → 0) where √J₂ (Kηη̄ + ξ²H) < G (ηp − k). Never with α = 0, as then k
    // > 0.
    if (root * cone < G * (eta * p - k))
      return return_to_apex(old_state, strain, root / G, p);

    // Along N/2 + (η̄/3) I with N = s/√J₂ (eqs 8.107–8.113); √J₂ > 0 here, because √J₂ = 0 with a
    // positive overstress is the apex.
    Response response;
    response.branch           = Branch::regular;
    const double compliance   = 1 / (G + cone);
    const double multiplier   = (root + eta * p - k) * compliance; // Δγ
    const double scaling_back = std::min(1., G * multiplier / root);

    StressTensor N = deviator;
    N /= root;
    response.stress = with_pressure(deviator * (1 - scaling_back), p - K * flow_eta * multiplier);
    response.state  = old_state;
    for (unsigned int i = 0; i < 6; ++i)
      response.state.plastic_strain.access_raw_entry(i) +=
        multiplier * (N.access_raw_entry(i) / 2 + (i < 3 ? flow_eta / 3 : 0.));
    response.state.hardening_variable += xi * multiplier;

    fill_isotropic_tangent(
      response.tangent, K * ((G + xi * xi * hardening) * compliance), 2 * G * (1 - scaling_back));
    add_flow_tangent(response.tangent,
                     G * (scaling_back - G * compliance),
                     -G * K * eta * compliance,
                     -G * K * flow_eta * compliance,
                     N);
    return response;
  }

  Response DruckerPrager::return_to_rounded_cone(const State        &old_state,
                                                 const StressTensor &strain,
                                                 const StressTensor &deviator,
                                                 const double        p) const
  {
    const double  G = shear_modulus, K = bulk_modulus;
    const double  eta = 3 * alpha, flow_eta = 3 * flow_alpha.value_or(alpha);
    const double  k      = strength + xi * hardening * old_state.hardening_variable;
    const double  cone   = K * eta * flow_eta + xi * xi * hardening;
    const double  excess = eta * p - k;
    const double  root   = root_J2(deviator);
    const Section section{1 / flow_stress_ratio - 1};
    if (root == 0)
      return return_to_apex(old_state, strain, 0, p);

    // In the deviatoric plane, in polar coordinates (R = √J₂, θ), the return is
    //   R' cos(θ' − θ) = R + G Δγ h(θ),  R' sin(θ' − θ) = G Δγ dh/dθ,  R h = (Kηη̄ + ξ²H) Δγ − (ηp −
    //   k)
    // from the trial point (R', θ'), leaving one equation in θ. As dh/dθ ≤ 0, θ' ≤ θ ≤ 60°.
    const PolarAxes axes(deviator, root);
    const double    trial_angle = axes.angle, last_angle = M_PI / 3;

    // What would take the deviator to nothing (R = 0). If the pressure is still too large, the
    // apex.
    if (excess > 0)
      {
        const double theta = zero(
          [&](const double t) {
            return root * (std::sin(trial_angle - t) * section.h(t) -
                           std::cos(trial_angle - t) * section.slope(t));
          },
          trial_angle,
          last_angle);
        const double multiplier = root * std::cos(trial_angle - theta) / (G * section.h(theta));
        if (cone * multiplier < excess)
          return return_to_apex(old_state, strain, multiplier, p);
      }

    const auto multiplier_at = [&](const double t) {
      const double h = section.h(t);
      return (root * h * std::cos(trial_angle - t) + excess) / (G * h * h + cone);
    };
    const double theta = zero(
      [&](const double t) {
        return root * std::sin(trial_angle - t) - G * multiplier_at(t) * section.slope(t);
      },
      trial_angle,
      last_angle);
    const double multiplier = multiplier_at(theta); // Δγ
    const double R          = (cone * multiplier - excess) / section.h(theta);
    if (!(R > 0))
      return return_to_apex(old_state, strain, multiplier, p);

    StressTensor s =
      std::cos(theta - trial_angle) * axes.radial + std::sin(theta - trial_angle) * axes.hoop;
    s *= R * std::sqrt(2.);

    Response response;
    response.branch = Branch::regular;
    response.stress = with_pressure(s, p - K * flow_eta * multiplier);
    response.state  = old_state;
    response.state.plastic_strain +=
      with_pressure((deviator - s) / (2 * G), flow_eta * multiplier / 3);
    response.state.hardening_variable += xi * multiplier;
    fill_rounded_tangent(response, s, R, multiplier);
    return response;
  }

  void DruckerPrager::fill_rounded_tangent(Response           &response,
                                           const StressTensor &s,
                                           const double        R,
                                           const double        multiplier) const
  {
    // Ξ = (C⁻¹ + Δγ ∂²g/∂σ²)⁻¹,  D = Ξ − (Ξ n_g)⊗(Ξ n_f)/(n_f:Ξ n_g + ξ²H).
    const double  G = shear_modulus, K = bulk_modulus;
    const Section section{1 / flow_stress_ratio - 1};
    const double  a = 1 + section.ratio / 2, b = section.b();

    // Gradient and curvature of √J₂ h = a √J₂ + b J₃/J₂ at s = R x, where x has √J₂ = 1 and the
    // curvature goes with 1/R. Along x and I there is no curvature: Ξ is 2G and 3K there, and what
    // is inverted for the rest, R C⁻¹ + Δγ R ∂²g, gets a number of its size instead, so that R may
    // be as small as it likes.
    StressTensor x = s;
    x /= R;
    const StressTensor M        = gradient_of_J3(x);
    const double       third    = J3(x);
    const StressTensor gradient = (a / 2 - b * third) * x + b * M;

    Tangent      rest, along_x, along_unit;
    const double size         = R / (2 * G) + multiplier;
    const double on_deviators = R / (2 * G) + multiplier * (a / 2 - b * third);
    const auto   unit         = dealii::unit_symmetric_tensor<3>();
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = i; j < 3; ++j)
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int l = k; l < 3; ++l)
            {
              const double identity  = (unit[i][k] * unit[j][l] + unit[i][l] * unit[j][k]) / 2;
              const double by_square = (unit[i][k] * x[j][l] + unit[i][l] * x[j][k] +
                                        unit[j][k] * x[i][l] + unit[j][l] * x[i][k]) /
                                         2 -
                                       2. / 3 * (unit[i][j] * x[k][l] + x[i][j] * unit[k][l]);
              along_x[i][j][k][l]    = x[i][j] * x[k][l] / 2; // x:x = 2
              along_unit[i][j][k][l] = unit[i][j] * unit[k][l] / 3;
              rest[i][j][k][l] =
                on_deviators * (identity - along_unit[i][j][k][l]) +
                multiplier * ((2 * b * third - a / 4) * x[i][j] * x[k][l] +
                              b * (by_square - M[i][j] * x[k][l] - x[i][j] * M[k][l])) +
                (size - R / (2 * G)) * along_x[i][j][k][l] + size * along_unit[i][j][k][l];
            }
    const Tangent Xi =
      R * dealii::invert(rest) + (2 * G - R / size) * along_x + (3 * K - R / size) * along_unit;
    const StressTensor Xi_f   = Xi * with_pressure(gradient, alpha);
    const StressTensor Xi_g   = Xi * with_pressure(gradient, flow_alpha.value_or(alpha));
    const double       resist = with_pressure(gradient, alpha) * Xi_g + xi * xi * hardening;
    response.tangent          = Xi - dealii::outer_product(Xi_g, Xi_f) * (1 / resist);
    if (associated()) // symmetric but for the roundings of the inversion
      {
        double *const D = response.tangent.begin_raw();
        for (unsigned int i = 0; i < 6; ++i)
          for (unsigned int j = 0; j < i; ++j)
            D[6 * i + j] = D[6 * j + i] = (D[6 * i + j] + D[6 * j + i]) / 2;
      }
  }

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
} // namespace dpcontact::laws
