#ifndef DPCONTACT_SOLVER_LAWS_CRITERION_H
#define DPCONTACT_SOLVER_LAWS_CRITERION_H

#include "solver/laws/material.h"

namespace dpcontact
{
  /// What a yield criterion declares beside its law: the parameters that its materials have besides
  /// E, ν, φ and σc, and what follows from them.
  struct CriterionDefinition
  {
    Criterion                      criterion;
    std::vector<MaterialParameter> parameters; ///< in the order of help and documents

    bool        has_friction_angle = true;      ///< otherwise φ = 0
    std::string strength_symbol    = "sigma_c"; ///< of the uniaxial strength, in labels

    /// Turns φ and σc of a rock into what materials of this criterion keep; null: they keep both.
    void (*from_rock)(Material &) = nullptr;

    /// Throws InputError for what no range of a single parameter says; null: there is nothing.
    void (*check)(const Material &) = nullptr;

    /// Strength in pure shear: the largest σ₁ = −σ₃ with σ₂ = 0, Pa.
    double (*shear_strength)(const Material &);

    /// The deviatoric strength of the largest circular cone with the same apex that lies inside the
    /// yield surface, over that in triaxial compression: at most 1. What stays inside it is
    /// elastic.
    double (*inscribed_cone)(const Material &);
  };

  const CriterionDefinition &definition_of(Criterion criterion);

  /// All criteria, in the order of their names.
  const std::vector<CriterionDefinition> &criteria();

  /// definition_of(material.criterion).shear_strength(material)
  double shear_strength(const Material &material);

  /// definition_of(material.criterion).inscribed_cone(material)
  double inscribed_cone(const Material &material);

  // Parameters that more than one criterion has.
  MaterialParameter dilation_parameter();
  MaterialParameter hardening_parameter();
  /// @throws InputError unless 0 ≤ ψ ≤ φ.
  void check_dilation(const Material &material);
} // namespace dpcontact

#endif
