#include "solver/closed_form/first_yield.h"
#include "solver/closed_form/hertz.h"
#include "solver/path/runs.h"
#include "tests/support/solver_environment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
  using namespace dpcontact;

  const auto *const environment = tests::SolverEnvironment::install();

  const Material rock{10e9, .15, Angle(25), 15e6};

  Material elastic(const double youngs_modulus, const double poisson_ratio)
  {
    return {youngs_modulus, poisson_ratio, Angle(25), 1e6 * youngs_modulus};
  }

  SolverOptions options(const unsigned int resolution)
  {
    SolverOptions result;
    result.resolution = resolution;
    return result;
  }

  Curve curve_of(const Material &material, const Scene &scene, const unsigned int resolution)
  {
    HalfSpaceModel model(
      material,
      scene,
      options(resolution),
      hertz::contact_radius(scene, hertz::approach(material, scene, scene.force_max)));
    return run_cycle(model, 8);
  }

  double approach(const Material &material, const Scene &scene, const unsigned int resolution)
  {
    return curve_of(material, scene, resolution).loading.back().approach;
  }

  /// Newton's tolerance is 1e-10 of the force, the contact's 1e-6 of the approach.
  constexpr double solved = 2e-6;

  void expect_same(const Curve &a, const Curve &b)
  {
    ASSERT_EQ(a.loading.size(), b.loading.size());
    ASSERT_EQ(a.unloading.size(), b.unloading.size());
    const double largest = a.loading.back().approach;
    for (std::size_t i = 1; i < a.loading.size(); ++i)
      {
        EXPECT_NEAR(a.loading[i].approach, b.loading[i].approach, solved * largest);
        EXPECT_NEAR(a.loading[i].force, b.loading[i].force, 1e-9 * a.loading.back().force);
      }
    for (std::size_t i = 0; i < a.unloading.size(); ++i)
      EXPECT_NEAR(a.unloading[i].approach, b.unloading[i].approach, solved * largest);
    EXPECT_NEAR(
      a.unloading.back().dissipated_energy / b.unloading.back().dissipated_energy, 1, 1e-4);
  }

  TEST(TwoBodies, identical_ones_reproduce_the_half_model)
  {
    const Scene half;
    Scene       both  = half;
    both.second       = SecondBody{half.radius, rock};
    const Curve curve = curve_of(rock, half, 12);
    EXPECT_GT(curve.residual_approach(), .05 * curve.loading.back().approach);
    expect_same(curve, curve_of(rock, both, 12));
    EXPECT_DOUBLE_EQ(first_yield(rock, half).force, first_yield(rock, both).force);
    EXPECT_DOUBLE_EQ(first_yield(rock, half).approach, first_yield(rock, both).approach);
  }

  TEST(TwoBodies, unlike_elastic_spheres_follow_hertz)
  {
    Scene scene;
    scene.second           = SecondBody{scene.radius / 3, elastic(2e9, .3)};
    const Material first   = elastic(10e9, .15);
    const Curve    curve   = curve_of(first, scene, 40);
    const double   hertz   = hertz::approach(first, scene, scene.force_max);
    const double   contact = hertz::contact_radius(scene, hertz);
    EXPECT_NEAR(curve.loading.back().approach / hertz, 1, 2e-3);         // what is asked of it
    EXPECT_NEAR(curve.loading.back().contact_radius / contact, 1, 5e-3); // a fifth of an element
    for (std::size_t i = 0; i + 1 < curve.unloading.size(); ++i)
      {
        const CurvePoint &point = curve.unloading[i];
        EXPECT_NEAR(point.approach / hertz::approach(first, scene, point.force), 1, 5e-3);
      }
    EXPECT_NEAR(curve.residual_approach(), 0, 1e-5 * hertz);
  }

  TEST(TwoBodies, their_order_does_not_matter)
  {
    const Material other{25e9, .3, Angle(35), 12e6};
    Scene          scene, swapped;
    scene.radius   = .1;
    scene.second   = SecondBody{.04, other};
    swapped.radius = .04;
    swapped.second = SecondBody{.1, rock};
    expect_same(curve_of(rock, scene, 12), curve_of(other, swapped, 12));
    const FirstYield one = first_yield(rock, scene), two = first_yield(other, swapped);
    EXPECT_NEAR(one.force / two.force, 1, 1e-14);
    EXPECT_NEAR(one.approach / two.approach, 1, 1e-14);
    EXPECT_NEAR(one.ring_force / two.ring_force, 1, 1e-14);
    EXPECT_NEAR(one.body_force[0] / two.body_force[1], 1, 1e-14);
    EXPECT_DOUBLE_EQ(one.force, std::min(one.body_force[0], one.body_force[1]));
  }

  TEST(TwoBodies, a_stiff_flat_is_a_rigid_one_in_the_limit)
  {
    Scene rigid;
    rigid.second            = SecondBody{};
    const double limit      = approach(rock, rigid, 12);
    double       difference = std::numeric_limits<double>::infinity();
    for (const double ratio : {1e2, 1e3, 1e4})
      {
        Scene scene       = rigid;
        scene.second      = SecondBody{std::numeric_limits<double>::infinity(),
                                  elastic(ratio * rock.youngs_modulus, rock.poisson_ratio)};
        const double next = approach(rock, scene, 12) / limit - 1;
        EXPECT_GT(next, 0) << ratio;
        // The flat's share of the compliance falls like 1/ratio.
        EXPECT_LT(next, .15 * difference) << ratio;
        difference = next;
      }
    EXPECT_LT(difference, 2e-4);
  }
} // namespace
