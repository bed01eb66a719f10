#include "solver/closed_form/hertz.h"
#include "solver/path/solution.h"
#include "solver/path/solve.h"
#include "tests/support/floating_point_traps.h"
#include "tests/support/solver_environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace
{
  using namespace dpcontact;

  const auto *const traps  = tests::FloatingPointTraps::install();
  const auto *const solver = tests::SolverEnvironment::install();

  /// Two elastic spheres of R = 0.1 m under 100 N at the default options. The bounds are the
  /// accuracy that the program promises for an elastic scene.
  class ElasticSpheres : public ::testing::TestWithParam<double>
  {
  protected:
    static Material material(const double nu) { return {10e9, nu, Angle(30), 1e15}; }

    // One computation a Poisson's ratio, for all tests.
    static const Solution &solution(const double nu)
    {
      static std::map<double, Solution> computed;
      auto                              found = computed.find(nu);
      if (found == computed.end())
        found = computed.emplace(nu, solve_contact(material(nu), scene, options)).first;
      return found->second;
    }

    static constexpr Scene scene{};
    static SolverOptions   by_elements()
    {
      SolverOptions result;
      result.closed_form = false;
      return result;
    }
    static const inline SolverOptions options = by_elements();

    const double    nu            = GetParam();
    const Material  rock          = material(nu);
    const Solution &result        = solution(nu);
    const double    peak_approach = hertz::approach(rock, scene.radius, scene.force_max);
    const double    peak_radius   = hertz::contact_radius(scene.radius, peak_approach);
    const double    peak_pressure = hertz::peak_pressure(scene.force_max, peak_radius);
  };

  TEST_P(ElasticSpheres, axisymmetric_force_follows_hertz)
  {
    unsigned int judged = 0;
    for (const auto *branch : {&result.curve.loading, &result.curve.unloading})
      for (const auto &point : *branch)
        if (point.force >= 0.1 * scene.force_max)
          {
            ++judged;
            const double expected = hertz::force(rock, scene.radius, point.approach);
            EXPECT_NEAR(point.force / expected, 1, 1e-3) << "at " << point.force << " N";
          }
    EXPECT_GE(judged, 20u);
    EXPECT_NEAR(result.curve.loading.back().force / scene.force_max, 1, 1e-6);
  }

  TEST_P(ElasticSpheres, axisymmetric_contact_radius_is_within_an_element_of_hertz)
  {
    const double element = peak_radius / options.resolution;
    for (const auto *branch : {&result.curve.loading, &result.curve.unloading})
      for (const auto &point : *branch)
        if (point.force >= 0.1 * scene.force_max)
          {
            const double expected =
              hertz::contact_radius(scene.radius, hertz::approach(rock, scene.radius, point.force));
            EXPECT_NEAR(point.contact_radius, expected, element) << "at " << point.force << " N";
          }
  }

  TEST_P(ElasticSpheres, axisymmetric_pressure_follows_hertz_away_from_the_edge)
  {
    unsigned int judged = 0;
    for (const auto &[radius, pressure] : result.peak_profile)
      if (radius < 0.9 * peak_radius)
        {
          ++judged;
          const double x = radius / peak_radius;
          EXPECT_NEAR(pressure / (peak_pressure * std::sqrt(1 - x * x)), 1, 0.01)
            << "at r/a = " << x;
        }
    EXPECT_GE(judged, options.resolution / 2);
  }

  TEST_P(ElasticSpheres, axisymmetric_stresses_on_the_axis_follow_hertz)
  {
    // Wang et al. 2018, eq (8); Johnson, Contact Mechanics, 1985, eq 3.45.
    unsigned int judged = 0;
    for (const auto &[depth, axial, radial] : result.peak_axis)
      {
        const double u            = depth / peak_radius;
        const double shape        = 1 / (1 + u * u);
        const double t            = u > 0 ? u * std::atan(1 / u) : 0;
        const double hertz_axial  = -shape;
        const double hertz_radial = -(1 + nu) * (1 - t) + shape / 2;
        judged += u < 5 ? 1u : 0u;
        EXPECT_NEAR(axial / peak_pressure, hertz_axial, 0.01) << "at z/a = " << u;
        EXPECT_NEAR(radial / peak_pressure, hertz_radial, 0.01) << "at z/a = " << u;
      }
    EXPECT_GE(judged, options.resolution / 2);
  }

  TEST_P(ElasticSpheres, axisymmetric_release_leaves_nothing_behind)
  {
    const auto &end = result.curve.unloading.back();
    EXPECT_EQ(end.force, 0.);
    // A node beside the axis separates last: its undeformed gap, (h/a)²/2 of δ, is what it may
    // leave.
    EXPECT_NEAR(end.approach / peak_approach, 0, 1e-6);
    EXPECT_EQ(end.plastic_strain_max, 0.);
    EXPECT_EQ(end.dissipated_energy, 0.);
    EXPECT_EQ(result.apex_points, 0u);
    for (const std::string &warning : result.warnings)
      EXPECT_EQ(warning.find("small strain"), std::string::npos) << warning;
  }

  INSTANTIATE_TEST_SUITE_P(poisson_ratios, ElasticSpheres, ::testing::Values(0.1, 0.3));
} // namespace
