#include "solver/laws/mohr_coulomb_returns.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace dpcontact::laws::principal
{
  namespace
  {
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

    double worst(const std::initializer_list<double> violations) { return std::max(violations); }

    // What the average left out goes half to each tied direction; the two planes must supply it.
    // Enters branch and violation, and completes the flow of the averaged strains.
    void divide_between_planes(const Constants &c,
                               const Trial     &trial,
                               const Tie        tie,
                               const double     multiplier,
                               Return          &r)
    {
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
    }

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

      divide_between_planes(c, trial, tie, multiplier, r);
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

    // Of the pyramid's plane σ₁,σ₃ or, with a tie, one of its edges.
    std::array<Vector, 3> pyramid_tangent(const Constants &c, const Tie tie)
    {
      std::array<Vector, 3> A{};
      const Vector          n  = plane_normal(c.sin_phi, c.one_minus_sin_phi, tie);
      const Vector          g  = plane_normal(c.sin_psi, c.one_minus_sin_psi, tie);
      const Vector          Cn = c.elastic(n, c.sin_phi);
      const Vector          Cg = c.elastic(g, c.sin_psi);
      const double          a  = dot(n, Cg);
      for (unsigned int j = 0; j < 3; ++j)
        {
          Vector unit{};
          unit[j]             = 1;
          const Vector column = c.elastic(averaged(unit, tie), 1);
          for (unsigned int i = 0; i < 3; ++i)
            A[i][j] = column[i] - (Cg[i] * Cn[j]) / a;
        }
      return A;
    }
  } // namespace

  double one_minus_sine(const double angle)
  {
    const double half = std::sin((M_PI / 2 - angle) / 2);
    return 2 * half * half;
  }

  Vector Constants::elastic(const Vector &v, const double trace) const
  {
    Vector result;
    for (unsigned int i = 0; i < 3; ++i)
      result[i] = 2 * G * (v[i] - trace / 3) + K * trace;
    return result;
  }

  Vector Constants::elastic_strain(const Vector &sigma) const
  {
    const double mean = (sigma[0] + sigma[1] + sigma[2]) / (9 * K);
    const double d01 = sigma[0] - sigma[1], d12 = sigma[1] - sigma[2], d20 = sigma[2] - sigma[0];
    return {
      (d01 - d20) / (6 * G) + mean, (d12 - d01) / (6 * G) + mean, (d20 - d12) / (6 * G) + mean};
  }

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

  std::array<Vector, 3> principal_tangent(const Constants &c, const Branch branch)
  {
    std::array<Vector, 3> A{};
    switch (branch)
      {
        case Branch::regular:
          return pyramid_tangent(c, Tie::none);
        case Branch::compression_edge:
          return pyramid_tangent(c, Tie::compression);
        case Branch::extension_edge:
          return pyramid_tangent(c, Tie::extension);
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
} // namespace dpcontact::laws::principal
