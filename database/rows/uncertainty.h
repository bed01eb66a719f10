#ifndef DPCONTACT_DATABASE_ROWS_UNCERTAINTY_H
#define DPCONTACT_DATABASE_ROWS_UNCERTAINTY_H

#include "database/rows/error_parts.h"
#include "fitting/curve_fit.h"

#include <array>

namespace dpcontact
{
  struct Material;
  struct Scene;
  struct Solution;

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
  /// runs/studies/error_study (see uncertainty.cc): associated, perfectly plastic Drucker–Prager
  /// with φ from 20 to 40°. For other materials mesh and step count three times.
  /// @param fit of solution.curve.
  CoefficientErrors estimate_errors(const CurveFit &fit,
                                    const Solution &solution,
                                    const Material &material,
                                    const Scene    &scene);
} // namespace dpcontact

#endif
