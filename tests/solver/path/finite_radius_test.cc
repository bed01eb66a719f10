// The true sphere instead of the half-space under a parabola, and what is remote in its approach.

#include "meshing/errors.h"
#include "solver/closed_form/hertz.h"
#include "solver/discretisation/undeformed_gap.h"
#include "solver/path/remote_compliance.h"
#include "solver/path/runs.h"
#include "solver/path/solution.h"
#include "solver/path/solve.h"
#include "tests/support/floating_point_traps.h"
#include "tests/support/plane_meshes.h"
#include "tests/support/solver_environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
  using namespace dpcontact;
  using tests::expect_refused;

  const auto *const traps  = tests::FloatingPointTraps::install();
  const auto *const solver = tests::SolverEnvironment::install();

  constexpr double R = 0.1, E = 10e9, far_over_R = 0.8;

  Material elastic(const double nu) { return {E, nu, Angle(30), 1e16}; }

  SolverOptions
  options(const double kappa, const Surface surface, const unsigned int resolution = 12)
  {
    SolverOptions result;
    result.resolution    = resolution;
    result.domain_radius = far_over_R / kappa;
    result.surface       = surface;
    return result;
  }

  /// The force whose elastic contact radius is κR.
  Scene scene_of(const Material &material, const double kappa)
  {
    return {R, hertz::force(material, R, 2 * kappa * kappa * R)};
  }

  std::vector<CurvePoint>
  loading(const Material &material, const double kappa, const Surface surface)
  {
    HalfSpaceModel model(material, scene_of(material, kappa), options(kappa, surface), kappa * R);
    return run_to_peak(model, 6);
  }

  // C E R of the elastic sphere.
  double compliance(const double nu, const double kappa, const unsigned int resolution = 12)
  {
    return remote_compliance(
             elastic(nu), R, options(kappa, Surface::sphere, resolution), kappa * R) *
           E * R;
  }

  /// c₁ of the logarithm in the compliance.
  double logarithm(const double nu) { return (1 - 2 * nu) * (1 - 2 * nu) * (1 + nu) / M_PI; }

  TEST(UndeformedGap, gap_of_the_sphere_agrees_with_long_double)
  {
    // The plain formula loses 2⁻⁶⁴/(κr)² of itself to cancellation, below 1e-15 here.
    for (const double kappa : {0.01, 0.1, 0.5})
      for (const double r : {1., 1.2, 1.9})
        {
          const long double k = kappa, x = r;
          const long double exact = (1 - std::sqrt(1 - k * k * x * x)) / (k * k);
          EXPECT_NEAR(UndeformedGap(1, kappa).gap(r) / static_cast<double>(exact), 1, 2e-15);
        }
    EXPECT_EQ(UndeformedGap(1, 0.5).gap(2), 4.); // the equator: h = R
  }

  TEST(UndeformedGap, gap_without_curvature_is_the_parabola_and_nearly_so_with_little)
  {
    EXPECT_EQ(UndeformedGap(0.1).gap(0.003), 0.003 * 0.003 / 0.2);
    EXPECT_NEAR(UndeformedGap(1, 1e-9).gap(0.7) / (0.7 * 0.7 / 2), 1, 1e-15);
    // κ²r²/4 of it is the next term.
    EXPECT_NEAR(UndeformedGap(1, 1e-3).gap(1) / 0.5 - 1, 1e-6 / 4, 1e-12);
  }

  TEST(FiniteRadius, axisymmetric_surface_weights_are_the_area_seen_along_the_axis)
  {
    constexpr double kappa = 0.08;
    const Material   rock  = elastic(0.2);
    HalfSpaceModel   model(rock, scene_of(rock, kappa), options(kappa, Surface::sphere), kappa * R);
    double           area = 0, reach = 0;
    for (const auto &face : model.discretisation().surface())
      for (const auto &point : face.points)
        {
          area += point.weight;
          reach = std::max(reach, point.radius);
        }
    const double rho = far_over_R / kappa;
    EXPECT_NEAR(reach / (rho * std::sqrt(1 - far_over_R * far_over_R / 4)), 1, 1e-12);
    EXPECT_NEAR(area / (M_PI * reach * reach), 1, 1e-12);
  }

  TEST(FiniteRadius, axisymmetric_plastic_curve_tends_to_the_parabola)
  {
    // All that the sphere changes is of first order in κ, with factors below 1.
    constexpr double kappa    = 1e-6;
    Material         weak     = elastic(0.2);
    const Scene      scene    = scene_of(weak, kappa);
    weak.compressive_strength = 0.08 * E * kappa;
    Curve curves[2];
    for (const Surface surface : {Surface::parabola, Surface::sphere})
      {
        SolverOptions used = options(kappa, surface);
        used.domain_radius = 200;
        HalfSpaceModel model(weak, scene, used, kappa * R);
        curves[surface == Surface::sphere] = run_cycle(model, 6);
      }
    const double peak = curves[0].loading.back().approach;
    ASSERT_GT(curves[0].residual_approach(), 0.1 * peak);
    for (std::size_t i = 0; i < curves[0].loading.size(); ++i)
      EXPECT_NEAR(curves[1].loading[i].approach, curves[0].loading[i].approach, 1e-6 * peak);
    for (std::size_t i = 0; i < curves[0].unloading.size(); ++i)
      EXPECT_NEAR(curves[1].unloading[i].approach, curves[0].unloading[i].approach, 1e-6 * peak);
  }

  TEST(FiniteRadius, axisymmetric_si_units_change_nothing)
  {
    constexpr double kappa = 0.05;
    const Material   rock  = elastic(0.2);
    SolverOptions    si    = options(kappa, Surface::sphere);
    si.units               = Units::si;
    HalfSpaceModel model(rock, scene_of(rock, kappa), si, kappa * R);
    const double   in_si = run_to_peak(model, 1).back().approach;
    HalfSpaceModel scaled(rock, scene_of(rock, kappa), options(kappa, Surface::sphere), kappa * R);
    EXPECT_NEAR(in_si / run_to_peak(scaled, 1).back().approach, 1, 1e-6);
  }

  TEST(FiniteRadius, a_far_boundary_beyond_the_sphere_is_refused_by_name)
  {
    const Material rock = elastic(0.2);
    const Scene    scene;
    SolverOptions  sphere;
    sphere.surface    = Surface::sphere; // a/R = 0.009: 200 a is almost 2 R
    sphere.resolution = 8;
    expect_refused<InputError>([&] { solve_contact(rock, scene, sphere); }, "domain-radius");
    expect_refused<InputError>([&] { remote_compliance(rock, R, sphere, 0.009 * R); },
                               "domain-radius");
    expect_refused<InputError>([&] { remote_compliance(rock, R, sphere, -1.); }, "mesh_radius");
  }

  TEST(RemoteCompliance, elastic_difference_is_linear_in_the_force_but_for_the_known_logarithm)
  {
    // On one mesh, from the smallest contact that it resolves to the peak. What remains is the mesh
    // (the same contact has fewer elements at a smaller force) and of order (a/R)² of δ.
    for (const double nu : {0.15, 0.3, 0.45})
      for (const double kappa : {0.02, 0.04, 0.08})
        {
          const Material rock   = elastic(nu);
          const auto     sphere = loading(rock, kappa, Surface::sphere);
          const auto     flat   = loading(rock, kappa, Surface::parabola);
          const double   C      = compliance(nu, kappa) / (E * R);
          const double   peak   = flat.back().approach;
          for (std::size_t i = 2; i < flat.size(); ++i)
            {
              ASSERT_NEAR(sphere[i].force / flat[i].force, 1, 1e-9);
              const double share = std::cbrt(flat[i].force / flat.back().force); // a/a_peak
              const double log   = -logarithm(nu) * std::log(share) / (E * R);
              EXPECT_NEAR((sphere[i].approach - flat[i].approach) / peak,
                          (C + log) * flat[i].force / peak,
                          0.1 * kappa * kappa + 4e-3 * kappa)
                << "nu " << nu << " kappa " << kappa << " share " << share;
            }
        }
  }

  TEST(RemoteCompliance, its_dependence_on_the_contact_radius_is_the_closed_form)
  {
    // At fixed D/R, halving a adds c₁ ln 2; the next term is linear in κ and cancels in
    // 2 f(κ/2) − f(κ), where f is the rise from κ to κ/2. 3 % of the rise is the mesh's.
    for (const double nu : {0., 0.15, 0.3})
      {
        const double fine = compliance(nu, 0.01, 40), middle = compliance(nu, 0.02, 40),
                     coarse = compliance(nu, 0.04, 40);
        const double first = fine - middle, second = middle - coarse;
        EXPECT_NEAR((2 * first - second) / (logarithm(nu) * std::log(2.)), 1, 0.03) << "nu " << nu;
      }
  }

  TEST(RemoteCompliance, elastic_curve_without_it_is_within_second_order_of_hertz)
  {
    // ν = 0.45 leaves no logarithm to speak of and 0.01 κ² of δ_peak. For ν = 0.15 the logarithm
    // leaves c₁ F ln(a_peak/a)/(E R), by its closed form 0.015 κ of δ_peak at the most.
    for (const double nu : {0.15, 0.45})
      for (const double kappa : {0.02, 0.04, 0.08})
        {
          const Material rock = elastic(nu);
          Curve          sphere;
          sphere.loading     = loading(rock, kappa, Surface::sphere);
          const double C     = compliance(nu, kappa) / (E * R);
          const auto   clean = remove_linear_compliance(sphere, C).loading;
          const auto   flat  = loading(rock, kappa, Surface::parabola);
          const double peak  = flat.back().approach;
          const double bound = 0.05 * kappa * kappa + (nu < 0.4 ? 0.015 * kappa : 0.);
          for (std::size_t i = 1; i < clean.size(); ++i)
            {
              EXPECT_NEAR(clean[i].approach, flat[i].approach, bound * peak);
              // Hertz itself: 2e-3 is the coarse mesh's.
              EXPECT_NEAR(
                clean[i].approach, hertz::approach(rock, R, clean[i].force), (bound + 2e-3) * peak);
            }
          EXPECT_GT(sphere.loading.back().approach - peak, 10 * bound * peak)
            << "the effect counts";
        }
  }

  TEST(RemoveLinearCompliance, shifts_each_approach_by_its_force_and_nothing_else)
  {
    Curve curve;
    for (const double f : {0., 1., 2.})
      {
        CurvePoint point;
        point.force          = f;
        point.approach       = 10 * f;
        point.contact_radius = 3 * f;
        curve.loading.push_back(point);
      }
    for (const double f : {2., 1., 0.})
      {
        CurvePoint point;
        point.force    = f;
        point.approach = 14 + 3 * f;
        curve.unloading.push_back(point);
      }
    const Curve clean = remove_linear_compliance(curve, 0.5);
    EXPECT_EQ(clean.loading[2].approach, 19.);
    EXPECT_EQ(clean.loading[2].force, 2.);
    EXPECT_EQ(clean.loading[2].contact_radius, 6.);
    EXPECT_EQ(clean.unloading[0].approach, 19.);
    EXPECT_EQ(clean.residual_approach(), 14.);
    EXPECT_EQ(remove_linear_compliance(clean, -0.5).loading[1].approach, 10.);
    expect_refused<InputError>([&] { remove_linear_compliance(curve, 3.); }, "too large");
    expect_refused<InputError>(
      [&] { remove_linear_compliance(curve, std::numeric_limits<double>::quiet_NaN()); },
      "not a number");
  }
} // namespace
