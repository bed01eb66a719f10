#ifndef DPCONTACT_SOLVER_PATH_REMOTE_COMPLIANCE_H
#define DPCONTACT_SOLVER_PATH_REMOTE_COMPLIANCE_H

#include "solver/path/solve.h"

namespace dpcontact
{
  // What a true sphere adds to the approach of a half-space consists of a remote elastic part,
  // linear in F and of order a/R of δ, and of what happens at the contact. δ is the approach of
  // remote points, to which the first part does not belong.
  //
  // An elastic sphere of contact radius a obeys, to first order in a/R,
  //   δ_sphere − δ_half-space = F [c₀ + c₁ ln(D/a)]/(E R),  c₁ = (1−2ν)²(1+ν)/π (mutual),
  // D being the distance of the far boundary and c₀ a function of ν and D/R. The logarithm comes
  // from Boussinesq's stress σ_r = −σ_θ = (1−2ν)F/(2πr²) in the layer r²/2R that the sphere lacks:
  // the half-space feels an inward shear traction (1−2ν)F/(2πRr), under which the centre sinks by
  // (1−2ν)(1+ν)/E ∫ (traction) dr (Johnson, Contact Mechanics, 1985, section 3.6). So C belongs to
  // one contact radius; taken at the peak it leaves c₁ F ln(a_peak/a)/(E R), at most 0.03 (a/R)
  // δ_peak.

  /// Elastic compliance C = (δ_sphere − δ_half-space)/F between the two surfaces, in m/N (mutual
  /// approach), from one elastic solution each on the same mesh, mapped and not, with the same far
  /// boundary, under the force that gives Hertz's contact radius `mesh_radius`.
  /// @param material its E and ν count, its strength does not.
  /// @param options of the sphere's run; `surface` plays no role.
  /// @param mesh_radius contact radius that the mesh was fitted to, m (Solution::mesh_radius).
  /// @throws InputError for values out of range, among them a domain-radius beyond the sphere's radius;
  /// SolverError where Newton fails.
  double remote_compliance(const Material      &material,
                           double               sphere_radius,
                           const SolverOptions &options,
                           double               mesh_radius);

  /// The curve with δ − C F for δ at every point of both branches; δ_res stays.
  /// @param compliance C, m/N, of either sign.
  /// @throws InputError where C is not finite or so large that a branch is no longer monotone.
  Curve remove_linear_compliance(const Curve &curve, double compliance);
} // namespace dpcontact

#endif
