#ifndef DPCONTACT_SOLVER_LAWS_LAW_H
#define DPCONTACT_SOLVER_LAWS_LAW_H

#include "solver/laws/drucker_prager.h"
#include "solver/laws/mohr_coulomb.h"
#include "solver/laws/von_mises.h"

#include <variant>

namespace dpcontact::laws
{
  /// Any of the laws. All are isotropic and linear elastic inside their yield surface.
  using Law = std::variant<DruckerPrager, VonMises, MohrCoulomb>;

  inline Response evaluate(const Law &law, const State &old_state, const StressTensor &strain)
  {
    return std::visit([&](const auto &l) { return l.evaluate(old_state, strain); }, law);
  }

  /// f of the law over the strength that f measures against (k, σ_Y, C cosφ of the virgin
  /// material).
  inline double
  yield_excess(const Law &law, const StressTensor &stress, const double hardening_variable)
  {
    struct Scale
    {
      double operator()(const DruckerPrager &l) const { return l.strength; }
      double operator()(const VonMises &l) const { return l.yield_stress; }
      double operator()(const MohrCoulomb &l) const { return l.strength(); }
    };
    return std::visit(
      [&](const auto &l) { return l.yield_function(stress, hardening_variable) / Scale()(l); },
      law);
  }

  /// Whether the tangent has major symmetry.
  inline bool associated(const Law &law)
  {
    return std::visit([](const auto &l) { return l.associated(); }, law);
  }

  inline double shear_modulus(const Law &law)
  {
    return std::visit([](const auto &l) { return l.shear_modulus; }, law);
  }

  inline double bulk_modulus(const Law &law)
  {
    return std::visit([](const auto &l) { return l.bulk_modulus; }, law);
  }
} // namespace dpcontact::laws

#endif
