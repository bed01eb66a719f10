#ifndef DPCONTACT_SOLVER_SYSTEM_STEP_INTEGRALS_H
#define DPCONTACT_SOLVER_SYSTEM_STEP_INTEGRALS_H

namespace dpcontact
{
  /// Integrals over the bodies at the end of a load step, in the system's units.
  struct StepIntegrals
  {
    double       plastic_volume       = 0;
    double       dissipation          = 0; ///< ∫ σₙ₊₁:Δεᵖ dV of the step
    double       mean_dissipation     = 0; ///< ∫ ½(σₙ + σₙ₊₁):Δεᵖ dV of the step
    double       work                 = 0; ///< of the contact in the step, trapezoidal rule
    double       elastic_energy       = 0; ///< of the body and of the half-space around it
    double       mises_stress_max     = 0;
    double       plastic_strain_max   = 0;
    unsigned int apex_points          = 0;
    double       largest_yield_excess = 0; ///< max of laws::yield_excess() over the points
  };
} // namespace dpcontact

#endif
