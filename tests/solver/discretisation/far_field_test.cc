#include "solver/discretisation/far_field.h"
#include "tests/support/floating_point_traps.h"

#include <deal.II/base/quadrature_lib.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
  using namespace dpcontact;
  using dealii::Point;
  using dealii::Tensor;

  const auto *const traps = tests::FloatingPointTraps::install();

  constexpr double youngs_modulus = 7.;

  /// Points of |p| near 1 in the body, none on an axis, none on the surface.
  const std::vector<Point<3>> inner_points{{0.3, 0.4, -0.8}, {-0.9, 0.2, -0.4}, {0.1, -0.6, -0.1}};

  /// ∂u_i/∂x_j by central differences; at h = 1e-4 truncation and rounding are both below 1e-7 of
  /// it.
  Tensor<2, 3> gradient(const BoussinesqField<3> &field, const Point<3> &p)
  {
    const double h = 1e-4;
    Tensor<2, 3> g;
    for (unsigned int j = 0; j < 3; ++j)
      {
        Point<3> above = p, below = p;
        above[j] += h;
        below[j] -= h;
        const auto du = field.displacement(above) - field.displacement(below);
        for (unsigned int i = 0; i < 3; ++i)
          g[i][j] = du[i] / (2 * h);
      }
    return g;
  }

  Tensor<2, 3> hooke(const Tensor<2, 3> &g, const double nu)
  {
    const double shear = youngs_modulus / (2 * (1 + nu));
    const double lame  = 2 * shear * nu / (1 - 2 * nu);
    return shear * (g + dealii::transpose(g)) +
           lame * dealii::trace(g) * dealii::Tensor<2, 3>(dealii::unit_symmetric_tensor<3>());
  }

  class Boussinesq : public ::testing::TestWithParam<double>
  {
  protected:
    const double       nu = GetParam();
    BoussinesqField<3> space{youngs_modulus, nu};
    BoussinesqField<2> plane{youngs_modulus, nu};
  };

  TEST_P(Boussinesq, displacement_satisfies_navier_equilibrium)
  {
    // (1−2ν) ∇²u + ∇(∇·u) = 0 by second differences. At h = 1e-3 they err by h² u'''' ~ 1e-5 of the
    // second derivatives, which are as large as u here.
    const double h = 1e-3;
    for (const auto &p : inner_points)
      {
        const auto shifted =
          [&](const unsigned int i, const double a, const unsigned int j, const double b) {
            Point<3> q = p;
            q[i] += a;
            q[j] += b;
            return space.displacement(q);
          };
        Tensor<3, 3> second; // ∂²u_k/∂x_i∂x_j
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            {
              const auto d =
                i == j ? (shifted(i, h, i, 0) - 2. * space.displacement(p) + shifted(i, -h, i, 0)) /
                           (h * h)
                       : (shifted(i, h, j, h) - shifted(i, h, j, -h) - shifted(i, -h, j, h) +
                          shifted(i, -h, j, -h)) /
                           (4 * h * h);
              for (unsigned int k = 0; k < 3; ++k)
                second[k][i][j] = d[k];
            }
        for (unsigned int k = 0; k < 3; ++k)
          {
            double residual = 0, scale = 0;
            for (unsigned int i = 0; i < 3; ++i)
              {
                residual += (1 - 2 * nu) * second[k][i][i] + second[i][i][k];
                scale += std::abs(second[k][i][i]) + std::abs(second[i][i][k]);
              }
            EXPECT_LT(std::abs(residual), 1e-4 * scale) << "component " << k << " at " << p;
          }
      }
  }

  TEST_P(Boussinesq, traction_is_hookes_law_of_the_displacement)
  {
    for (const auto &p : inner_points)
      {
        const auto   sigma     = hooke(gradient(space, p), nu);
        const double magnified = 1 + 2 * nu / (1 - 2 * nu); // errors in ∇·u count λ/G-fold
        for (Tensor<1, 3> n : {Tensor<1, 3>{{1, 0, 0}},
                               Tensor<1, 3>{{0, 0.6, 0.8}},
                               Tensor<1, 3>{{0.48, -0.64, -0.6}}})
          EXPECT_LT((space.traction(p, n) - sigma * n).norm(), 1e-6 * magnified * sigma.norm())
            << p << ", normal " << n;
      }
  }

  TEST_P(Boussinesq, the_free_surface_carries_no_traction)
  {
    const Point<3> p(0.7, -0.3, 0.);
    EXPECT_LT(space.traction(p, Tensor<1, 3>{{0, 0, 1}}).norm(), 1e-14);
  }

  TEST_P(Boussinesq, the_axis_is_regular)
  {
    const Point<2>     on(0., -0.8), near(1e-9, -0.8);
    const Tensor<1, 2> n{{0.6, -0.8}};
    EXPECT_EQ(plane.displacement(on)[0], 0.);
    EXPECT_LT((plane.displacement(on) - plane.displacement(near)).norm(), 1e-9);
    // σ_r = σ_θ there, so that the component along a normal without radial direction is what is
    // left.
    const Tensor<1, 2> down{{0., -1.}};
    EXPECT_LT((plane.traction(on, down) - plane.traction(near, down)).norm(), 1e-8);
    EXPECT_TRUE(std::isfinite(plane.traction(on, n).norm()));
  }

  TEST_P(Boussinesq, the_half_plane_is_a_section_of_space)
  {
    for (const auto &p : inner_points)
      {
        const double       r = std::hypot(p[0], p[1]);
        const Point<2>     q(r, p[2]);
        const Tensor<1, 3> e_r{{p[0] / r, p[1] / r, 0.}};
        const auto         lift = [&e_r](const Tensor<1, 2> &v) {
          Tensor<1, 3> w = v[0] * e_r;
          w[2] += v[1];
          return w;
        };
        EXPECT_LT((space.displacement(p) - lift(plane.displacement(q))).norm(), 1e-15);
        const Tensor<1, 2> n{{0.6, -0.8}};
        EXPECT_LT((space.traction(p, lift(n)) - lift(plane.traction(q, n))).norm(), 1e-14);
      }
  }

  /// Force that a body inside a surface of revolution takes from outside: the normals point out.
  /// Gauss points along the generator from `begin` to `end`.
  template <class Curve, class Normal>
  double vertical_force(const BoussinesqField<2> &field,
                        const Curve              &curve,
                        const Normal             &normal,
                        const double              length)
  {
    double                  force = 0;
    const dealii::QGauss<1> quadrature(40);
    for (unsigned int k = 0; k < quadrature.size(); ++k)
      {
        const double   t = quadrature.point(k)[0];
        const Point<2> p = curve(t);
        force += quadrature.weight(k) * length * 2 * M_PI * p[0] * field.traction(p, normal(t))[1];
      }
    return force;
  }

  TEST_P(Boussinesq, traction_over_any_enclosing_surface_balances_the_unit_force)
  {
    // 40 Gauss points on analytic integrands leave rounding only.
    const double hemisphere = vertical_force(
      plane,
      [](const double t) {
        return Point<2>(2 * std::sin(M_PI / 2 * t), -2 * std::cos(M_PI / 2 * t));
      },
      [](const double t) {
        return Tensor<1, 2>{{std::sin(M_PI / 2 * t), -std::cos(M_PI / 2 * t)}};
      },
      M_PI);
    EXPECT_NEAR(hemisphere, 1, 1e-12);

    const double wall = vertical_force(
      plane,
      [](const double t) { return Point<2>(1.5, -0.8 * t); },
      [](double) {
        return Tensor<1, 2>{{1., 0.}};
      },
      0.8);
    const double floor = vertical_force(
      plane,
      [](const double t) { return Point<2>(1.5 * t, -0.8); },
      [](double) {
        return Tensor<1, 2>{{0., -1.}};
      },
      1.5);
    EXPECT_NEAR(wall + floor, 1, 1e-12);
    EXPECT_GT(wall, 0.05) << "both parts must count";
  }

  INSTANTIATE_TEST_SUITE_P(poisson_ratios, Boussinesq, ::testing::Values(0., 0.3, 0.49));
} // namespace
