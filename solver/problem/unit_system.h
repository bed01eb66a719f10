#ifndef DPCONTACT_SOLVER_PROBLEM_UNIT_SYSTEM_H
#define DPCONTACT_SOLVER_PROBLEM_UNIT_SYSTEM_H

#include "solver/problem/curve.h"

namespace dpcontact
{
  /// The units in which a model is solved, as factors to SI.
  ///
  /// Scaled: lengths by the contact radius a, displacements by a²/R, stresses by E a/R, and E, a, R
  /// are 1; for two bodies R is 2R* and E that of the softer. Small strain lets lengths and
  /// displacements have units of their own; a/R then drops out, and only ν, φ and the load level
  /// stay. A sphere's surface brings a/R back, as the curvature of the mesh and in the gap, and
  /// nowhere else.
  struct UnitSystem
  {
    double length       = 1;
    double displacement = 1;
    double stress       = 1;
    /// Share of the bodies that the mesh covers: a wedge carries that share of the force.
    double share = 1;

    double force() const { return stress * volume() / length; }
    double volume() const { return length * length * length / share; }
    double energy() const { return force() * displacement; }
    double strain() const { return displacement / length; }

    /// The factors of a curve's quantities to SI.
    CurveScale curve_scale() const
    {
      return {displacement, force(), length, stress, volume(), energy(), strain()};
    }
  };
} // namespace dpcontact

#endif
