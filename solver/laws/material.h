#ifndef DPCONTACT_SOLVER_LAWS_MATERIAL_H
#define DPCONTACT_SOLVER_LAWS_MATERIAL_H

#include "meshing/enum_names.h"
#include "solver/laws/parameter.h"

#include <limits>
#include <optional>
#include <vector>

namespace dpcontact
{
  /// The yield criterion.
  enum class Criterion
  {
    drucker_prager, ///< cone through triaxial compression at φ and σc
    von_mises,      ///< φ = 0, σc is the uniaxial yield stress
    mohr_coulomb    ///< pyramid of φ and σc, with a tension cut-off where asked for
  };

  template <>
  struct EnumNames<Criterion>
  {
    static constexpr const char         *what     = "criterion";
    static constexpr EnumName<Criterion> values[] = {{Criterion::drucker_prager, "drucker-prager"},
                                                     {Criterion::von_mises, "von-mises"},
                                                     {Criterion::mohr_coulomb, "mohr-coulomb"}};
  };

  /// An angle as it was given, in degrees: free of the rounding of radians.
  class Angle
  {
  public:
    constexpr Angle() = default;
    explicit constexpr Angle(const double degrees)
      : value(degrees)
    {}
    constexpr double degrees() const { return value; }
    double           radians() const;

  private:
    double value = std::numeric_limits<double>::quiet_NaN();
  };
  inline bool operator==(const Angle p, const Angle q) { return p.degrees() == q.degrees(); }
  inline bool operator!=(const Angle p, const Angle q) { return !(p == q); }

  /// Isotropic elastic-plastic rock. By default perfectly plastic Drucker–Prager, associated flow.
  struct Material
  {
    double youngs_modulus       = std::numeric_limits<double>::quiet_NaN(); ///< E, Pa
    double poisson_ratio        = std::numeric_limits<double>::quiet_NaN(); ///< ν
    Angle  friction_angle       = {};                                       ///< φ
    double compressive_strength = std::numeric_limits<double>::quiet_NaN(); ///< uniaxial σc, Pa

    Criterion criterion         = Criterion::drucker_prager;
    double    flow_stress_ratio = 1; ///< K of Drucker–Prager: tensile over compressive t
    /// ψ: the potential's angle in the measure of φ. Unset: associated, ψ = φ.
    std::optional<Angle> dilation_angle{};
    /// Pa. Drucker–Prager: dσc/dε̄ᵖ. Von Mises: dσ_Y/dε̄ᵖ.
    double                hardening = 0;
    std::optional<double> tension_cutoff{}; ///< T₀ of Mohr–Coulomb, Pa. Unset: none

    /// ψ
    Angle flow_angle() const { return dilation_angle.value_or(friction_angle); }

    /// G and the bulk modulus in units of stress_unit/strain_unit (law_of()).
    double shear_modulus(double stress_unit, double strain_unit) const;
    double bulk_modulus(double stress_unit, double strain_unit) const;

    /// @throws InputError naming the quantity, its value and its range, and for what the criterion
    /// does not have (material_parameters()).
    void check() const;
  };

  /// Equal in the criterion and in every parameter.
  bool operator==(const Material &p, const Material &q);

  using MaterialParameter = Parameter<Material>;

  /// Every parameter of a material: E, ν, φ, σc of all criteria, then what single criteria have
  /// (each declares its own beside its law). Criteria that share a parameter share its entry.
  const std::vector<MaterialParameter> &material_parameters();

  /// Criteria as text: "drucker-prager or mohr-coulomb".
  std::string one_of(const std::vector<Criterion> &criteria);

  /// Whether a parameter that only single criteria have is as where none is given. Another way to
  /// give a number (`instead_of`) has no value of its own and always is.
  bool is_default(const MaterialParameter &parameter, const Material &material);

  /// Whether every parameter that only single criteria have is at its default.
  bool has_default_parameters(const Material &material);

  /// Whether the tables of this project hold this kind of material, and the stated errors are
  /// calibrated for it: perfectly plastic Drucker–Prager with associated flow on the circular cone.
  bool is_tabulated_kind(const Material &material);

  /// What is_tabulated_kind() asks for, for messages.
  constexpr const char *tabulated_kind =
    "associated, perfectly plastic drucker-prager with K = 1 (no hardening, dilation equal to phi)";
} // namespace dpcontact

#endif
