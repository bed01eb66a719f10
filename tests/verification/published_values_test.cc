// The paper's two materials against its own finite elements and Hertz, and strongly plastic rows
// against an unpublished computation of others and against GetFEM's.

#include "solver/closed_form/first_yield.h"
#include "tests/support/rocks.h"
#include "tests/support/solver_environment.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

using namespace dpcontact;
using tests::rock;

namespace
{
  const auto *const solver_environment = tests::SolverEnvironment::install();

  const Scene paper_scene{0.1, 100};

  void expect_relative(const double value,
                       const double reference,
                       const double tolerance,
                       const char  *name)
  {
    EXPECT_NEAR(value / reference, 1, tolerance)
      << name << ": " << value << " against " << reference;
  }
} // namespace

// The paper's finite elements, taken back from tables 2 and 4 (eq 19 and its errors), which are
// printed with two to four digits from a coarse mesh: 1.5 %.
TEST(PublishedValues, Type1AgreesWithThePapersFiniteElements)
{
  const tests::Solved type1(rock(10, 0.15, 25, 15), paper_scene);
  expect_relative(type1.fit.published.a, 0.3687, 0.015, "a");
  expect_relative(type1.b(), 1.4710, 0.015, "b");
  expect_relative(type1.fit.published.m, 0.4253, 0.015, "m");
  expect_relative(type1.n(), 1.4701, 0.015, "n");
  // Unpublished finite elements, handed over with the model and stated to about 0.5 %. No command
  // gives them again; GetFEM's rows below have one.
  expect_relative(type1.fit.published.a, 0.3655, 0.005, "a, unpublished");
  expect_relative(type1.b(), 1.4735, 0.005, "b, unpublished");
  expect_relative(type1.fit.published.m, 0.4275, 0.005, "m, unpublished");
  expect_relative(type1.n(), 1.4665, 0.005, "n, unpublished");
}

TEST(PublishedValues, Type2AgreesWithThePapersFiniteElementsAndHertz)
{
  const tests::Solved type2(rock(10, 0.25, 35, 25), paper_scene);
  expect_relative(type2.fit.published.a, 0.3553, 0.015, "a");
  expect_relative(type2.b(), 1.4951, 0.015, "b");
  expect_relative(type2.fit.published.m, 0.3565, 0.015, "m");
  expect_relative(type2.n(), 1.4930, 0.015, "n");
  // Λ = 1.18: the plastic zone is too small to be felt, Hertz holds.
  const double hertz = std::pow(2., -1.5);
  expect_relative(type2.fit.published.a, hertz, 0.003, "a, Hertz");
  expect_relative(type2.b(), 1.5, 0.003, "b, Hertz");
  expect_relative(type2.fit.published.m, hertz, 0.003, "m, Hertz");
  expect_relative(type2.n(), 1.5, 0.003, "n, Hertz");
}

// Accuracies are those that the reference values are stated with.
TEST(StronglyPlasticRows, Lambda392AgreesWithAnIndependentComputation)
{
  const tests::Solved row(rock(10, 0.1, 20, 5), paper_scene);
  expect_relative(row.peak_approach(), 63.7, 0.005, "δ_max/δ_y");
  expect_relative(row.residual_approach(), 27.3, 0.01, "δ_res/δ_y");
  expect_relative(row.a(), 1.17, 0.02, "a");
  expect_relative(row.b(), 1.400, 0.01, "b");
  expect_relative(row.m(), 3.4, 0.02, "m");
  expect_relative(row.n(), 1.32, 0.02, "n");
}

TEST(StronglyPlasticRows, Lambda500Phi40AgreesWithAnIndependentComputation)
{
  const auto          material = rock(10, 0.1, 40, 5);
  const Scene         scene{0.1, 500 * first_yield(material, 0.1).force};
  const tests::Solved row(material, scene);
  expect_relative(row.peak_approach(), 65.4, 0.02, "δ_max/δ_y");
  expect_relative(row.residual_approach(), 9.4, 0.05, "δ_res/δ_y");
  expect_relative(row.a(), 1.04, 0.02, "a");
  expect_relative(row.b(), 1.477, 0.02, "b");
  expect_relative(row.m(), 1.43, 0.05, "m");
  expect_relative(row.n(), 1.455, 0.02, "n");
}

TEST(StronglyPlasticRows, MostPlasticRowAgreesWithAnIndependentComputation)
{
  const tests::Solved row(rock(30, 0.1, 20, 5), paper_scene);
  expect_relative(row.peak_approach(), 314, 0.02, "δ_max/δ_y");
  expect_relative(row.residual_approach(), 183, 0.02, "δ_res/δ_y");
  expect_relative(row.a(), 1.30, 0.05, "a");
  expect_relative(row.b(), 1.375, 0.02, "b");
  expect_relative(row.m(), 8.2, 0.05, "m");
  expect_relative(row.n(), 1.243, 0.02, "n");
}

// tests/verification/getfem_drucker_prager.py: another program, its numbers stored with their
// errors. Ours may be wrong by the accuracy that the defaults promise: 0.3 % of the peak force,
// which a slope dF/dδ ≥ F/δ turns into at most 0.3 % of the approach.
TEST(StronglyPlasticRows, GetfemAgreesWithinTheTwoErrors)
{
  std::ifstream stream(DPCONTACT_SOURCE_DIR "/tests/verification/getfem_results.json");
  ASSERT_TRUE(stream);
  const auto   results = nlohmann::json::parse(stream);
  unsigned int rows    = 0;
  for (const auto &[name, stored] : results.at("cases").items())
    {
      if (!stored.at("estimate").contains("delta_max"))
        continue;
      const auto         &m = stored.at("material");
      const tests::Solved row(rock(m.at("E").get<double>() / 1e9,
                                   m.at("nu"),
                                   m.at("phi"),
                                   m.at("sigma_c").get<double>() / 1e6),
                              {m.at("R"), m.at("F_max")});
      for (const auto &[quantity, ours] : {std::pair{"delta_max", row.peak_approach()},
                                           std::pair{"delta_res", row.residual_approach()}})
        {
          const auto  &theirs = stored.at("estimate").at(quantity);
          const double error  = theirs.at("error").get<double>() + 0.003 * row.peak_approach();
          std::cout << "case " << name << ' ' << quantity << ": " << ours << ", GetFEM "
                    << theirs.at("value") << " ± " << theirs.at("error") << '\n';
          EXPECT_NEAR(ours, theirs.at("value").get<double>(), error) << name << ' ' << quantity;
          // An agreement within errors as large as the number would say nothing.
          EXPECT_LT(error, 0.05 * theirs.at("value").get<double>());
        }
      ++rows;
    }
  EXPECT_EQ(rows, 3u);
}
