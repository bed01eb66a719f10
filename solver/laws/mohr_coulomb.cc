#include "solver/laws/mohr_coulomb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

namespace dpcontact::laws
{
  namespace
  {
    using Vector = std::array<double, 3>;

    // 1 − sinφ without loss of digits towards 90°
    double one_minus_sine(const double angle)
    {
      const double half = std::sin((M_PI / 2 - angle) / 2);
      return 2 * half * half;
    }

    // Which principal stresses a set of active planes makes equal. The law is isotropic, so that
    // an edge is a plane for strains averaged over the tied directions; what the average leaves
    // out only divides the flow between the two planes.
    enum class Tie
    {
      none,
      compression,
      extension
    };

    Vector averaged(const Vector &v, const Tie tie)
    {
      if (tie == Tie::compression)
        return {(v[0] + v[1]) / 2, (v[0] + v[1]) / 2, v[2]};
      if (tie == Tie::extension)
        return {v[0], (v[1] + v[2]) / 2, (v[1] + v[2]) / 2};
      return v;
    }

    double dot(const Vector &a, const Vector &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

    // ∂f/∂σ on the sorted sector, averaged
    Vector plane_normal(const double sine, const double one_minus, const Tie tie)
    {
      return averaged({(1 + sine) / 2, 0, -one_minus / 2}, tie);
    }

    struct Constants
    {
      double G, K, E, nu;
      double sin_phi, one_minus_sin_phi, strength;
      double sin_psi, one_minus_sin_psi;
      bool   cut;         // whether the cut-off cuts the pyramid
      double T;           // T₀
      double corner_sig3; // σ₃ where both pyramid and cut-off hold

      double pyramid(const double sigma1, const double sigma3) const
      {
        return (sigma1 - sigma3) / 2 + (sigma1 + sigma3) / 2 * sin_phi - strength;
      }

      // C : v for a principal vector of the given trace
      Vector elastic(const Vector &v, const double trace) const
      {
        Vector result;
        for (unsigned int i = 0; i < 3; ++i)
          result[i] = 2 * G * (v[i] - trace / 3) + K * trace;
        return result;
      }

      // The deviator from differences, so that a large pressure leaves no rounding over 2G in it.
      Vector elastic_strain(const Vector &sigma) const
      {
        const double mean = (sigma[0] + sigma[1] + sigma[2]) / (9 * K);
        const double d01 = sigma[0] - sigma[1], d12 = sigma[1] - sigma[2],
                     d20 = sigma[2] - sigma[0];
        return {
          (d01 - d20) / (6 * G) + mean, (d12 - d01) / (6 * G) + mean, (d20 - d12) / (6 * G) + mean};
      }
    };

    // Trial elastic strains, sorted: deviatoric and total.
    struct Trial
    {
      Vector d, x;
      double volume;
    };

    struct Return
    {
      Branch branch;
      Vector sigma;
      Vector flow;      // Δεᵖ
      double violation; // largest violation of the set's own conditions, as a stress
    };

    double worst(const std::initializer_list<double> violations) { return std::max(violations); }

    // The pyramid's plane σ₁,σ₃ or, with a tie, one of its edges.
    Return to_pyramid(const Constants &c, const Trial &trial, const Tie tie)
    {
      const Vector d  = averaged(trial.d, tie);
      const Vector n  = plane_normal(c.sin_phi, c.one_minus_sin_phi, tie);
      const Vector g  = plane_normal(c.sin_psi, c.one_minus_sin_psi, tie);
      const Vector Cg = c.elastic(g, c.sin_psi);
      const double a  = dot(n, Cg);

      Return r;
      for (unsigned int i = 0; i < 3; ++i)
        r.sigma[i] = 2 * c.G * d[i] + c.K * trial.volume;
      double multiplier = (2 * c.G * dot(n, d) + c.sin_phi * c.K * trial.volume - c.strength) / a;
      for (unsigned int i = 0; i < 3; ++i)
        r.sigma[i] -= multiplier * Cg[i];

      // Once more from there: rounding then is that of the stress, not of the trial stress.
      const double correction = c.pyramid(r.sigma[0], r.sigma[2]) / a;
      for (unsigned int i = 0; i < 3; ++i)
        r.sigma[i] -= correction * Cg[i];
      multiplier += correction;

      for (unsigned int i = 0; i < 3; ++i)
        r.flow[i] = multiplier * g[i];

      // What the average left out goes half to each tied direction; the two planes must supply it.
      const double two_G = 2 * c.G;
      if (tie == Tie::none)
        {
          r.branch    = Branch::regular;
          r.violation = worst({-two_G * multiplier,
                               two_G * (r.flow[0] - (trial.d[0] - trial.d[1])),
                               two_G * (-r.flow[2] - (trial.d[1] - trial.d[2]))});
        }
      else if (tie == Tie::compression)
        {
          const double half = (trial.d[0] - trial.d[1]) / 2;
          r.branch          = Branch::compression_edge;
          r.sigma[1]        = r.sigma[0];
          r.violation       = worst({two_G * (half - r.flow[0]), r.sigma[2] - r.sigma[0]});
          r.flow[0] += half;
          r.flow[1] -= half;
        }
      else
        {
          const double half = (trial.d[1] - trial.d[2]) / 2;
          r.branch          = Branch::extension_edge;
          r.sigma[2]        = r.sigma[1];
          r.violation       = worst({two_G * (half + r.flow[2]), r.sigma[2] - r.sigma[0]});
          r.flow[1] += half;
          r.flow[2] -= half;
        }
      if (c.cut)
        r.violation = std::max(r.violation, r.sigma[0] - c.T);
      return r;
    }

    // Stress given: all that is left is what flow it takes.
    Return at(const Constants &c, const Trial &trial, const Branch branch, const Vector &sigma)
    {
      const Vector elastic = c.elastic_strain(sigma);
      Return       r{branch, sigma, {}, 0};
      for (unsigned int i = 0; i < 3; ++i)
        r.flow[i] = trial.x[i] - elastic[i];
      return r;
    }

    // The flow must lie in the cone of all six planes' flow directions. Its facets nearest to a
    // sorted flow are Δε₁ᵖ + Δε₂ᵖ + N Δε₃ᵖ ≥ 0 and Δε₁ᵖ + N (Δε₂ᵖ + Δε₃ᵖ) ≥ 0 with
    // N = (1 + sinψ)/(1 − sinψ); here times 1 − sinψ. With ψ = 0 both say tr Δεᵖ ≥ 0.
    Return to_apex(const Constants &c, const Trial &trial)
    {
      const double p = c.strength / c.sin_phi;
      Return       r = at(c, trial, Branch::apex, {p, p, p});
      const double q = c.sin_psi, m = c.one_minus_sin_psi;
      const auto  &e = r.flow;
      r.violation =
        2 * c.G *
        worst({-(m * (e[0] + e[1]) + (1 + q) * e[2]), -(m * e[0] + (1 + q) * (e[1] + e[2]))});
      return r;
    }

    // Plane stress: only direction 1 flows.
    Return to_cutoff(const Constants &c, const Trial &trial)
    {
      const double stiffness = c.E / (1 - c.nu * c.nu);
      const double other     = c.nu / (1 - c.nu) * c.T;
      const double sigma2    = other + stiffness * (trial.x[1] + c.nu * trial.x[2]);
      const double sigma3    = other + stiffness * (trial.x[2] + c.nu * trial.x[1]);

      Return r  = at(c, trial, Branch::cutoff, {c.T, sigma2, sigma3});
      r.flow[1] = r.flow[2] = 0;
      r.violation =
        worst({-2 * c.G * r.flow[0], r.sigma[1] - c.T, c.pyramid(r.sigma[0], r.sigma[2])});
      return r;
    }

    // Uniaxial strain of direction 3 under given lateral stresses.
    Return to_cutoff_edge(const Constants &c, const Trial &trial)
    {
      Return r  = at(c, trial, Branch::cutoff_edge, {c.T, c.T, 2 * c.nu * c.T + c.E * trial.x[2]});
      r.flow[2] = 0;
      r.violation =
        worst({-2 * c.G * r.flow[1], r.sigma[2] - c.T, c.pyramid(r.sigma[0], r.sigma[2])});
      return r;
    }

    Return to_cutoff_apex(const Constants &c, const Trial &trial)
    {
      Return r    = at(c, trial, Branch::cutoff_apex, {c.T, c.T, c.T});
      r.violation = -2 * c.G * r.flow[2];
      return r;
    }

    // In the three corners the pyramid flows by Δε₃ᵖ (and Δε₂ᵖ) < 0 and dilates in proportion; the
    // cut-off may add to that dilation, not take from it.
    Return to_corner(const Constants &c, const Trial &trial)
    {
      const double sigma3 = c.corner_sig3;
      Return       r =
        at(c, trial, Branch::corner, {c.T, c.nu * (c.T + sigma3) + c.E * trial.x[1], sigma3});
      r.flow[1]          = 0;
      const double two_G = 2 * c.G;
      r.violation        = worst({two_G * r.flow[2],
                                  -two_G * (c.one_minus_sin_psi * r.flow[0] + (1 + c.sin_psi) * r.flow[2]),
                                  r.sigma[1] - c.T,
                                  sigma3 - r.sigma[1]});
      return r;
    }

    Return to_compression_corner(const Constants &c, const Trial &trial)
    {
      Return       r     = at(c, trial, Branch::compression_corner, {c.T, c.T, c.corner_sig3});
      const auto  &e     = r.flow;
      const double two_G = 2 * c.G;
      r.violation =
        worst({two_G * e[2],
               -two_G * e[1],
               -two_G * (c.one_minus_sin_psi * (e[0] + e[1]) + (1 + c.sin_psi) * e[2])});
      return r;
    }

    Return to_extension_corner(const Constants &c, const Trial &trial)
    {
      Return       r = at(c, trial, Branch::extension_corner, {c.T, c.corner_sig3, c.corner_sig3});
      const auto  &e = r.flow;
      const double two_G = 2 * c.G;
      r.violation        = worst(
        {two_G * e[1], -two_G * (c.one_minus_sin_psi * e[0] + (1 + c.sin_psi) * (e[1] + e[2]))});
      return r;
    }

    // The sets of active planes partition the trial states, with the same stress where two meet:
    // the first set that holds is the answer, and where rounding leaves none, the nearest.
    Return sorted_return(const Constants &c, const Trial &trial)
    {
      Return     best;
      const auto take = [&best](const Return &r) {
        if (r.violation < best.violation)
          best = r;
        return best.violation <= 0;
      };
      best = to_pyramid(c, trial, Tie::none);
      if (best.violation <= 0 || take(to_pyramid(c, trial, Tie::compression)) ||
          take(to_pyramid(c, trial, Tie::extension)))
        return best;
      if (!c.cut)
        {
          // The apex takes volumetric flow. Tested so that it divides by no tiny sinφ.
          if (c.sin_phi * c.K * trial.volume >= c.strength)
            take(to_apex(c, trial));
          return best;
        }
      if (take(to_cutoff(c, trial)) || take(to_cutoff_edge(c, trial)) ||
          take(to_cutoff_apex(c, trial)) || take(to_corner(c, trial)) ||
          take(to_compression_corner(c, trial)))
        return best;
      take(to_extension_corner(c, trial));
      return best;
    }

    bool tied(const Branch branch, const unsigned int i, const unsigned int j)
    {
      switch (branch)
        {
          case Branch::compression_edge:
          case Branch::compression_corner:
          case Branch::cutoff_edge:
            return i == 0 && j == 1;
          case Branch::extension_edge:
          case Branch::extension_corner:
            return i == 1 && j == 2;
          case Branch::apex:
          case Branch::cutoff_apex:
            return true;
          default:
            return false;
        }
    }

    // ∂σᵢ/∂εⱼ of the sorted principal values
    std::array<Vector, 3> principal_tangent(const Constants &c, const Branch branch)
    {
      std::array<Vector, 3> A{};
      const auto            slide = [&](const Tie tie) {
        const Vector n  = plane_normal(c.sin_phi, c.one_minus_sin_phi, tie);
        const Vector g  = plane_normal(c.sin_psi, c.one_minus_sin_psi, tie);
        const Vector Cn = c.elastic(n, c.sin_phi);
        const Vector Cg = c.elastic(g, c.sin_psi);
        const double a  = dot(n, Cg);
        for (unsigned int j = 0; j < 3; ++j)
          {
            Vector unit{};
            unit[j]             = 1;
            const Vector column = c.elastic(averaged(unit, tie), 1);
            for (unsigned int i = 0; i < 3; ++i)
              A[i][j] = column[i] - (Cg[i] * Cn[j]) / a;
          }
      };
      switch (branch)
        {
          case Branch::regular:
            slide(Tie::none);
            break;
          case Branch::compression_edge:
            slide(Tie::compression);
            break;
          case Branch::extension_edge:
            slide(Tie::extension);
            break;
          case Branch::cutoff:
            A[1][1] = A[2][2] = c.E / (1 - c.nu * c.nu);
            A[1][2] = A[2][1] = c.nu * A[1][1];
            break;
          case Branch::cutoff_edge:
            A[2][2] = c.E;
            break;
          case Branch::corner:
            A[1][1] = c.E;
            break;
          default:
            break;
        }
      return A;
    }

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
    Constants c;
    c.G        = shear_modulus;
    c.K        = bulk_modulus;
    c.sin_phi  = std::sin(friction_angle);
    c.strength = strength();
    c.cut      = tension_cutoff && *tension_cutoff * c.sin_phi < c.strength;
    c.T        = c.cut ? *tension_cutoff : 0;

    Response response;
    response.state  = old_state;
    response.branch = Branch::elastic;

    StressTensor elastic_strain = strain;
    elastic_strain -= old_state.plastic_strain;
    Trial trial;
    trial.volume    = dealii::trace(elastic_strain);
    const double p  = c.K * trial.volume;
    response.stress = trial_deviator(elastic_strain, c.G);

    const auto elastic = [&] {
      response.stress = with_pressure(response.stress, p);
      fill_isotropic_tangent(response.tangent, c.K, 2 * c.G);
      return response;
    };

    // Inside the cone that the pyramid encloses (and below a bound of σ₁) no principal stresses are
    // needed: with the Lode angle θ, f = √J₂ (cosθ − sinθ sinφ/√3) + p sinφ − C cosφ.
    const double root_J2 = std::sqrt((response.stress * response.stress) / 2);
    if (root_J2 * std::sqrt(1 + c.sin_phi * c.sin_phi / 3) + p * c.sin_phi <= c.strength &&
        (!c.cut || p + 2 / std::sqrt(3.) * root_J2 <= c.T))
      return elastic();

    const auto eigen =
      dealii::eigenvectors(response.stress, dealii::SymmetricTensorEigenvectorMethod::jacobi);
    const Vector s{eigen[0].first, eigen[1].first, eigen[2].first};
    if ((s[0] - s[2]) / 2 + ((s[0] + s[2]) / 2 + p) * c.sin_phi <= c.strength &&
        (!c.cut || s[0] + p <= c.T))
      return elastic();

    c.one_minus_sin_phi = one_minus_sine(friction_angle);
    c.sin_psi           = c.sin_phi;
    c.one_minus_sin_psi = c.one_minus_sin_phi;
    if (!associated())
      {
        c.sin_psi           = std::sin(*dilation_angle);
        c.one_minus_sin_psi = one_minus_sine(*dilation_angle);
      }
    c.E           = 9 * c.K * c.G / (3 * c.K + c.G);
    c.nu          = (3 * c.K - 2 * c.G) / (2 * (3 * c.K + c.G));
    c.corner_sig3 = c.T - 2 * (c.strength - c.T * c.sin_phi) / c.one_minus_sin_phi;
    for (unsigned int i = 0; i < 3; ++i)
      {
        trial.d[i] = s[i] / (2 * c.G);
        trial.x[i] = trial.d[i] + trial.volume / 3;
      }

    const Return r  = sorted_return(c, trial);
    response.branch = r.branch;

    const auto               &n1 = eigen[0].second, &n2 = eigen[1].second, &n3 = eigen[2].second;
    const std::array<Dyad, 3> normal{
      symmetric_dyad(n1, n1), symmetric_dyad(n2, n2), symmetric_dyad(n3, n3)};
    response.stress = from_principal(r.sigma, normal[0], normal[2]);
    response.state.plastic_strain += from_principal(r.flow, normal[0], normal[2]);

    // D = Σ Aᵢⱼ nᵢnᵢ⊗nⱼnⱼ + Σ 2 θᵢⱼ (nᵢnⱼ)ₛ⊗(nᵢnⱼ)ₛ with the spin terms θᵢⱼ = (σᵢ − σⱼ)/(εᵢ − εⱼ)
    const auto    A = principal_tangent(c, r.branch);
    double *const D = response.tangent.begin_raw();
    for (unsigned int k = 0; k < 6; ++k)
      {
        Vector row; // Aᵀ applied to the dyads' k-th entries
        for (unsigned int j = 0; j < 3; ++j)
          row[j] = A[0][j] * normal[0][k] + A[1][j] * normal[1][k] + A[2][j] * normal[2][k];
        for (unsigned int l = 0; l < 6; ++l)
          D[6 * k + l] = row[0] * normal[0][l] + row[1] * normal[1][l] + row[2] * normal[2][l];
      }
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = i + 1; j < 3; ++j)
        {
          if (tied(r.branch, i, j))
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
    // Rounding aside symmetric already where A is.
    if (A[0][1] == A[1][0] && A[0][2] == A[2][0] && A[1][2] == A[2][1])
      for (unsigned int k = 0; k < 6; ++k)
        for (unsigned int l = 0; l < k; ++l)
          D[6 * k + l] = D[6 * l + k];
    return response;
  }
} // namespace dpcontact::laws
