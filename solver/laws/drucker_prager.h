#ifndef DPCONTACT_SOLVER_LAWS_DRUCKER_PRAGER_H
#define DPCONTACT_SOLVER_LAWS_DRUCKER_PRAGER_H

#include "solver/laws/point.h"

#include <optional>

namespace dpcontact
{
  struct Material;
}

namespace dpcontact::laws
{
  /// Drucker–Prager cone √J₂ h(θ) + α I₁ ≤ k(ε̄ᵖ), tension positive.
  ///
  /// - Flow stress ratio K, 0.778 ≤ K ≤ 1: h = ½ [1 + 1/K − (1 − 1/K) cos 3θ] with
  ///   cos 3θ = (r/q)³ = (3√3/2) J₃/J₂^{3/2}, so that √3 √J₂ h is t of Abaqus' linear
  ///   Drucker–Prager model (Abaqus Theory Guide 4.4.2). h = 1 in triaxial compression whatever K
  ///   is; K = 1 is the circular cone.
  /// - Flow: Δεᵖ = Δγ ∂g/∂σ with g = √J₂ h(θ) + ᾱ I₁; associated where ᾱ = α.
  /// - Linear isotropic hardening of the cohesion: k = ξ c(ε̄ᵖ), c = c₀ + H ε̄ᵖ, Δε̄ᵖ = ξ Δγ, in the
  ///   notation of de Souza Neto, Perić & Owen, Computational Methods for Plasticity (2008),
  ///   ch. 8.3. With ξ = (1 − √3 α)/√3 c is the uniaxial compressive strength and, for associated
  ///   flow, ε̄ᵖ its work conjugate.
  ///
  /// At the apex the flow is what the return to it needs. This holds with ᾱ = 0 too, where the
  /// potential has no volumetric flow and no other return exists. α = 0 is von Mises. Stresses and
  /// the tangent are in any one unit.
  struct DruckerPrager
  {
    double                shear_modulus;         ///< G
    double                bulk_modulus;          ///< volumetric stiffness dp/dε_v
    double                alpha;                 ///< α = η/3
    double                strength;              ///< k₀ = ξ c₀
    double                xi        = 1;         ///< ξ
    double                hardening = 0;         ///< H = dc/dε̄ᵖ ≥ 0
    std::optional<double> flow_alpha{};          ///< ᾱ = η̄/3; unset: associated
    double                flow_stress_ratio = 1; ///< K

    /// The law of a material in a solver's units, as law_of() says.
    static DruckerPrager of(const Material &material, double stress_unit, double strain_unit);

    bool associated() const { return !flow_alpha || *flow_alpha == alpha; }

    /// Backward-Euler return mapping, a pure function.
    /// @param strain total, at the end of the step
    Response evaluate(const State &old_state, const StressTensor &strain) const;

    /// f(σ, ε̄ᵖ) = √J₂ h + α I₁ − k(ε̄ᵖ)
    double yield_function(const StressTensor &stress, double hardening_variable) const;

  private:
    // Returns of a trial state that lies outside the cone.
    Response return_to_circular_cone(const State        &old_state,
                                     const StressTensor &strain,
                                     const StressTensor &trial_deviator,
                                     double              trial_pressure) const;
    Response return_to_rounded_cone(const State        &old_state,
                                    const StressTensor &strain,
                                    const StressTensor &trial_deviator,
                                    double              trial_pressure) const;
    Response return_to_apex(const State        &old_state,
                            const StressTensor &strain,
                            double              multiplier_of_deviator,
                            double              trial_pressure) const;
    void     fill_rounded_tangent(Response           &response,
                                  const StressTensor &deviator,
                                  double              root_J2,
                                  double              multiplier) const;
  };
} // namespace dpcontact::laws

#endif
