#ifndef DPCONTACT_SOLVER_SCENE_H
#define DPCONTACT_SOLVER_SCENE_H

#include <limits>
#include <optional>
#include <string>

namespace dpcontact
{
  /// The yield criterion (laws/).
  enum class Criterion
  {
    drucker_prager, ///< cone through triaxial compression at φ and σc
    von_mises,      ///< φ = 0, σc is the uniaxial yield stress
    mohr_coulomb    ///< pyramid of φ and σc, with a tension cut-off where asked for
  };

  /// The name by which a criterion is asked for.
  const char *to_string(Criterion criterion);

  /// @throws InputError where `name` is none of the names that to_string() gives.
  Criterion parse_criterion(const std::string &name);

  /// Isotropic elastic-plastic rock. By default perfectly plastic Drucker–Prager, associated flow.
  struct Material
  {
    double youngs_modulus       = std::numeric_limits<double>::quiet_NaN(); ///< E, Pa
    double poisson_ratio        = std::numeric_limits<double>::quiet_NaN(); ///< ν
    double friction_angle       = std::numeric_limits<double>::quiet_NaN(); ///< φ, rad
    double compressive_strength = std::numeric_limits<double>::quiet_NaN(); ///< uniaxial σc, Pa

    Criterion criterion         = Criterion::drucker_prager;
    double    flow_stress_ratio = 1; ///< K of Drucker–Prager: tensile over compressive t
    /// ψ, rad: the potential's angle in the measure of φ. Unset: associated, ψ = φ.
    std::optional<double> dilation_angle{};
    /// Pa. Drucker–Prager: dσc/dε̄ᵖ. Von Mises: dσ_Y/dε̄ᵖ.
    double                hardening = 0;
    std::optional<double> tension_cutoff{}; ///< T₀ of Mohr–Coulomb, Pa. Unset: none

    /// ψ, rad
    double flow_angle() const { return dilation_angle.value_or(friction_angle); }
    /// Strength in pure shear: the largest σ₁ = −σ₃, σ₂ = 0, Pa.
    double shear_strength() const;
    /// Whether yield starts on the axis or on the ring for certain, so that below both nothing
    /// does.
    bool onset_is_known() const
    {
      return criterion != Criterion::mohr_coulomb && flow_stress_ratio == 1;
    }

    /// @throws InputError naming the quantity, its value and its range: E > 0, 0 ≤ ν < 0.5, 0 ≤ φ <
    /// 90°, σc > 0, 0.778 ≤ K ≤ 1, 0 ≤ ψ ≤ φ, H ≥ 0, T₀ ≥ 0, all finite; and for what the criterion
    /// does not have.
    void check() const;
  };

  /// What a sphere is pressed against where that is not a sphere of its own kind.
  struct SecondBody
  {
    double radius = std::numeric_limits<double>::infinity(); ///< R₂, m; infinite: a flat
    std::optional<Material> material{};                      ///< unset: rigid
  };

  /// Two spheres pressed together without friction.
  struct Scene
  {
    double                    radius    = 0.1; ///< R of the first sphere, m
    double                    force_max = 100; ///< peak normal force, N
    std::optional<SecondBody> second{};        ///< unset: identical to the first

    /// R* = R₁R₂/(R₁ + R₂), m
    double effective_radius() const;

    /// @throws InputError naming the quantity unless radius and force are finite and positive, the
    /// second radius positive, and the second material in range.
    void check() const;
  };
} // namespace dpcontact

#endif
