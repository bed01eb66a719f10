// The far boundary follows Boussinesq's field; doubling its distance measures what that leaves.

#include "solver/path/solution.h"
#include "solver/path/solve.h"
#include "tests/support/rocks.h"
#include "tests/support/solver_environment.h"

#include <gtest/gtest.h>

using namespace dpcontact;

namespace
{
  const auto *const solver_environment = tests::SolverEnvironment::install();
}

TEST(FarBoundary, DoublingTheDomainMovesTheMostPlasticRowByLessThanOneInTwoThousand)
{
  const auto    material = tests::rock(30, 0.1, 20, 5);
  const Scene   scene{0.1, 100};
  SolverOptions standard, doubled;
  // Equal steps in both, and no more than needed: the difference of the two is looked at.
  standard.step_tolerance = doubled.step_tolerance = 0.02;
  doubled.domain_radius                            = 2 * standard.domain_radius;
  const auto   near                                = solve_contact(material, scene, standard).curve;
  const auto   far                                 = solve_contact(material, scene, doubled).curve;
  const double peak                                = far.loading.back().approach;
  const double at_peak  = std::abs(near.loading.back().approach - peak) / peak;
  const double released = std::abs(near.residual_approach() - far.residual_approach()) / peak;
  std::cout << "change over δ_max: at the peak " << at_peak << ", after release " << released
            << '\n';
  EXPECT_LT(at_peak, 5e-4);
  EXPECT_LT(released, 5e-4);
}
