#ifndef DPCONTACT_SOLVER_LAWS_VON_MISES_H
#define DPCONTACT_SOLVER_LAWS_VON_MISES_H

#include "solver/laws/point.h"

namespace dpcontact
{
  struct Material;
}

namespace dpcontact::laws
{
  /// Von Mises cylinder √(3 J₂) ≤ σ_Y(ε̄ᵖ), associated flow, linear isotropic hardening
  /// σ_Y = σ_Y0 + H ε̄ᵖ with the accumulated plastic strain Δε̄ᵖ = √(2/3) |Δεᵖ|. Stresses and
  /// the tangent are in any one unit.
  struct VonMises
  {
    double shear_modulus; ///< G
    double bulk_modulus;  ///< K
    double yield_stress;  ///< σ_Y0, uniaxial
    double hardening = 0; ///< H = dσ_Y/dε̄ᵖ ≥ 0

    /// The law of a material in a solver's units, as law_of() says.
    static VonMises of(const Material &material, double stress_unit, double strain_unit);

    /// Flow is always associated.
    bool associated() const { return true; }

    /// Radial return (Wilkins; Simo & Hughes, Computational Inelasticity (1998), box 3.1), a pure
    /// function.
    /// @param strain total, at the end of the step
    Response evaluate(const State &old_state, const StressTensor &strain) const;

    /// f(σ, ε̄ᵖ) = √(3 J₂) − σ_Y(ε̄ᵖ)
    double yield_function(const StressTensor &stress, double hardening_variable) const;
  };
} // namespace dpcontact::laws

#endif
