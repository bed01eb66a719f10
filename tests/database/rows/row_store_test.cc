#include "database/files/digest.h"
#include "database/files/files.h"
#include "database/rows/row_json.h"
#include "database/rows/row_store.h"
#include "meshing/errors.h"
#include "tests/support/records.h"

#include <nlohmann/json.hpp>

#include <csignal>
#include <sys/wait.h>
#include <thread>

using namespace dpcontact;
using namespace dpcontact::testing_database;
using nlohmann::json;

namespace
{
  json settings()
  {
    return {{"resolution", 20}, {"step_tolerance", 2e-3}, {"grid", {{"E", {1e10, 2e10}}}}};
  }

  using RowStoreTest = InDirectory;

  /// The reports of a store, one after the other.
  struct Reports
  {
    std::vector<std::string> texts;
    RowStore::Reporter       reporter()
    {
      return [this](const std::string &text) { texts.push_back(text); };
    }
  };
} // namespace

// FIPS 180-2, appendix B.
TEST(Digest, Sha256OfAPublishedMessage)
{
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(RowJson, RoundTripsEveryBitThroughText)
{
  for (std::uint64_t seed = 0; seed < 40; ++seed)
    {
      const Record record = any_record(seed);
      expect_same(record_from_json(json::parse(to_json(record).dump())), record);
    }
}

TEST(RowJson, MakesAnyTextStorable)
{
  EXPECT_EQ(clean_text("δ_y = 3 µm\n"), "δ_y = 3 µm\n");
  EXPECT_EQ(clean_text(std::string("a\0b", 3)),
            "a\xEF\xBF\xBD"
            "b");
  EXPECT_EQ(clean_text("caf\xE9!"), "caf\xEF\xBF\xBD!");
}

TEST(RowJson, NamesWhatIsMissingOrOfTheWrongType)
{
  json row = to_json(any_record(2));
  row.erase("rmse_loading");
  EXPECT_NE(message_of<CorruptData>([&] { record_from_json(row); }).find("rmse_loading"),
            std::string::npos);
  row              = to_json(any_record(2));
  row["criterion"] = "tresca";
  EXPECT_NE(message_of<CorruptData>([&] { record_from_json(row); }).find("'tresca'"),
            std::string::npos);
  row         = to_json(any_record(2));
  row["dofs"] = "many";
  EXPECT_NE(message_of<CorruptData>([&] { record_from_json(row); }).find("dofs"),
            std::string::npos);
  row = to_json(any_record(2));
  row["curve"]["loading"]["force"].erase(0);
  EXPECT_NE(message_of<CorruptData>([&] { record_from_json(row); }).find("force"),
            std::string::npos);
}

TEST_F(RowStoreTest, FindsWhatWasWrittenAfterReopening)
{
  const fs::path database = directory / "table.h5";
  for (std::uint64_t seed = 0; seed < 6; ++seed)
    RowStore(database, settings()).write(any_record(seed));
  const RowStore store(database, settings());
  for (std::uint64_t seed = 0; seed < 6; ++seed)
    {
      const auto found = store.find(any_record(seed).input);
      ASSERT_TRUE(found);
      expect_same(*found, any_record(seed));
    }
  EXPECT_FALSE(store.find(any_record(6).input));
  EXPECT_EQ(json::parse(*RowStore::stored_settings(database)), settings());
}

TEST_F(RowStoreTest, ListsAllRowsAndForgetsThose)
{
  const RowStore store(directory / "table.h5", settings());
  for (std::uint64_t seed = 0; seed < 4; ++seed)
    store.write(any_record(seed));
  EXPECT_EQ(store.all().size(), 4U);
  store.remove(any_record(2).input);
  EXPECT_FALSE(store.find(any_record(2).input));
  EXPECT_EQ(store.all().size(), 3U);
}

TEST_F(RowStoreTest, SettingsAreNotWrittenWhileAnotherProcessHoldsTheLock)
{
  const fs::path database = directory / "table.h5";
  const RowStore store(database, settings());
  const auto     lock = store.lock();
  fs::remove(RowStore::directory_of(database) / "settings.json");
  const pid_t child = ::fork();
  if (child == 0)
    {
      try
        {
          RowStore(database, settings());
        }
      catch (const FileError &error)
        {
          const bool named =
            std::string(error.what()).find(std::to_string(::getppid())) != std::string::npos;
          ::_exit(named ? 1 : 2);
        }
      ::_exit(0);
    }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 1);
  EXPECT_FALSE(RowStore::stored_settings(database));
}

