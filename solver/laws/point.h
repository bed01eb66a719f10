#ifndef DPCONTACT_SOLVER_LAWS_POINT_H
#define DPCONTACT_SOLVER_LAWS_POINT_H

#include "meshing/enum_names.h"

#include <deal.II/base/symmetric_tensor.h>

namespace dpcontact::laws
{
  using StressTensor = dealii::SymmetricTensor<2, 3>;
  using Tangent      = dealii::SymmetricTensor<4, 3>;

  /// Which part of the yield surface a stress was returned to. Principal stresses are sorted,
  /// σ₁ ≥ σ₂ ≥ σ₃, tension positive.
  enum class Branch : unsigned char
  {
    elastic,
    regular,            ///< smooth surface, or the one plane of a surface of planes
    compression_edge,   ///< σ₁ = σ₂
    extension_edge,     ///< σ₂ = σ₃
    apex,               ///< of the cone or pyramid
    cutoff,             ///< tension cut-off alone: σ₁ = T₀
    cutoff_edge,        ///< σ₁ = σ₂ = T₀
    cutoff_apex,        ///< σ₁ = σ₂ = σ₃ = T₀
    corner,             ///< pyramid's plane and cut-off
    compression_corner, ///< compression edge and cut-off
    extension_corner    ///< extension edge and cut-off
  };
} // namespace dpcontact::laws

namespace dpcontact
{
  template <>
  struct EnumNames<laws::Branch>
  {
    static constexpr const char            *what     = "branch";
    static constexpr EnumName<laws::Branch> values[] = {
      {laws::Branch::elastic, "elastic"},
      {laws::Branch::regular, "regular"},
      {laws::Branch::compression_edge, "compression-edge"},
      {laws::Branch::extension_edge, "extension-edge"},
      {laws::Branch::apex, "apex"},
      {laws::Branch::cutoff, "cutoff"},
      {laws::Branch::cutoff_edge, "cutoff-edge"},
      {laws::Branch::cutoff_apex, "cutoff-apex"},
      {laws::Branch::corner, "corner"},
      {laws::Branch::compression_corner, "compression-corner"},
      {laws::Branch::extension_corner, "extension-corner"}};
  };
} // namespace dpcontact

namespace dpcontact::laws
{
  /// What a material point remembers.
  struct State
  {
    StressTensor plastic_strain;         ///< εᵖ
    double       hardening_variable = 0; ///< ε̄ᵖ
  };

  /// What a law answers to a strain.
  struct Response
  {
    StressTensor stress;
    Tangent      tangent; ///< consistent with the return mapping: dσₙ₊₁/dεₙ₊₁
    State        state;   ///< at the end of the step
    Branch       branch;
  };

  /// Fills D = (volumetric) I⊗I + (deviatoric) P, where P projects on deviators. K and 2G make it
  /// the elastic tangent. It is written straight into the 6×6 storage of SymmetricTensor<4,3>,
  /// whose entries are plain components in the order 11, 22, 33, 12, 13, 23.
  inline void
  fill_isotropic_tangent(Tangent &tangent, const double volumetric, const double deviatoric)
  {
    double *const D      = tangent.begin_raw();
    const double  normal = volumetric - deviatoric / 3;
    for (unsigned int i = 0; i < 36; ++i)
      D[i] = 0;
    for (unsigned int i = 0; i < 3; ++i)
      {
        for (unsigned int j = 0; j < 3; ++j)
          D[6 * i + j] = normal;
        D[7 * i] += deviatoric;
        D[7 * (i + 3)] = deviatoric / 2;
      }
  }

  /// The stress s + p I of a deviator and a pressure that is positive in tension.
  inline StressTensor with_pressure(const StressTensor &deviator, const double pressure)
  {
    StressTensor stress = deviator;
    for (unsigned int d = 0; d < 3; ++d)
      stress.access_raw_entry(d) += pressure;
    return stress;
  }

  /// The deviatoric stress s = 2G dev ε.
  inline StressTensor trial_deviator(const StressTensor &elastic_strain, const double shear_modulus)
  {
    StressTensor deviator = with_pressure(elastic_strain, -dealii::trace(elastic_strain) / 3);
    deviator *= 2 * shear_modulus;
    return deviator;
  }
} // namespace dpcontact::laws

#endif
