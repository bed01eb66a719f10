#include "database/rows/identity.h"
#include "database/rows/row_store.h"
#include "database/rows/store.h"
#include "meshing/errors.h"
#include "runs/sweep/assembly.h"
#include "runs/sweep/merge.h"
#include "tests/support/records.h"

#include <nlohmann/json.hpp>

using namespace dpcontact;
using namespace dpcontact::testing_database;

namespace
{
  /// A grid of four strengths, and shards of it that hold made-up rows.
  class MergeTest : public InDirectory
  {
  protected:
    MergeTest()
    {
      for (const double strength : {5e6, 10e6, 15e6, 20e6})
        sweep.cases.push_back({{10e9, 0.2, Angle(30), strength}, {}});
      sweep.database = directory / "grid.h5";
    }

    /// A row directory with a row for each of these cases.
    fs::path shard(const std::string &name, const std::vector<std::size_t> &cases) const
    {
      const fs::path database = directory / (name + ".h5");
      const RowStore rows(database, row_settings(sweep));
      for (const std::size_t i : cases)
        rows.write(row(i));
      return RowStore::directory_of(database);
    }

    Record row(const std::size_t i) const
    {
      Record record   = any_record(2 * i);
      record.input    = sweep.cases[i];
      record.status   = "converged";
      record.reason   = "";
      record.warnings = "";
      return record;
    }

    /// The same settings, and other strengths.
    Sweep other_sweep(const std::vector<double> &strengths) const
    {
      Sweep other = sweep;
      other.cases.clear();
      for (const double strength : strengths)
        other.cases.push_back({{10e9, 0.2, Angle(30), strength}, {}});
      return other;
    }

    /// Assembles the database of a grid, whose rows are made up.
    Assembled assemble(const Sweep &grid) const
    {
      const RowStore rows(grid.database, row_settings(grid));
      take_up_rows(grid, rows);
      for (std::size_t i = 0; i < grid.cases.size(); ++i)
        if (!rows.find(grid.cases[i]))
          {
            Record record = row(0);
            record.input  = grid.cases[i];
            rows.write(record);
          }
      return assemble_database(grid, rows);
    }

    std::vector<double> strengths_stored() const
    {
      std::vector<double> strengths;
      for (const Record &record : read_store(sweep.database).records)
        strengths.push_back(record.input.material.compressive_strength);
      return strengths;
    }

    Sweep sweep;
  };

  const std::vector<double> own{5e6, 10e6, 15e6, 20e6};

  std::vector<double> joined(std::vector<double> first, const std::vector<double> &second)
  {
    first.insert(first.end(), second.begin(), second.end());
    return first;
  }
} // namespace

TEST_F(MergeTest, ASweepOfAnotherGridKeepsTheRowsThatWereThere)
{
  EXPECT_EQ(assemble(sweep).kept, 0U);
  const Database before = read_store(sweep.database);
  const Sweep    other  = other_sweep({40e6, 10e6});
  EXPECT_EQ(assemble(other).kept, 3U);
  EXPECT_EQ(strengths_stored(), (std::vector<double>{40e6, 10e6, 5e6, 15e6, 20e6}));
  expect_same(read_store(sweep.database).records[1], before.records[1]);
  expect_same(read_store(sweep.database).records[4], before.records[3]);
  EXPECT_EQ(read_store(sweep.database).provenance.at("rows"), "5");
  EXPECT_FALSE(assemble(other).written) << "the same again";
}

TEST_F(MergeTest, NothingIsLostWithTheRowDirectory)
{
  assemble(sweep);
  const Database before = read_store(sweep.database);
  fs::remove_all(RowStore::directory_of(sweep.database));
  assemble(other_sweep({40e6}));
  EXPECT_EQ(strengths_stored(), joined({40e6}, own));
  fs::remove_all(RowStore::directory_of(sweep.database));
  EXPECT_EQ(assemble(sweep).kept, 1U);
  EXPECT_EQ(strengths_stored(), joined(own, {40e6}));
  for (std::size_t i = 0; i < own.size(); ++i)
    expect_same(read_store(sweep.database).records[i], before.records[i]);
}

