#include "solver/discretisation/far_field.h"

#include "solver/discretisation/kinematics.h"

#include <cmath>

namespace dpcontact
{
  template <int dim>
  BoussinesqField<dim>::BoussinesqField(const double youngs_modulus, const double nu)
    : shear_modulus(youngs_modulus / (2 * (1 + nu)))
    , poisson_ratio(nu)
  {}

  template <int dim>
  dealii::Tensor<1, dim> BoussinesqField<dim>::displacement(const dealii::Point<dim> &p) const
  {
    const double z = -p[dim - 1], rho = p.norm();
    const double c       = 1 / (4 * M_PI * shear_modulus);
    const double inwards = c * (z * z / (rho * rho * rho) + 2 * (1 - poisson_ratio) / rho);
    // u_r/r, finite on the axis: (ρ − z)/r² = 1/(ρ + z).
    const double radial_over_r =
      c * (z / (rho * rho * rho) - (1 - 2 * poisson_ratio) / (rho * (rho + z)));
    dealii::Tensor<1, dim> u;
    for (int i = 0; i + 1 < dim; ++i)
      u[i] = radial_over_r * p[i];
    u[dim - 1] = -inwards;
    return u;
  }

  template <int dim>
  dealii::Tensor<1, dim> BoussinesqField<dim>::traction(const dealii::Point<dim>     &p,
                                                        const dealii::Tensor<1, dim> &normal) const
  {
    const double r = radius(p), z = -p[dim - 1], rho = p.norm();
    const double m    = 1 - 2 * poisson_ratio;
    const double rho3 = rho * rho * rho, rho5 = rho3 * rho * rho;
    const double c        = 1 / (2 * M_PI);
    const double shell    = m / (rho * (rho + z)); // (1−2ν)(1/r²)(1 − z/ρ)
    const double sigma_r  = c * (shell - 3 * z * r * r / rho5);
    const double sigma_t  = c * m * (z / rho3 - 1 / (rho * (rho + z)));
    const double sigma_z  = -c * 3 * z * z * z / rho5;
    const double sigma_ry = c * 3 * r * z * z / rho5; // −σ_rz: y points against z

    dealii::Tensor<1, dim> e_r; // radial direction, components before the last
    double                 normal_r = 0;
    if (r > 0)
      for (int i = 0; i + 1 < dim; ++i)
        {
          e_r[i] = p[i] / r;
          normal_r += normal[i] * e_r[i];
        }
    dealii::Tensor<1, dim> t;
    for (int i = 0; i + 1 < dim; ++i)
      t[i] = e_r[i] * (sigma_r * normal_r + sigma_ry * normal[dim - 1]) +
             sigma_t * (normal[i] - normal_r * e_r[i]);
    t[dim - 1] = sigma_ry * normal_r + sigma_z * normal[dim - 1];
    return t;
  }

  template class BoussinesqField<2>;
  template class BoussinesqField<3>;
} // namespace dpcontact
