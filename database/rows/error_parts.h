#ifndef DPCONTACT_DATABASE_ROWS_ERROR_PARTS_H
#define DPCONTACT_DATABASE_ROWS_ERROR_PARTS_H

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

  /// A source of error: its name, what it is in the description of a column, and where it lives.
  struct ErrorSource
  {
    const char *name;
    const char *description;
    double ErrorParts::*member;
  };

  constexpr std::array<ErrorSource, 6> error_sources{
    {{"mesh", "left by the mesh", &ErrorParts::mesh},
     {"step", "left by the load step", &ErrorParts::step},
     {"contact", "left by the contact's stiffness or augmentation", &ErrorParts::contact},
     {"far_field", "left by the far boundary", &ErrorParts::far_field},
     {"finite_radius",
      "of the half-space for a true sphere at this a/R",
      &ErrorParts::finite_radius},
     {"fit", "of the fit: standard error and change with the window", &ErrorParts::fit}}};

  /// Of a, b, m, n.
  using CoefficientErrors = std::array<ErrorParts, 4>;
} // namespace dpcontact

#endif
