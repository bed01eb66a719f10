#ifndef DPCONTACT_TESTS_SUPPORT_SOIL_H
#define DPCONTACT_TESTS_SUPPORT_SOIL_H

#include "solver/laws/mohr_coulomb.h"

#include <cmath>

namespace dpcontact::tests
{
  using laws::MohrCoulomb;

  constexpr double degree   = M_PI / 180;
  constexpr double cohesion = 2e-3; // in units of E

  enum class Flow
  {
    associated,
    half,
    isochoric
  };
  enum class Cutoff
  {
    none,
    low,
    zero,
    near_apex
  };

  /// A law of unit Young's modulus; φ in degrees.
  inline MohrCoulomb
  soil(const double nu, const double phi_deg, const Flow flow, const Cutoff cutoff)
  {
    MohrCoulomb law{1 / (2 * (1 + nu)), 1 / (3 * (1 - 2 * nu)), phi_deg * degree, cohesion};
    if (flow == Flow::half)
      law.dilation_angle = law.friction_angle / 2;
    if (flow == Flow::isochoric)
      law.dilation_angle = 0;
    if (cutoff == Cutoff::low)
      law.tension_cutoff = 0.1 * cohesion;
    if (cutoff == Cutoff::zero)
      law.tension_cutoff = 0;
    if (cutoff == Cutoff::near_apex)
      law.tension_cutoff =
        phi_deg > 0 ? 0.999 * cohesion / std::tan(law.friction_angle) : 5 * cohesion;
    return law;
  }
} // namespace dpcontact::tests

#endif
