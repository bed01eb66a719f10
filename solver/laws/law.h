#ifndef DPCONTACT_SOLVER_LAWS_LAW_H
#define DPCONTACT_SOLVER_LAWS_LAW_H

#include "solver/laws/drucker_prager.h"
#include "solver/laws/material.h"
#include "solver/laws/mohr_coulomb.h"
#include "solver/laws/von_mises.h"

#include <variant>

namespace dpcontact::laws
{
  /// One of the laws. All are isotropic and linear elastic inside their yield surface.
  using Law = std::variant<DruckerPrager, VonMises, MohrCoulomb>;

  /// The law's return mapping, a pure function.
  /// @param strain total, at the end of the step
  inline Response evaluate(const Law &law, const State &old_state, const StressTensor &strain)
  {
    return std::visit([&](const auto &l) { return l.evaluate(old_state, strain); }, law);
  }

  /// f of the law divided by the strength of the virgin material in f: k, σ_Y or C cosφ.
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

namespace dpcontact
{
  /// The law of a material in a solver's units.
  /// @param stress_unit in Pa. @param strain_unit the strain that counts as 1; stresses over strains
  /// are then in units of stress_unit/strain_unit.
  inline laws::Law
  law_of(const Material &material, const double stress_unit = 1, const double strain_unit = 1)
  {
    switch (material.criterion)
      {
        case Criterion::von_mises:
          return laws::VonMises::of(material, stress_unit, strain_unit);
        case Criterion::mohr_coulomb:
          return laws::MohrCoulomb::of(material, stress_unit, strain_unit);
        case Criterion::drucker_prager:
          break;
      }
    return laws::DruckerPrager::of(material, stress_unit, strain_unit);
  }
} // namespace dpcontact

#endif