TEST_F(RowStoreTest, ReplacesARowOfTheSameInputs)
{
  const RowStore store(directory / "table.h5", settings());
  Record         record = any_record(3);
  store.write(record);
  record.status = "converged";
  record.reason = "";
  store.write(record);
  expect_same(*store.find(record.input), record);
}

TEST_F(RowStoreTest, OtherSettingsAreRefusedWithBothValuesOfEveryDifference)
{
  const fs::path database = directory / "table.h5";
  RowStore(database, settings());
  json other              = settings();
  other["step_tolerance"] = 1e-3;
  other["grid"]["E"][1]   = 3e10;
  other["level"]          = 1;
  other.erase("resolution");
  const auto before = slurp(RowStore::directory_of(database) / "settings.json");
  for (const bool dry : {true, false})
    {
      const std::string message = message_of<SettingsMismatch>([&] {
        if (dry)
          RowStore::check_settings(database, other);
        else
          RowStore(database, other);
      });
      for (const char *part : {"/settings/step_tolerance: stored 0.002, now 0.001",
                               "/settings/grid/E/1: stored 20000000000.0, now 30000000000.0",
                               "/settings/level: stored (absent), now 1",
                               "/settings/resolution: stored 20, now (absent)"})
        EXPECT_NE(message.find(part), std::string::npos) << message;
      EXPECT_EQ(message.find("/grid/E/0"), std::string::npos) << message;
    }
  EXPECT_EQ(slurp(RowStore::directory_of(database) / "settings.json"), before);
  EXPECT_NO_THROW(RowStore(database, settings()));
}

TEST_F(RowStoreTest, CheckingSettingsCreatesNothing)
{
  EXPECT_NO_THROW(RowStore::check_settings(directory / "table.h5", settings()));
  EXPECT_FALSE(RowStore::stored_settings(directory / "table.h5"));
  EXPECT_TRUE(fs::is_empty(directory));
}

TEST_F(RowStoreTest, DamagedSettingsAreRefused)
{
  const fs::path database = directory / "table.h5";
  RowStore(database, settings());
  const fs::path file = RowStore::directory_of(database) / "settings.json";
  std::string    text = slurp(file);
  text.replace(text.find("20"), 2, "21");
  spill(file, text);
  EXPECT_THROW(RowStore(database, settings()), CorruptData);
}

TEST_F(RowStoreTest, AnyDamageSetsTheRowAsideAndReportsIt)
{
  const fs::path  database = directory / "table.h5";
  Reports         reports;
  const RowStore  store(database, settings(), reports.reporter());
  const Record    record = any_record(4, 2);
  const fs::path  file   = store.path_of(record.input);
  std::mt19937_64 generator(7);
  store.write(record);
  const std::string whole = slurp(file);

  std::vector<std::string> damaged = {
    "", "{}", whole.substr(0, whole.size() / 2), whole.substr(0, whole.size() - 1), whole + " "};
  for (int i = 0; i < 60; ++i)
    {
      std::string text = whole;
      auto       &byte = text[generator() % text.size()];
      byte             = static_cast<char>(byte ^ (1 << generator() % 8));
      damaged.push_back(text);
    }
  for (const auto &text : damaged)
    {
      reports.texts.clear();
      spill(file, text);
      EXPECT_FALSE(store.find(record.input));
      ASSERT_EQ(reports.texts.size(), 1U);
      EXPECT_NE(reports.texts[0].find(file.string()), std::string::npos);
      EXPECT_FALSE(fs::exists(file));
    }
  std::size_t kept = 0;
  for (const auto &entry : fs::directory_iterator(RowStore::directory_of(database)))
    kept += entry.path().string().find(".damaged") != std::string::npos;
  EXPECT_EQ(kept, damaged.size());
  store.write(record);
  EXPECT_TRUE(store.find(record.input));
}

