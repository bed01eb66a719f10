#include "database/files/csv.h"
#include "database/rows/comparison.h"
#include "meshing/errors.h"
#include "tests/support/records.h"

#include <set>

using namespace dpcontact;
using namespace dpcontact::testing_database;

namespace
{
  using ComparisonTest = InDirectory;

  /// A converged row of type 1 whose coefficients have stated errors of 0.01 each, of which the
  /// mesh makes 0.004.
  Record row_of_type_1()
  {
    Record row;
    row.input      = {{10e9, 0.15, Angle(25), 15e6}, {}};
    row.status     = "converged";
    row.load_level = 11;
    row.law        = {1.01, 1.47, 1.18, 1.46};
    for (StatedError &error : row.error)
      error = {{0.004, 0, 0, 0, 0.001, 0.005}, 0.01};
    return row;
  }
} // namespace

TEST(Comparison, JudgesByTheSumOfWhatBothRowsState)
{
  const Record one   = row_of_type_1();
  Record       other = one;
  other.law.m += 0.015;
  const auto pairs = compare({{one}, {}}, {{other}, {}});
  ASSERT_EQ(pairs.size(), 1U);
  using Difference          = RowComparison::Difference;
  constexpr double rounding = 2e-12; // compare() allows for 1e-12 of the coefficient
  EXPECT_NEAR(pairs[0].difference[2].numerical, 0.008, rounding);
  EXPECT_NEAR(pairs[0].difference[2].total, 0.02, rounding);
  EXPECT_TRUE(pairs[0].agrees(&Difference::total));
  EXPECT_FALSE(pairs[0].agrees(&Difference::numerical));
  other.law.n += 0.021;
  EXPECT_FALSE(compare({{one}, {}}, {{other}, {}})[0].agrees(&Difference::total));
}

TEST(Comparison, PairsRowsByEveryInput)
{
  const Record one                       = row_of_type_1();
  Record       other                     = one;
  other.input.material.flow_stress_ratio = 0.8;
  EXPECT_NE(message_of<InputError>([&] {
              compare({{one}, {}}, {{other}, {}});
            }).find("is not in the other database"),
            std::string::npos);
  other        = one;
  other.status = "failed";
  EXPECT_NE(message_of<InputError>([&] {
              compare({{one}, {}}, {{other}, {}});
            }).find("has failed"),
            std::string::npos);
}

TEST_F(ComparisonTest, LinesOfTheReportTellRowsApart)
{
  const auto changes = {+[](Material &) {},
                        +[](Material &m) { m.flow_stress_ratio = 0.8; },
                        +[](Material &m) { m.dilation_angle = Angle(10); },
                        +[](Material &m) { m.hardening = 1e6; },
                        +[](Material &m) { m.criterion = Criterion::mohr_coulomb; },
                        +[](Material &m) {
                          m.criterion      = Criterion::mohr_coulomb;
                          m.tension_cutoff = 1e5;
                        }};
  Database   database;
  for (const auto change : changes)
    {
      database.records.push_back(row_of_type_1());
      change(database.records.back().input.material);
    }
  const fs::path file = directory / "report.csv";
  write_csv(file, compare(database, database));
  const CsvTable report(file.string(), slurp(file));
  ASSERT_EQ(report.rows(), changes.size());
  std::set<std::string> inputs;
  for (std::size_t i = 0; i < report.rows(); ++i)
    {
      std::string line;
      for (const schema::Column &column : schema::input_columns())
        line += report.text(column.name, i) + ",";
      EXPECT_TRUE(inputs.insert(line).second) << line;
      EXPECT_EQ(report.number("a_other", i), 1.01);
      EXPECT_EQ(report.text("agrees", i), "yes");
    }
}