TEST_F(MergeTest, OtherRowsAreDroppedWhereThatIsAskedFor)
{
  assemble(sweep);
  Sweep other      = other_sweep({40e6});
  other.other_rows = OtherRows::drop;
  assemble(other);
  EXPECT_EQ(strengths_stored(), std::vector<double>{40e6});
  other.other_rows = OtherRows::keep;
  assemble(other);
  EXPECT_EQ(strengths_stored(), std::vector<double>{40e6});
}

TEST_F(MergeTest, ADatabaseOfOtherSettingsBesideTheRowsIsRefused)
{
  assemble(sweep);
  Sweep finer             = sweep;
  finer.solver.resolution = 60;
  finer.database          = directory / "finer.h5";
  assemble(finer);
  for (const char *ending : {"", ".sha256"})
    fs::copy_file(finer.database.string() + ending,
                  sweep.database.string() + ending,
                  fs::copy_options::overwrite_existing);
  EXPECT_THROW(check_database(sweep), SettingsMismatch);
}

TEST_F(MergeTest, KeepsRowsOfOtherGrids)
{
  assemble(other_sweep({40e6, 50e6}));
  fs::remove_all(RowStore::directory_of(sweep.database));
  const MergeSummary summary = merge_shards(sweep, {shard("one", {3, 0}), shard("two", {1, 2})});
  EXPECT_EQ(summary.kept, 2U);
  EXPECT_EQ(summary.converged, 4U);
  EXPECT_EQ(strengths_stored(), joined(own, {40e6, 50e6}));
}

TEST_F(MergeTest, BringsTheRowsOfShardsTogetherInTheOrderOfTheGrid)
{
  const MergeSummary summary = merge_shards(sweep, {shard("one", {3, 0}), shard("two", {1, 2, 3})});
  EXPECT_EQ(summary.rows, 4U);
  EXPECT_EQ(summary.converged, 4U);
  EXPECT_EQ(summary.duplicates, 1U);
  const Database merged = read_store(sweep.database);
  ASSERT_EQ(merged.records.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i)
    expect_same(merged.records[i], row(i));
}

TEST_F(MergeTest, NamesTheRowsThatAreMissing)
{
  try
    {
      merge_shards(sweep, {shard("one", {0, 1}), shard("two", {3})});
      ADD_FAILURE() << "a grid with a gap was merged";
    }
  catch (const Error &error)
    {
      EXPECT_EQ(error.code(), ExitCode::incomplete);
      EXPECT_NE(std::string(error.what()).find(label(sweep.cases[2])), std::string::npos);
    }
  EXPECT_FALSE(fs::exists(sweep.database));
}

TEST_F(MergeTest, RefusesRowsThatContradictEachOther)
{
  const fs::path one = shard("one", {0, 1, 2, 3}), two = shard("two", {1});
  Record         other = row(1);
  other.law.m          = 12.5;
  RowStore(directory / "two.h5", row_settings(sweep)).write(other);
  EXPECT_NE(message_of<CorruptData>([&] {
              merge_shards(sweep, {one, two});
            }).find("m: "),
            std::string::npos);
  EXPECT_FALSE(fs::exists(sweep.database));
}

TEST_F(MergeTest, AConvergedRowStandsAboveAFailedOne)
{
  const fs::path one = shard("one", {0, 1, 2, 3}), two = shard("two", {1});
  Record         failed = row(1);
  failed.status         = "failed";
  failed.reason         = "killed";
  RowStore(directory / "two.h5", row_settings(sweep)).write(failed);
  EXPECT_EQ(merge_shards(sweep, {two, one}).converged, 4U);
}

TEST_F(MergeTest, RefusesRowsOfAnotherGridAndOfOtherSettings)
{
  const fs::path whole = shard("whole", {0, 1, 2, 3});
  Sweep          fewer = sweep;
  fewer.cases.pop_back();
  EXPECT_THROW(merge_shards(fewer, {whole}), SettingsMismatch);
  Sweep finer             = sweep;
  finer.solver.resolution = 60;
  EXPECT_NE(message_of<SettingsMismatch>([&] { merge_shards(finer, {whole}); }).find("resolution"),
            std::string::npos);
}