TEST_F(RowStoreTest, ARowUnderAnotherRowsNameIsNotTaken)
{
  Reports        reports;
  const RowStore store(directory / "table.h5", settings(), reports.reporter());
  store.write(any_record(1));
  fs::copy(store.path_of(any_record(1).input), store.path_of(any_record(2).input));
  EXPECT_FALSE(store.find(any_record(2).input));
  EXPECT_EQ(reports.texts.size(), 1U);
}

TEST_F(RowStoreTest, LeftoversOfKilledWritesAreIgnoredAndRemovedByTheNextSweep)
{
  Reports        reports;
  const fs::path database = directory / "table.h5";
  const RowStore store(database, settings(), reports.reporter());
  store.write(any_record(1));
  const fs::path among =
    store.path_of(any_record(2).input).parent_path() /
    ("." + store.path_of(any_record(2).input).filename().string() + ".0123456789abcdef.tmp");
  const fs::path beside = directory / ".table.h5.0123456789abcdef.tmp";
  const fs::path others = directory / ".table.h5.csv.0123456789abcdef.tmp";
  for (const auto &file : {among, beside, others})
    spill(file, "{\"content\": {\"E_Pa\": 1e1");
  EXPECT_FALSE(store.find(any_record(2).input));
  expect_same(*store.find(any_record(1).input), any_record(1));
  EXPECT_TRUE(reports.texts.empty());

  const auto lock = store.lock();
  EXPECT_FALSE(fs::exists(among));
  EXPECT_FALSE(fs::exists(beside));
  EXPECT_TRUE(fs::exists(others));
  EXPECT_TRUE(store.find(any_record(1).input));
}

TEST_F(RowStoreTest, ASecondProcessCannotLock)
{
  const RowStore store(directory / "table.h5", settings());
  const auto     try_in_child = [&] {
    const pid_t child = ::fork();
    if (child == 0)
      {
        try
          {
            const auto lock = store.lock();
            ::_exit(0);
          }
        catch (const FileError &error)
          {
            const bool named =
              std::string(error.what()).find(std::to_string(::getppid())) != std::string::npos;
            ::_exit(named ? 1 : 2);
          }
      }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WEXITSTATUS(status);
  };
  {
    const auto lock = store.lock();
    EXPECT_EQ(try_in_child(), 1);
  }
  EXPECT_EQ(try_in_child(), 0);
}

// Whenever the writer dies, every row is absent, old or new, and never reported as damaged.
TEST_F(RowStoreTest, KilledWritersLeaveOnlyWholeRows)
{
  const fs::path  database = directory / "table.h5";
  std::mt19937_64 generator(11);
  for (int round = 0; round < 8; ++round)
    {
      RowStore(database, settings()); // so that the child may die before it opens the store
      const pid_t child = ::fork();
      if (child == 0)
        {
          const RowStore store(database, settings());
          for (std::uint64_t i = 0;; ++i)
            store.write(any_record(i % 5, 200));
        }
      std::this_thread::sleep_for(std::chrono::microseconds(2000 + generator() % 60000));
      ::kill(child, SIGKILL);
      ::waitpid(child, nullptr, 0);

      Reports        reports;
      const RowStore store(database, settings(), reports.reporter());
      for (std::uint64_t seed = 0; seed < 5; ++seed)
        if (const auto found = store.find(any_record(seed).input))
          expect_same(*found, any_record(seed, 200));
      EXPECT_TRUE(reports.texts.empty());
    }
}

// A path below a regular file cannot be written even by the superuser.
TEST_F(RowStoreTest, UnwritablePlacesAreFileErrors)
{
  spill(directory / "file", "");
  EXPECT_THROW(RowStore(directory / "file" / "table.h5", settings()), FileError);
  EXPECT_THROW(RowStore(directory / "absent" / "table.h5", settings()), FileError);
  spill(directory / "taken.h5.rows", "not a directory");
  EXPECT_THROW(RowStore(directory / "taken.h5", settings()), FileError);
  EXPECT_EQ(slurp(directory / "taken.h5.rows"), "not a directory");
  EXPECT_THROW(write_file(directory / "file" / "x", "x"), FileError);
  EXPECT_THROW(read_file(directory / "absent"), FileError);
}
