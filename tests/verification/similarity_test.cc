// Similarity of the small-strain half-space: ν, φ and Λ = F_max/F_y are all that the dimensionless
// curve depends on; E, σc, R and F_max are not.

#include "solver/closed_form/first_yield.h"
#include "tests/support/rocks.h"
#include "tests/support/solver_environment.h"

#include <gtest/gtest.h>

using namespace dpcontact;
using tests::rock;
using tests::Solved;

namespace
{
  const auto *const solver_environment = tests::SolverEnvironment::install();

  const Material   soft = rock(10, 0.2, 30, 6), stiff = rock(35, 0.2, 30, 21);
  constexpr double load_level = 60;

  Scene scene_of(const Material &material, const double radius)
  {
    return {radius, load_level * first_yield(material, radius).force};
  }

  /// a, b, m, n and the peak and residual approaches over δ_y.
  std::vector<double> numbers(const Solved &s)
  {
    return {s.a(), s.b(), s.m(), s.n(), s.peak_approach(), s.residual_approach()};
  }
} // namespace

TEST(Similarity, UnlikeMaterialsOnOneMeshWithOneSetOfStepsAgree)
{
  const auto first  = numbers(Solved(soft, scene_of(soft, 0.1)));
  const auto second = numbers(Solved(stiff, scene_of(stiff, 0.003)));
  // The two problems are the same up to rounding; 1e-4 leaves room for the mesh being fitted to a
  // contact radius that a pilot run gives, whose Newton iterations end at other residuals.
  for (std::size_t i = 0; i < first.size(); ++i)
    EXPECT_NEAR(second[i] / first[i], 1, 1e-4) << "quantity " << i;
}

TEST(Similarity, UnlikeMaterialsOnUnlikeMeshesAndStepsAgreeWithinTheirErrors)
{
  SolverOptions fitted, coarser, stretched, stretched_coarser;
  coarser.resolution           = 14;
  stretched.mesh_stretch       = 1.37;
  stretched.step_tolerance     = 4e-4; // other steps: twice as many
  stretched_coarser            = stretched;
  stretched_coarser.resolution = 14;

  const Solved one(soft, scene_of(soft, 0.1), fitted),
    other(stiff, scene_of(stiff, 0.003), stretched);
  EXPECT_NE(one.solution.cost.steps, other.solution.cost.steps);
  const auto a = numbers(one), b = numbers(other);
  const auto a_coarse = numbers(Solved(soft, scene_of(soft, 0.1), coarser));
  const auto b_coarse = numbers(Solved(stiff, scene_of(stiff, 0.003), stretched_coarser));
  for (std::size_t i = 0; i < a.size(); ++i)
    {
      // Measured: what a coarser mesh changes, and the share of the peak force that the load step
      // leaves, which moves a coefficient by no more than twice that share at this load level.
      const double error = std::abs(a[i] - a_coarse[i]) + std::abs(b[i] - b_coarse[i]) +
                           2 * (one.solution.step_error + other.solution.step_error) * a[i];
      std::cout << "quantity " << i << ": " << a[i] << ' ' << b[i] << " measured error " << error
                << '\n';
      EXPECT_NEAR(a[i], b[i], error) << "quantity " << i;
      EXPECT_LT(error, 0.02 * a[i]) << "an error this large proves nothing, quantity " << i;
    }
}

TEST(Similarity, SolvingInSiUnitsReproducesTheScaledRun)
{
  SolverOptions si;
  si.units          = Units::si;
  const auto scaled = numbers(Solved(soft, scene_of(soft, 0.1)));
  const auto plain  = numbers(Solved(soft, scene_of(soft, 0.1), si));
  for (std::size_t i = 0; i < scaled.size(); ++i)
    EXPECT_NEAR(plain[i] / scaled[i], 1, 1e-6) << "quantity " << i;
}

// A load level of its own gives another curve: the agreement above is no triviality.
TEST(Similarity, AnotherLoadLevelDoesNotAgree)
{
  Scene heavier = scene_of(soft, 0.1);
  heavier.force_max *= 1.5;
  const auto first  = numbers(Solved(soft, scene_of(soft, 0.1))),
             second = numbers(Solved(soft, heavier));
  EXPECT_GT(std::abs(second[2] / first[2] - 1), 0.01); // m
}
