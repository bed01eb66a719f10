#ifndef DPCONTACT_SOLVER_LAWS_DRUCKER_PRAGER_H
#define DPCONTACT_SOLVER_LAWS_DRUCKER_PRAGER_H

#include <deal.II/base/symmetric_tensor.h>

namespace dpcontact::laws
{
  using StressTensor = dealii::SymmetricTensor<2, 3>;
  using Tangent      = dealii::SymmetricTensor<4, 3>;

  /// Drucker–Prager cone √J₂ + α I₁ ≤ k(ε̄ᵖ), tension positive, associated flow, linear isotropic
  /// hardening of the cohesion: k = k₀ + H' ε̄ᵖ with Δε̄ᵖ = ξ Δγ and k = ξ c, so that H' = ξ H in the
  /// notation of de Souza Neto, Perić & Owen, Computational Methods for Plasticity (2008), ch. 8.3.
  /// α = 0 is von Mises. Stresses in any one unit; the tangent is in that unit too.
  struct DruckerPrager
  {
    double shear_modulus; ///< G
    double bulk_modulus;  ///< K
    double alpha;         ///< α = η/3
    double strength;      ///< k₀ = ξ c₀
    double xi        = 1; ///< ξ
    double hardening = 0; ///< H = dc/dε̄ᵖ ≥ 0

    /// Which part of the yield surface the stress was returned to.
    enum class Branch { elastic, regular, apex };

    /// What a material point remembers.
    struct State
    {
      StressTensor plastic_strain;            ///< εᵖ
      double       hardening_variable  = 0;   ///< ε̄ᵖ
    };

    struct Response
    {
      StressTensor stress;
      Tangent      tangent; ///< consistent: dσₙ₊₁/dεₙ₊₁
      State        state;
      Branch       branch;
    };

    /// Backward-Euler return mapping. A pure function.
    Response evaluate(const State &old_state, const StressTensor &strain) const;

    /// f(σ, ε̄ᵖ) = √J₂ + α I₁ − k(ε̄ᵖ)
    double yield_function(const StressTensor &stress, double hardening_variable) const;
  };

  /// α and k of the paper from friction angle and uniaxial compressive strength (model section 2):
  /// α = 2 sinφ/(√3(3 − sinφ)), k = σc(1 − √3 α)/√3. φ in rad.
  double drucker_prager_alpha(double friction_angle);
  double drucker_prager_strength(double friction_angle, double compressive_strength);
} // namespace dpcontact::laws

#endif
