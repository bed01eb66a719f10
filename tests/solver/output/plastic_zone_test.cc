#include "meshing/errors.h"
#include "solver/closed_form/first_yield.h"
#include "solver/output/plastic_zone.h"
#include "solver/path/solution.h"
#include "solver/path/solve.h"
#include "tests/support/floating_point_traps.h"
#include "tests/support/rocks.h"
#include "tests/support/solver_environment.h"

#include <gtest/gtest.h>

namespace
{
  using namespace dpcontact;
  using tests::rock;

  const auto *const traps  = tests::FloatingPointTraps::install();
  const auto *const solver = tests::SolverEnvironment::install();

  SolverOptions coarse()
  {
    SolverOptions options;
    options.resolution    = 16;
    options.loading_steps = 32;
    return options;
  }

  PlasticZone zone_of(const Material &material, const Scene &scene)
  {
    const auto solution = solve_contact(material, scene, coarse());
    EXPECT_TRUE(solution.plastic_zone.has_value());
    // Only what has yielded can be yielding.
    EXPECT_TRUE(solution.flow_zone.has_value());
    if (solution.flow_zone->core)
      {
        EXPECT_LE(solution.flow_zone->core->volume, solution.plastic_zone->core->volume);
      }
    return *solution.plastic_zone;
  }

  TEST(PlasticZone, sandstone_has_a_buried_core_before_its_ring_yields)
  {
    // F_y = 8.3 N on the axis, 42.8 N on the ring.
    const Material sandstone = rock(10, 0.38, 27.8, 10.61);
    const Scene    scene{0.1, 25};
    const auto     yield = first_yield(sandstone, scene.radius);
    ASSERT_LT(yield.force, scene.force_max);
    ASSERT_GT(yield.ring_force, scene.force_max);
    const auto zone = zone_of(sandstone, scene);
    ASSERT_TRUE(zone.core.has_value());
    EXPECT_FALSE(zone.core->surface.has_value());
    EXPECT_GT(zone.core->depth_min, 0);
    EXPECT_FALSE(zone.ring.has_value());
    EXPECT_FALSE(zone.core_reaches_free_surface);
    EXPECT_TRUE(zone.elastic_cap);
    // It lies about the depth at which the axis yields first.
    const double a = zone.contact_radius;
    EXPECT_LT(zone.axis_depth_min, yield.depth_over_contact_radius * a);
    EXPECT_GT(zone.axis_depth_max, yield.depth_over_contact_radius * a);
    EXPECT_GT(zone.axis_depth_min, 0);
    EXPECT_LT(zone.core->radius_max, 1.1 * a);
    EXPECT_EQ(zone.core->radius_min, 0);
  }

  TEST(PlasticZone, ring_alone_where_it_yields_first)
  {
    // F_ring/F_y = 0.188 for ν = 0.1, φ = 40°.
    const Material frictional = rock(10, 0.1, 40, 20);
    const auto     yield      = first_yield(frictional, 0.1);
    const Scene    scene{0.1, 0.9 * yield.force};
    ASSERT_LT(yield.ring_force, scene.force_max);
    const auto zone = zone_of(frictional, scene);
    EXPECT_FALSE(zone.core.has_value());
    EXPECT_TRUE(zone.elastic_cap);
    ASSERT_TRUE(zone.ring.has_value());
    ASSERT_TRUE(zone.ring->surface.has_value());
    EXPECT_LT(zone.ring->surface->radius_min, zone.contact_radius);
    EXPECT_GT(zone.ring->surface->radius_max, zone.contact_radius * 0.99);
    EXPECT_EQ(zone.ring->depth_min, 0);
    EXPECT_LT(zone.ring->depth_max, zone.contact_radius / 2);
  }

  TEST(PlasticZone, core_joins_the_ring_and_an_elastic_cap_stays)
  {
    const auto zone = zone_of(rock(10, 0.38, 27.8, 6.72), {0.1, 400});
    ASSERT_TRUE(zone.core.has_value());
    EXPECT_TRUE(zone.core_reaches_free_surface);
    ASSERT_TRUE(zone.core->surface.has_value());
    EXPECT_GT(zone.core->surface->radius_max, zone.contact_radius);
    EXPECT_TRUE(zone.elastic_cap);
  }

  TEST(PlasticZone, elastic_scene_has_neither)
  {
    SolverOptions  options = coarse();
    const Material hard    = rock(10, 0.2, 30, 1000);
    EXPECT_FALSE(solve_contact(hard, {}, options).plastic_zone.has_value()); // closed form
    options.closed_form = false;
    const auto solution = solve_contact(hard, {}, options);
    ASSERT_TRUE(solution.plastic_zone.has_value());
    const auto &zone = *solution.plastic_zone;
    EXPECT_FALSE(zone.core.has_value());
    EXPECT_FALSE(zone.ring.has_value());
    EXPECT_EQ(zone.ring_parts + zone.other_regions, 0u);
    EXPECT_FALSE(zone.core_reaches_free_surface);
    EXPECT_TRUE(zone.elastic_cap);
    EXPECT_NEAR(zone.contact_radius, solution.curve.loading.back().contact_radius, 1e-9);
  }

  TEST(PlasticZone, volumes_add_up_to_the_curves)
  {
    // Cells are plastic as a whole, points on their own.
    const auto  solution = solve_contact(rock(10, 0.15, 25, 15), {}, coarse());
    const auto &zone     = *solution.plastic_zone;
    ASSERT_TRUE(zone.core.has_value());
    const double cells = zone.core->volume + (zone.ring ? zone.ring->volume : 0);
    EXPECT_NEAR(cells / solution.curve.loading.back().plastic_volume, 1, 0.1);
  }
} // namespace
