#ifndef DPCONTACT_SOLVER_DISCRETISATION_KINEMATICS_H
#define DPCONTACT_SOLVER_DISCRETISATION_KINEMATICS_H

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>

#include <array>
#include <cmath>
#include <utility>

namespace dpcontact
{
  /// How a displacement in `dim` coordinates becomes a small strain in space.
  ///
  /// dim = 2 is axisymmetry: coordinates (r, y), components (u_r, u_y), hoop strain u_r/r, and
  /// every integral carries 2πr. dim = 3 is space. The last coordinate is the outward normal of the
  /// contact surface. The strain's independent components are kept as a vector of `n_strains`
  /// entries, shears counted twice (γ = 2ε), so that σ·ε is the plain product with the stresses.
  template <int dim>
  struct Kinematics;

  template <>
  struct Kinematics<2>
  {
    static constexpr unsigned int n_strains = 4;

    /// Positions (i, j) in the spatial tensor of the strain components rr, yy, θθ, ry.
    static constexpr std::array<std::pair<unsigned int, unsigned int>, n_strains> positions{
      {{0, 0}, {1, 1}, {2, 2}, {0, 1}}};

    /// Strain of the shape function that moves `component` by `value` with gradient `gradient`.
    static std::array<double, n_strains> strain(const unsigned int          component,
                                                const double                value,
                                                const dealii::Tensor<1, 2> &gradient,
                                                const dealii::Point<2>     &p)
    {
      if (component == 0)
        return {gradient[0], 0., value / p[0], gradient[1]};
      return {0., gradient[1], 0., gradient[0]};
    }

    /// What one unit of area in the half plane weighs.
    static double measure(const dealii::Point<2> &p) { return 2 * M_PI * p[0]; }
  };

  template <>
  struct Kinematics<3>
  {
    static constexpr unsigned int n_strains = 6;

    static constexpr std::array<std::pair<unsigned int, unsigned int>, n_strains> positions{
      {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

    static std::array<double, n_strains> strain(const unsigned int component,
                                                const double,
                                                const dealii::Tensor<1, 3> &g,
                                                const dealii::Point<3> &)
    {
      if (component == 0)
        return {g[0], 0., 0., g[1], g[2], 0.};
      if (component == 1)
        return {0., g[1], 0., g[0], 0., g[2]};
      return {0., 0., g[2], 0., g[0], g[1]};
    }

    static double measure(const dealii::Point<3> &) { return 1; }
  };

  /// Distance from the axis of symmetry, which is the last coordinate's.
  template <int dim>
  double radius(const dealii::Point<dim> &p)
  {
    double square = 0;
    for (int i = 0; i + 1 < dim; ++i)
      square += p[i] * p[i];
    return std::sqrt(square);
  }

  /// The spatial strain tensor of a strain vector.
  template <int dim>
  dealii::SymmetricTensor<2, 3>
  strain_tensor(const std::array<double, Kinematics<dim>::n_strains> &components)
  {
    dealii::SymmetricTensor<2, 3> tensor;
    for (unsigned int s = 0; s < Kinematics<dim>::n_strains; ++s)
      {
        const auto [i, j] = Kinematics<dim>::positions[s];
        tensor[i][j]      = i == j ? components[s] : components[s] / 2;
      }
    return tensor;
  }
} // namespace dpcontact

#endif
