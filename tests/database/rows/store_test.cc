#include "database/files/digest.h"
#include "database/rows/store.h"
#include "meshing/errors.h"
#include "tests/support/faults.h"
#include "tests/support/records.h"

#include <cerrno>
#include <csignal>
#include <sys/wait.h>
#include <thread>

using namespace dpcontact;
using namespace dpcontact::testing_database;

namespace
{
  using StoreTest = InDirectory;

  Database any_database(const std::size_t size, const std::size_t points = 7)
  {
    Database database;
    for (std::size_t i = 0; i < size; ++i)
      database.records.push_back(any_record(i, points));
    database.provenance = {{"git_revision", "0123abc"},
                           {"input", std::string(100000, 'x') + "\nφ = 20°\n"},
                           {"empty", ""}};
    return database;
  }

  void expect_same(const Database &x, const Database &y)
  {
    EXPECT_EQ(x.provenance, y.provenance);
    ASSERT_EQ(x.records.size(), y.records.size());
    for (std::size_t i = 0; i < x.records.size(); ++i)
      testing_database::expect_same(x.records[i], y.records[i]);
  }

  /// As a user would who wants the altered file accepted.
  void renew_digest(const fs::path &file)
  {
    spill(digest_path_of(file), sha256_of_file(file) + "  " + file.filename().string() + "\n");
  }
} // namespace

TEST_F(StoreTest, RoundTripsEveryBit)
{
  const fs::path file = directory / "table.h5";
  for (const std::size_t size : {0, 1, 12})
    {
      const Database database = any_database(size);
      write_store(file, database);
      expect_same(read_store(file), database);
    }
}

TEST_F(StoreTest, AFailedRowWithoutACurveIsKept)
{
  Database database;
  database.records.push_back(any_record(1, 0));
  database.records.push_back(any_record(2));
  write_store(directory / "table.h5", database);
  expect_same(read_store(directory / "table.h5"), database);
}

TEST_F(StoreTest, EqualContentGivesEqualBytesAndSha256sumAgrees)
{
  write_store(directory / "one.h5", any_database(5));
  write_store(directory / "two.h5", any_database(5));
  EXPECT_EQ(slurp(directory / "one.h5"), slurp(directory / "two.h5"));
  const std::string command =
    "cd '" + directory.string() + "' && sha256sum --status -c one.h5.sha256 two.h5.sha256";
  EXPECT_EQ(std::system(command.c_str()), 0);
  for (const auto &entry : fs::directory_iterator(directory))
    EXPECT_NE(entry.path().extension(), ".tmp");
}

TEST_F(StoreTest, TruncationAndAlteredBytesAreCorruptData)
{
  const fs::path file = directory / "table.h5";
  write_store(file, any_database(3));
  const std::string whole = slurp(file);
  std::mt19937_64   generator(5);
  for (int i = 0; i < 40; ++i)
    {
      std::string text = whole;
      auto       &byte = text[generator() % text.size()];
      byte             = static_cast<char>(byte ^ (1 << generator() % 8));
      spill(file, text);
      EXPECT_NE(message_of<CorruptData>([&] { read_store(file); }).find(file.string()),
                std::string::npos);
      spill(file, whole.substr(0, generator() % whole.size()));
      EXPECT_THROW(read_store(file), CorruptData);
    }
  spill(file, "");
  EXPECT_THROW(read_store(file), CorruptData);
  spill(file, whole);
  EXPECT_NO_THROW(read_store(file));
}

TEST_F(StoreTest, AMissingOrDamagedDigestIsCorruptData)
{
  const fs::path file = directory / "table.h5";
  write_store(file, any_database(1));
  const std::string digest = slurp(digest_path_of(file));
  for (const std::string &text :
       {std::string(), digest.substr(0, 30), digest.substr(1), "z" + digest.substr(1)})
    {
      spill(digest_path_of(file), text);
      EXPECT_THROW(read_store(file), CorruptData) << text;
    }
  fs::remove(digest_path_of(file));
  EXPECT_NE(message_of<CorruptData>([&] { read_store(file); }).find("missing"), std::string::npos);
}

TEST_F(StoreTest, ForeignFilesWithARightDigestAreCorruptData)
{
  const fs::path file = directory / "table.h5";
  write_store(file, any_database(2));
  const std::string whole = slurp(file);
  for (const std::string &text :
       {std::string(), std::string("# a text file\n"), whole.substr(0, whole.size() - 100)})
    {
      spill(file, text);
      renew_digest(file);
      EXPECT_THROW(read_store(file), CorruptData);
    }
}

// HDF5's own checksum guards what the digest cannot: an alteration that was signed.
TEST_F(StoreTest, AnAlteredNumberWithARightDigestIsCorruptData)
{
  const fs::path file                   = directory / "table.h5";
  Database       database               = any_database(2);
  database.records[0].cost.wall_seconds = 12345.6789;
  write_store(file, database);
  std::string text = slurp(file);
  std::string bytes(sizeof(double), '\0');
  std::memcpy(bytes.data(), &database.records[0].cost.wall_seconds, sizeof(double));
  const auto at = text.find(bytes);
  ASSERT_NE(at, std::string::npos);
  text[at] = static_cast<char>(text[at] ^ 1);
  spill(file, text);
  renew_digest(file);
  EXPECT_NE(message_of<CorruptData>([&] { read_store(file); }).find("wall_seconds"),
            std::string::npos);
}

