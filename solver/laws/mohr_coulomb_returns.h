#ifndef DPCONTACT_SOLVER_LAWS_MOHR_COULOMB_RETURNS_H
#define DPCONTACT_SOLVER_LAWS_MOHR_COULOMB_RETURNS_H

#include "solver/laws/point.h"

#include <array>

/// The return mapping of mohr_coulomb.h in the space of principal values, which are sorted: first ≥
/// second ≥ third, tension positive. Stresses in any one unit.
namespace dpcontact::laws::principal
{
  using Vector = std::array<double, 3>;

  /// 1 − sin of an angle in rad, without loss of digits towards π/2.
  double one_minus_sine(double angle);

  /// Elastic constants and strengths, in the form in which the returns need them.
  struct Constants
  {
    double G;                 ///< shear modulus
    double K;                 ///< bulk modulus
    double E;                 ///< Young's modulus
    double nu;                ///< Poisson's ratio
    double sin_phi;           ///< sinφ
    double one_minus_sin_phi; ///< 1 − sinφ
    double strength;          ///< C cosφ
    double sin_psi;           ///< sinψ
    double one_minus_sin_psi; ///< 1 − sinψ
    bool   cut;               ///< whether the cut-off cuts the pyramid
    double T;                 ///< T₀; 0 where the cut-off does not cut
    double corner_sig3;       ///< σ₃ where both the pyramid and the cut-off hold

    /// f of the pyramid.
    double pyramid(const double sigma1, const double sigma3) const
    {
      return (sigma1 - sigma3) / 2 + (sigma1 + sigma3) / 2 * sin_phi - strength;
    }

    /// Stresses of the elastic strains v.
    /// @param trace of v, given apart because it may be known to more digits than the sum has.
    Vector elastic(const Vector &v, double trace) const;

    /// Elastic strains of the stresses σ. The deviator is taken from differences, so that a large
    /// pressure leaves no rounding over 2G in it.
    Vector elastic_strain(const Vector &sigma) const;
  };

  /// Elastic strains of the trial state.
  struct Trial
  {
    Vector d;      ///< deviatoric
    Vector x;      ///< total
    double volume; ///< their trace
  };

  /// Where a trial state returns to.
  struct Return
  {
    Branch branch;
    Vector sigma;     ///< stresses
    Vector flow;      ///< Δεᵖ
    double violation; ///< largest violation of the conditions of the set of planes, as a stress
  };

  /// The return of a trial state that lies outside the yield surface.
  ///
  /// The sets of active planes partition the trial states, with the same stress where two meet: the
  /// first set whose conditions hold is the answer, and where rounding leaves none, the nearest.
  Return sorted_return(const Constants &c, const Trial &trial);

  /// ∂σᵢ/∂εⱼ of the principal values after a return to `branch`.
  std::array<Vector, 3> principal_tangent(const Constants &c, Branch branch);

  /// Whether principal stresses i < j are equal wherever a stress was returned to `branch`.
  bool tied(Branch branch, unsigned int i, unsigned int j);
} // namespace dpcontact::laws::principal

#endif
