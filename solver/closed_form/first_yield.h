#ifndef DPCONTACT_SOLVER_CLOSED_FORM_FIRST_YIELD_H
#define DPCONTACT_SOLVER_CLOSED_FORM_FIRST_YIELD_H

#include "solver/problem/scene.h"

#include <array>

namespace dpcontact
{
  /// Where and at which load the elastic (Hertz) solution first reaches the yield surface. SI
  /// units. Equation numbers are those of Wang et al. (2018).
  struct FirstYield
  {
    double pressure;       ///< P₀,y: Hertz peak pressure at first yield on the axis, Pa
    double force;          ///< F_y, eq (12), N
    double approach;       ///< δ_y, eq (13), mutual, m
    double contact_radius; ///< a at F_y, m
    double depth_over_contact_radius; ///< u = z/a of the yielding point on the axis
    double ring_pressure; ///< Hertz peak pressure at which the ring r = a, z = 0 yields, Pa
    double ring_force;    ///< force at which the ring yields, N
    /// Up to this Hertz peak pressure nothing yields anywhere, for certain: that of the largest
    /// circular cone inside the yield surface and of the tension cut-off, Pa. For the circular cone
    /// itself it is the smaller of `pressure` and `ring_pressure`.
    double elastic_pressure;
    double elastic_force; ///< force of that pressure, N
    /// The force at which each body yields on its own axis in this contact, N; infinite for a rigid
    /// one. F_y is the smaller of the two.
    std::array<double, 2> body_force;

    /// The force below which the scene is wholly elastic, N.
    double onset_force() const { return force < ring_force ? force : ring_force; }
  };

  /// First yield of two identical spheres, on the axis (Wang et al. 2018, eqs 8–13, with the factor
  /// (1+ν) that eq (10) lacks restored) and on the ring r = a (σ_r = −σ_θ = (1−2ν)P₀/3).
  /// On the axis the stress is triaxial compression, where all criteria of the same φ and σc agree;
  /// the ring is in pure shear. Both yield at a finite load for every material that Material::check
  /// accepts (the ring at once where the tension cut-off is zero).
  ///
  /// @param radius of either sphere, m
  /// @throws InputError where material or radius are out of range.
  FirstYield first_yield(const Material &material, double radius);

  /// First yield of the scene's two bodies: P₀,y is the smaller of theirs, F_y = π³P₀³R*²/(6E*²),
  /// δ_y = π²P₀²R*/(4E*²). Where both bodies are identical the result is that of the other
  /// overload.
  /// @param material of the first body
  /// @throws InputError where a material or the scene is out of range.
  FirstYield first_yield(const Material &material, const Scene &scene);
} // namespace dpcontact

#endif
