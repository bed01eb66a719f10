#include "database/rows/row.h"
#include "database/rows/uncertainty.h"
#include "fitting/curve_fit.h"
#include "solver/path/elastic_solution.h"
#include "solver/path/solution.h"
#include "tests/support/records.h"

#include <cmath>

using namespace dpcontact;
using namespace dpcontact::testing_database;

namespace
{
  /// So strong that nothing yields under 100 N.
  const Case strong{{10e9, 0.2, Angle(30), 1e9}, {}};

  Solution hertz_of(const Case &input) { return elastic_solution(input.material, input.scene, 64); }
} // namespace

TEST(Row, OfAnElasticCaseIsHertz)
{
  const Record row = row_of(strong, hertz_of(strong));
  EXPECT_TRUE(row.input == strong);
  EXPECT_TRUE(row.converged());
  // The curve is sampled and fitted: 1e-4 is what 64 points leave.
  EXPECT_NEAR(row.law.a, 1, 1e-4);
  EXPECT_NEAR(row.law.b, 1.5, 1e-4);
  EXPECT_NEAR(row.law.m, 1, 1e-4);
  EXPECT_NEAR(row.law.n, 1.5, 1e-4);
  EXPECT_NEAR(row.fit.published.a, row.law.a * std::exp2(-row.law.b), 1e-12);
  EXPECT_EQ(row.fit.published.approach_yield, row.yield.approach / 2);
  EXPECT_EQ(row.load_level, 100 / row.yield.force);
  EXPECT_EQ(row.state.approach_residual, 0);
  EXPECT_EQ(row.cost.dofs, 0U);
  for (const StatedError &error : row.error)
    {
      EXPECT_EQ(error.parts.mesh, 0); // closed form
      EXPECT_EQ(error.total, error.parts.total());
    }
}

TEST(Row, RefitsItsOwnCurveAndKeepsTheOtherErrors)
{
  const Record row   = row_of(strong, hertz_of(strong));
  Record       again = row;
  for (StatedError &error : again.error)
    {
      error.parts.mesh = 0.25;
      error.total      = error.parts.total();
    }
  again.law = {};
  fit_row(again);
  for (std::size_t c = 0; c < coefficient_names.size(); ++c)
    {
      EXPECT_EQ(again.law[c], row.law[c]) << coefficient_names[c];
      EXPECT_EQ(again.error[c].parts.mesh, 0.25);
      EXPECT_EQ(again.error[c].parts.fit, row.error[c].parts.fit);
      EXPECT_NEAR(again.error[c].total, row.error[c].total + 0.25, 1e-12);
    }
}

TEST(Row, OfAFailureHasItsReasonOnOneLine)
{
  const Record row = failed_row(strong, "no\n\n  equilibrium\tfound ");
  EXPECT_EQ(row.status, "failed");
  EXPECT_EQ(row.reason, "no equilibrium found");
  EXPECT_TRUE(std::isfinite(row.yield.force));
  EXPECT_TRUE(std::isnan(row.law.a));
  EXPECT_TRUE(row.curve.loading.empty());
}
