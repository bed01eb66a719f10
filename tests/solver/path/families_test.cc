#include "meshing/errors.h"
#include "solver/closed_form/hertz.h"
#include "solver/path/families.h"
#include "solver/path/solution.h"
#include "solver/path/solve.h"
#include "tests/support/floating_point_traps.h"
#include "tests/support/solver_environment.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace dpcontact;

  const auto *const traps  = tests::FloatingPointTraps::install();
  const auto *const solver = tests::SolverEnvironment::install();

  Case member(const double E, const double sigma_c, const double R, const double force)
  {
    Case result;
    result.material = {E, 0.2, Angle(30), sigma_c};
    result.scene    = {R, force};
    return result;
  }

  SolverOptions coarse()
  {
    SolverOptions options;
    options.resolution = 10;
    return options;
  }

  TEST(Families, drucker_prager_members_are_what_they_are_alone)
  {
    // Three load levels, the second from other E, σc, R and force than the others; two paths, as
    // the first level is below a sixth of the last.
    const std::vector<Case> members = {
      member(10e9, 20e6, 0.1, 100), member(20e9, 10e6, 0.05, 10), member(10e9, 5e6, 0.1, 100)};
    const auto found = solve_family(members, coarse());
    ASSERT_EQ(found.size(), members.size());
    for (std::size_t i = 0; i < members.size(); ++i)
      {
        const auto alone = solve_contact(members[i].material, members[i].scene, coarse());
        EXPECT_EQ(found[i].yield.force, alone.yield.force);
        const auto &peak = found[i].curve.loading.back(), &expected = alone.curve.loading.back();
        EXPECT_NEAR(peak.force, members[i].scene.force_max, 1e-6 * members[i].scene.force_max);
        // 10 elements across the contact leave an edge between nodes 0.3 % of the approach.
        EXPECT_NEAR(peak.approach, expected.approach, 4e-3 * expected.approach) << i;
        EXPECT_NEAR(found[i].curve.residual_approach(),
                    alone.curve.residual_approach(),
                    4e-3 * expected.approach)
          << i;
        EXPECT_NEAR(peak.pressure_max, expected.pressure_max, 0.1 * expected.pressure_max) << i;
        const auto &end          = found[i].curve.unloading.back(),
                   &expected_end = alone.curve.unloading.back();
        EXPECT_NEAR(end.dissipated_energy,
                    expected_end.dissipated_energy,
                    0.05 * expected_end.dissipated_energy);
        EXPECT_GT(found[i].cost.newton_iterations, 0u);
      }
  }

  TEST(Families, elastic_members_are_hertz)
  {
    const auto elastic = member(10e9, 1e9, 0.1, 100);
    const auto found   = solve_family({elastic, member(10e9, 20e6, 0.1, 100)}, coarse());
    EXPECT_EQ(found[0].cost.dofs, 0u);
    for (const auto &point : found[0].curve.loading)
      EXPECT_NEAR(point.force, hertz::force(elastic.material, 0.1, point.approach), 1e-12 * 100);
    EXPECT_EQ(found[0].curve.residual_approach(), 0);
    EXPECT_GT(found[1].curve.residual_approach(), 0);
  }

  TEST(Families, members_of_other_families_are_refused)
  {
    auto other                   = member(10e9, 20e6, 0.1, 100);
    other.material.poisson_ratio = 0.25;
    EXPECT_THROW(solve_family({member(10e9, 20e6, 0.1, 100), other}, coarse()), InputError);
    auto published = coarse();
    published.mesh = MeshKind::published;
    EXPECT_THROW(solve_family({member(10e9, 20e6, 0.1, 100)}, published), InputError);
  }
} // namespace
