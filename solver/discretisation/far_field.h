#ifndef DPCONTACT_SOLVER_DISCRETISATION_FAR_FIELD_H
#define DPCONTACT_SOLVER_DISCRETISATION_FAR_FIELD_H

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>

namespace dpcontact
{
  /// Boussinesq's elastic half-space under a unit point force that presses its surface inwards at
  /// the origin (Johnson, Contact Mechanics, 1985, eqs 3.18–3.19). The last coordinate is the
  /// outward normal of the surface; the body lies where it is negative.
  ///
  /// Outside the mesh the body is taken as this field with an amplitude s that is an unknown of the
  /// system: the far boundary moves as s·displacement(x), and the exterior answers with the
  /// traction s·stress(x)·n. For a contact in equilibrium s is its force F. The pressure's spread
  /// over a radius a changes the field at distance L by O((a/L)²) of itself, a plastic
  /// zone of radius c leaves O(c³/L²).
  template <int dim>
  class BoussinesqField
  {
  public:
    BoussinesqField(double youngs_modulus, double poisson_ratio);

    /// Displacement at p ≠ 0; for dim = 2 in (r, y).
    dealii::Tensor<1, dim> displacement(const dealii::Point<dim> &p) const;

    /// Stress σ·n on a surface of normal n; for dim = 2 in (r, y).
    dealii::Tensor<1, dim> traction(const dealii::Point<dim>     &p,
                                    const dealii::Tensor<1, dim> &normal) const;

  private:
    double shear_modulus;
    double poisson_ratio;
  };
} // namespace dpcontact

#endif
