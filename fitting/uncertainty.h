#ifndef DPCONTACT_FITTING_UNCERTAINTY_H
#define DPCONTACT_FITTING_UNCERTAINTY_H

#include "fitting/curve_fit.h"
#include "solver/solve.h"

#include <array>
#include <limits>

namespace dpcontact
{
  /// What may be wrong with one coefficient, by source; absolute, in the coefficient's own unit
  /// (1). NaN where no estimate exists for the settings that were used.
  struct ErrorParts
  {
    static constexpr double unset = std::numeric_limits<double>::quiet_NaN();

    double mesh          = unset;
    double step          = unset; ///< load step
    double contact       = unset; ///< penalty stiffness, or tolerance of the augmentation
    double far_field     = unset;
    double finite_radius = unset; ///< half-space and parabola for a sphere of finite a/R
    double fit           = unset; ///< standard error and change with the window of the fit

    /// What discretisation leaves: mesh, step, contact and far field.
    double numerical() const { return mesh + step + contact + far_field; }
    double total() const { return numerical() + finite_radius + fit; }
  };

  /// Of a, b, m, n.
  using CoefficientErrors = std::array<ErrorParts, 4>;

  /// a, b, m, n of the consistent pair.
  std::array<double, 4> coefficients(const CurveFit &fit);

  /// The part `fit`: standard error plus |change of the coefficient in the window [0.1, 1] of the
  /// approach|.
  std::array<double, 4> fit_errors(const CurveFit &fit);

  /// The relative error of a, b, m, n that the half-space makes for a sphere: of first order in
  /// kappa = a/R; excess: δ_max/δ_Hertz − 1.
  std::array<double, 4> finite_radius_errors(double excess, double kappa);

  /// The cheap estimate: no further computation. Step: how far the fit moves between the curve and
  /// `solution.coarser_steps`. Mesh, contact, far field, finite radius: closed expressions in the
  /// settings, a/R and the excess of the peak's approach over Hertz's, calibrated on the study of
  /// runs/error_study (see uncertainty.cc): associated, perfectly plastic Drucker–Prager with φ
  /// from 20 to 40°. For other materials mesh and step count three times.
  /// @param fit of solution.curve.
  CoefficientErrors estimate_errors(const CurveFit &fit,
                                    const Solution &solution,
                                    const Material &material,
                                    const Scene    &scene);
} // namespace dpcontact

#endif
