#ifndef DPCONTACT_SOLVER_LAWS_MOHR_COULOMB_H
#define DPCONTACT_SOLVER_LAWS_MOHR_COULOMB_H

#include "solver/laws/point.h"

#include <cmath>
#include <optional>

namespace dpcontact
{
  struct Material;
}

namespace dpcontact::laws
{
  /// Mohr–Coulomb pyramid with an optional Rankine tension cut-off, perfectly plastic. Tension
  /// positive, σ₁ ≥ σ₂ ≥ σ₃:
  ///   f  = (σ₁ − σ₃)/2 + (σ₁ + σ₃)/2 sinφ − C cosφ ≤ 0, flow from the same with ψ instead of φ,
  ///   fₜ = σ₁ − T₀ ≤ 0, associated.
  /// de Souza Neto, Perić & Owen, Computational Methods for Plasticity (2008), ch. 8.2; returns in
  /// principal space as in Clausen, Damkilde & Andersen, Computers & Structures 85 (2007).
  /// φ = 0 is Tresca. A cut-off at or above the pyramid's apex, T₀ ≥ C cotφ, does nothing.
  /// Stresses and the tangent are in any one unit.
  struct MohrCoulomb
  {
    double                shear_modulus;    ///< G
    double                bulk_modulus;     ///< K
    double                friction_angle;   ///< φ, rad, 0 ≤ φ < π/2
    double                cohesion;         ///< C > 0
    std::optional<double> dilation_angle{}; ///< ψ, rad, 0 ≤ ψ ≤ φ; unset: φ, associated flow
    std::optional<double> tension_cutoff{}; ///< T₀ ≥ 0; unset: no cut-off

    /// The law of a material in a solver's units, as law_of() says.
    static MohrCoulomb of(const Material &material, double stress_unit, double strain_unit);

    /// Whether ψ = φ, which makes the tangent symmetric.
    bool associated() const;

    /// C cosφ, the scale of f
    double strength() const;

    /// Backward-Euler return mapping, a pure function. Where ψ = 0 < φ the pyramid's apex has no
    /// volumetric flow; trial states beyond it return to it all the same, by the limit ψ → 0.
    /// @param strain total, at the end of the step
    Response evaluate(const State &old_state, const StressTensor &strain) const;

    /// max(f, fₜ); the hardening variable is without effect.
    double yield_function(const StressTensor &stress, double hardening_variable) const;
  };
} // namespace dpcontact::laws

#endif
