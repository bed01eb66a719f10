#include "solver/laws/mohr_coulomb.h"

#include "solver/laws/material.h"
#include "solver/laws/mohr_coulomb_returns.h"
#include "solver/laws/strengths.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dpcontact::laws
{
  using principal::Constants;
  using principal::Return;
  using principal::Trial;
  using principal::Vector;

  namespace
  {
    // Raw entries of the symmetric part of a⊗b: 11, 22, 33, 12, 13, 23
    using Dyad = std::array<double, 6>;
    template <typename Direction>
    Dyad symmetric_dyad(const Direction &a, const Direction &b)
    {
      return {a[0] * b[0],
              a[1] * b[1],
              a[2] * b[2],
              (a[0] * b[1] + a[1] * b[0]) / 2,
              (a[0] * b[2] + a[2] * b[0]) / 2,
              (a[1] * b[2] + a[2] * b[1]) / 2};
    }

    // v₂ I + (v₁ − v₂) n₁⊗n₁ + (v₃ − v₂) n₃⊗n₃: equal values stay equal in every frame.
    StressTensor from_principal(const Vector &v, const Dyad &first, const Dyad &third)
    {
      StressTensor t;
      for (unsigned int i = 0; i < 6; ++i)
        t.access_raw_entry(i) =
          (i < 3 ? v[1] : 0.) + (v[0] - v[1]) * first[i] + (v[2] - v[1]) * third[i];
      return t;
    }

    using Eigen = std::array<std::pair<double, dealii::Tensor<1, 3>>, 3>;

    // What the test for yielding needs.
    Constants yield_constants(const MohrCoulomb &law)
    {
      Constants c{};
      c.G        = law.shear_modulus;
      c.K        = law.bulk_modulus;
      c.sin_phi  = std::sin(law.friction_angle);
      c.strength = law.strength();
      c.cut      = law.tension_cutoff && *law.tension_cutoff * c.sin_phi < c.strength;
      c.T        = c.cut ? *law.tension_cutoff : 0;
      return c;
    }

    // What the return needs besides.
    void add_return_constants(const MohrCoulomb &law, Constants &c)
    {
      c.one_minus_sin_phi = principal::one_minus_sine(law.friction_angle);
      c.sin_psi           = c.sin_phi;
      c.one_minus_sin_psi = c.one_minus_sin_phi;
      if (!law.associated())
        {
          c.sin_psi           = std::sin(*law.dilation_angle);
          c.one_minus_sin_psi = principal::one_minus_sine(*law.dilation_angle);
        }
      c.E           = 9 * c.K * c.G / (3 * c.K + c.G);
      c.nu          = (3 * c.K - 2 * c.G) / (2 * (3 * c.K + c.G));
      c.corner_sig3 = c.T - 2 * (c.strength - c.T * c.sin_phi) / c.one_minus_sin_phi;
    }

    // Whether the stress lies inside the cone that the pyramid encloses, and below a bound of σ₁:
    // then no principal stresses are needed. With the Lode angle θ,
    // f = √J₂ (cosθ − sinθ sinφ/√3) + p sinφ − C cosφ.
    bool inside_enclosed_cone(const Constants &c, const StressTensor &deviator, const double p)
    {
      const double root_J2 = std::sqrt((deviator * deviator) / 2);
      return root_J2 * std::sqrt(1 + c.sin_phi * c.sin_phi / 3) + p * c.sin_phi <= c.strength &&
             (!c.cut || p + 2 / std::sqrt(3.) * root_J2 <= c.T);
    }

    // By the principal values s of the deviator.
    bool inside_pyramid(const Constants &c, const Vector &s, const double p)
    {
      return (s[0] - s[2]) / 2 + ((s[0] + s[2]) / 2 + p) * c.sin_phi <= c.strength &&
             (!c.cut || s[0] + p <= c.T);
    }

    // D = Σ Aᵢⱼ nᵢnᵢ⊗nⱼnⱼ, and whether it is symmetric, rounding aside, because A is.
    bool fill_principal_part(const std::array<Vector, 3> &A,
                             const std::array<Dyad, 3>   &normal,
                             double *const                D)
    {
      for (unsigned int k = 0; k < 6; ++k)
        {
          Vector row; // Aᵀ applied to the dyads' k-th entries
          for (unsigned int j = 0; j < 3; ++j)
            row[j] = A[0][j] * normal[0][k] + A[1][j] * normal[1][k] + A[2][j] * normal[2][k];
          for (unsigned int l = 0; l < 6; ++l)
            D[6 * k + l] = row[0] * normal[0][l] + row[1] * normal[1][l] + row[2] * normal[2][l];
        }
      return A[0][1] == A[1][0] && A[0][2] == A[2][0] && A[1][2] == A[2][1];
    }

    // D += Σ 2 θᵢⱼ (nᵢnⱼ)ₛ⊗(nᵢnⱼ)ₛ with the spin terms θᵢⱼ = (σᵢ − σⱼ)/(εᵢ − εⱼ)
    void add_spin_part(const Constants &c,
                       const Trial     &trial,
                       const Return    &r,
                       const Eigen     &eigen,
                       double *const    D)
    {
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = i + 1; j < 3; ++j)
          {
            if (principal::tied(r.branch, i, j))
              continue;
            // Δσ = 2G (Δε − Δεᵖ), whose digits survive where the two strains nearly agree.
            const double strains = trial.d[i] - trial.d[j];
            const double flows   = r.flow[i] - r.flow[j];
            const double theta   = flows <= 0         ? 2 * c.G
                                   : flows >= strains ? 0.
                                                      : 2 * c.G * (1 - flows / strains);
            const Dyad   shear   = symmetric_dyad(eigen[i].second, eigen[j].second);
            for (unsigned int k = 0; k < 6; ++k)
              for (unsigned int l = 0; l < 6; ++l)
                D[6 * k + l] += 2 * theta * (shear[k] * shear[l]);
          }
    }
  } // namespace

  bool MohrCoulomb::associated() const
  {
    return !dilation_angle || *dilation_angle == friction_angle;
  }

  double MohrCoulomb::strength() const { return cohesion * std::cos(friction_angle); }

  double MohrCoulomb::yield_function(const StressTensor &stress, double) const
  {
    // The pressure apart, so that it takes no digits from the differences of principal stresses.
    const double mean     = dealii::trace(stress) / 3;
    StressTensor deviator = stress;
    for (unsigned int d = 0; d < 3; ++d)
      deviator.access_raw_entry(d) -= mean;
    const auto eigen =
      dealii::eigenvectors(deviator, dealii::SymmetricTensorEigenvectorMethod::jacobi);
    const double s1 = eigen[0].first, s3 = eigen[2].first;
    const double pyramid =
      (s1 - s3) / 2 + ((s1 + s3) / 2 + mean) * std::sin(friction_angle) - strength();
    return tension_cutoff ? std::max(pyramid, s1 + mean - *tension_cutoff) : pyramid;
  }

  Response MohrCoulomb::evaluate(const State &old_state, const StressTensor &strain) const
  {
    Constants    c              = yield_constants(*this);
    StressTensor elastic_strain = strain;
    elastic_strain -= old_state.plastic_strain;
    Trial trial;
    trial.volume                = dealii::trace(elastic_strain);
    const double       p        = c.K * trial.volume;
    const StressTensor deviator = trial_deviator(elastic_strain, c.G);

    Response response;
    response.state     = old_state;
    const auto elastic = [&] {
      response.branch = Branch::elastic;
      response.stress = with_pressure(deviator, p);
      fill_isotropic_tangent(response.tangent, c.K, 2 * c.G);
      return response;
    };
    if (inside_enclosed_cone(c, deviator, p))
      return elastic();
    const Eigen eigen =
      dealii::eigenvectors(deviator, dealii::SymmetricTensorEigenvectorMethod::jacobi);
    const Vector s{eigen[0].first, eigen[1].first, eigen[2].first};
    if (inside_pyramid(c, s, p))
      return elastic();

    add_return_constants(*this, c);
    for (unsigned int i = 0; i < 3; ++i)
      {
        trial.d[i] = s[i] / (2 * c.G);
        trial.x[i] = trial.d[i] + trial.volume / 3;
      }
    const Return r  = principal::sorted_return(c, trial);
    response.branch = r.branch;

    const auto               &n1 = eigen[0].second, &n2 = eigen[1].second, &n3 = eigen[2].second;
    const std::array<Dyad, 3> normal{
      symmetric_dyad(n1, n1), symmetric_dyad(n2, n2), symmetric_dyad(n3, n3)};
    response.stress = from_principal(r.sigma, normal[0], normal[2]);
    response.state.plastic_strain += from_principal(r.flow, normal[0], normal[2]);

    double *const D = response.tangent.begin_raw();
    const bool    symmetric =
      fill_principal_part(principal::principal_tangent(c, r.branch), normal, D);
    add_spin_part(c, trial, r, eigen, D);
    if (symmetric)
      for (unsigned int k = 0; k < 6; ++k)
        for (unsigned int l = 0; l < k; ++l)
          D[6 * k + l] = D[6 * l + k];
    return response;
  }

  MohrCoulomb
  MohrCoulomb::of(const Material &material, const double stress_unit, const double strain_unit)
  {
    const double phi     = material.friction_angle.radians();
    const double sigma_c = material.compressive_strength / stress_unit;
    MohrCoulomb  law{material.shear_modulus(stress_unit, strain_unit),
                    material.bulk_modulus(stress_unit, strain_unit),
                    phi,
                    mohr_coulomb_cohesion(phi, sigma_c)};
    if (material.dilation_angle)
      law.dilation_angle = material.dilation_angle->radians();
    if (material.tension_cutoff)
      law.tension_cutoff = *material.tension_cutoff / stress_unit;
    return law;
  }
} // namespace dpcontact::laws
