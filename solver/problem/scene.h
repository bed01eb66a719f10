#ifndef DPCONTACT_SOLVER_PROBLEM_SCENE_H
#define DPCONTACT_SOLVER_PROBLEM_SCENE_H

#include "solver/laws/material.h"

#include <limits>
#include <optional>

namespace dpcontact
{
  /// What a sphere is pressed against where that is not a sphere of its own kind.
  struct SecondBody
  {
    double radius = std::numeric_limits<double>::infinity(); ///< R₂, m; infinite: a flat
    std::optional<Material> material{};                      ///< unset: rigid
  };
  bool operator==(const SecondBody &p, const SecondBody &q);

  /// Two spheres pressed together without friction.
  struct Scene
  {
    double                    radius    = 0.1; ///< R of the first sphere, m
    double                    force_max = 100; ///< peak normal force, N
    std::optional<SecondBody> second{};        ///< unset: identical to the first

    /// R* = R₁R₂/(R₁ + R₂), m
    double effective_radius() const;

    /// The smaller of R₁ and R₂, m.
    double smaller_radius() const;

    /// @throws InputError naming the quantity unless radius and force are finite and positive, the
    /// second radius positive, and the second material in range.
    void check() const;
  };
  bool operator==(const Scene &p, const Scene &q);
} // namespace dpcontact

#endif