TEST_F(StoreTest, FilesThatAreMissingOrCannotBeWrittenAreFileErrors)
{
  EXPECT_THROW(read_store(directory / "absent.h5"), FileError);
  spill(directory / "file", "untouched");
  EXPECT_THROW(write_store(directory / "file" / "table.h5", any_database(1)), FileError);
  EXPECT_EQ(slurp(directory / "file"), "untouched");

  fs::create_directory(directory / "taken.h5");
  EXPECT_THROW(write_store(directory / "taken.h5", any_database(1)), FileError);
  EXPECT_TRUE(fs::is_directory(directory / "taken.h5"));
  EXPECT_FALSE(fs::exists(directory / "taken.h5.sha256"));
  std::size_t entries = 0;
  for (const auto &entry : fs::directory_iterator(directory))
    entries += entry.exists();
  EXPECT_EQ(entries, 2U); // the file, the directory, and nothing temporary
}

// Whenever the writer dies, a reader gets one of the two databases, never a refusal.
TEST_F(StoreTest, AKilledWriterLeavesOneOfTheDatabases)
{
  const fs::path  file = directory / "table.h5";
  const Database  odd  = any_database(3);
  const Database  even = any_database(4);
  std::mt19937_64 generator(13);
  write_store(file, odd);
  for (int round = 0; round < 8; ++round)
    {
      const pid_t child = ::fork();
      if (child == 0)
        for (int i = 0;; ++i)
          write_store(file, i % 2 == 0 ? even : odd);
      std::this_thread::sleep_for(std::chrono::microseconds(2000 + generator() % 60000));
      ::kill(child, SIGKILL);
      ::waitpid(child, nullptr, 0);
      const Database found = read_store(file);
      expect_same(found, found.records.size() == 3 ? odd : even);
    }
}

TEST_F(StoreTest, AKillAtEachRenameLeavesOneOfTheDatabases)
{
  const fs::path file = directory / "table.h5";
  for (int step = 1; step <= 3; ++step)
    {
      write_store(file, any_database(3));
      const pid_t child = ::fork();
      if (child == 0)
        {
          testing_faults::arm("rename", step, 0);
          write_store(file, any_database(4));
          ::_exit(0);
        }
      int status = 0;
      ::waitpid(child, &status, 0);
      EXPECT_EQ(WEXITSTATUS(status), 99);
      expect_same(read_store(file), any_database(step < 3 ? 3 : 4));
    }
}

TEST_F(StoreTest, AnErrorInAnyCallLeavesTheOldDatabaseAndDigest)
{
  const fs::path file = directory / "table.h5";
  write_store(file, any_database(3));
  const std::string whole = slurp(file), digest = slurp(digest_path_of(file));
  for (const char *call : {"open", "write", "fsync", "close", "rename"})
    {
      testing_faults::arm(call, 1, ENOSPC);
      EXPECT_THROW(write_store(file, any_database(4)), FileError) << call;
      testing_faults::disarm();
      EXPECT_EQ(slurp(file), whole) << call;
      EXPECT_EQ(slurp(digest_path_of(file)), digest) << call;
    }
}

// Wherever in the writing the disk fills up, the final flush and the last close included.
TEST_F(StoreTest, AnErrorInAnyOfTheCallsLeavesOneOfTheDatabases)
{
  const fs::path file = directory / "table.h5";
  for (const char *call : {"open", "write", "fsync", "close", "rename"})
    {
      int  refused = 0;
      bool written = false;
      while (!written)
        {
          write_store(file, any_database(3));
          testing_faults::arm(call, refused + 1, ENOSPC);
          try
            {
              write_store(file, any_database(4));
              written = true;
            }
          catch (const FileError &)
            {
              ++refused;
            }
          testing_faults::disarm();
          const Database found = read_store(file);
          EXPECT_TRUE(!written || found.records.size() == 4) << call;
          expect_same(found, any_database(found.records.size() == 3 ? 3 : 4));
          ASSERT_LT(refused, 10000) << call;
        }
      EXPECT_GT(refused, 0) << call;
    }
}

// As a file system without locks has it, for instance lustre.
TEST_F(StoreTest, NeedsNoLocksOfTheFileSystem)
{
  const fs::path file = directory / "table.h5";
  testing_faults::arm("flock", 1, ENOSYS);
  write_store(file, any_database(3));
  expect_same(read_store(file), any_database(3));
  testing_faults::disarm();
}

// As no kill leaves it.
TEST_F(StoreTest, ANewFileWithTheOldDigestIsCorruptData)
{
  const fs::path file = directory / "table.h5";
  write_store(file, any_database(1));
  const std::string digest = slurp(digest_path_of(file));
  write_store(file, any_database(2));
  spill(digest_path_of(file), digest);
  EXPECT_THROW(read_store(file), CorruptData);
}
