// What a file and its digest are after errors and kills at every step of writing.
#include "database/files/digest.h"
#include "database/files/files.h"
#include "meshing/errors.h"
#include "tests/support/faults.h"
#include "tests/support/records.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <set>
#include <sys/resource.h>
#include <sys/wait.h>

using namespace dpcontact;
using namespace dpcontact::testing_database;

namespace
{
  class FilesTest : public InDirectory
  {
  protected:
    /// The names in the directory, sorted.
    std::set<std::string> names() const
    {
      std::set<std::string> found;
      for (const auto &entry : fs::directory_iterator(directory))
        found.insert(entry.path().filename().string());
      return found;
    }

    /// Runs an action in a process of its own. @return how that ended.
    template <typename Action>
    static int in_child(const Action &action)
    {
      const pid_t child = ::fork();
      if (child == 0)
        {
          try
            {
              action();
            }
          catch (const Error &error)
            {
              ::_exit(static_cast<int>(error.code()));
            }
          ::_exit(0);
        }
      int status = 0;
      ::waitpid(child, &status, 0);
      return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    }

    fs::path file = directory / "table.csv";
  };
} // namespace

TEST_F(FilesTest, EveryErrorOfTheSystemLeavesTheOldFileAndDigestAndIsNamed)
{
  write_with_digest(file, "old");
  const std::string digest = slurp(digest_path_of(file));
  for (const char *call : {"open", "write", "fsync", "close", "rename"})
    {
      testing_faults::arm(call, 1, ENOSPC);
      std::string message;
      try
        {
          write_with_digest(file, "new");
        }
      catch (const FileError &error)
        {
          message = error.what();
        }
      testing_faults::disarm();
      EXPECT_NE(message.find(std::strerror(ENOSPC)), std::string::npos) << call << message;
      EXPECT_EQ(slurp(file), "old") << call;
      EXPECT_EQ(slurp(digest_path_of(file)), digest) << call;
      EXPECT_EQ(names(), (std::set<std::string>{"table.csv", "table.csv.sha256"})) << call;
    }
}

TEST_F(FilesTest, AKillAtAnyStepLeavesAPairThatAgrees)
{
  for (const char *call : {"open", "write", "fsync", "close", "rename"})
    for (int step = 1;; ++step)
      {
        write_with_digest(file, "old");
        const int         end   = in_child([&] {
          testing_faults::arm(call, step, 0);
          write_with_digest(file, "new");
        });
        const std::string found = read_with_digest(file);
        EXPECT_TRUE(found == "old" || found == "new");
        if (end == 0)
          {
            EXPECT_GT(step, call == std::string("rename") ? 3 : 1) << call;
            EXPECT_EQ(found, "new");
            break;
          }
        ASSERT_EQ(end, 99);
      }
}

TEST_F(FilesTest, AKillOfTheFirstWriteLeavesNoFileOrAPairThatAgrees)
{
  for (int step = 1; step < 4; ++step)
    {
      fs::remove(file);
      fs::remove(digest_path_of(file));
      EXPECT_EQ(in_child([&] {
                  testing_faults::arm("rename", step, 0);
                  write_with_digest(file, "new");
                }),
                99);
      if (fs::exists(file))
        {
          EXPECT_EQ(read_with_digest(file), "new");
        }
      write_with_digest(file, "newer");
      EXPECT_EQ(read_with_digest(file), "newer");
    }
}

TEST_F(FilesTest, Sha256sumUnderstandsTheDigestAfterwards)
{
  write_with_digest(file, "old");
  in_child([&] {
    testing_faults::arm("rename", 3, 0);
    write_with_digest(file, "new");
  });
  write_with_digest(file, "newest");
  const std::string command =
    "cd '" + directory.string() + "' && sha256sum --status --strict -c table.csv.sha256";
  EXPECT_EQ(std::system(command.c_str()), 0);
}

TEST_F(FilesTest, AnAlteredFileIsNotMadeGoodByBeingReplaced)
{
  write_with_digest(file, "old");
  spill(file, "altered");
  in_child([&] {
    testing_faults::arm("rename", 2, 0);
    write_with_digest(file, "new");
  });
  EXPECT_EQ(slurp(file), "altered");
  EXPECT_THROW(read_with_digest(file), CorruptData);
}

TEST_F(FilesTest, ALimitOfFileSizeIsAFileError)
{
  write_with_digest(file, "old");
  EXPECT_EQ(in_child([&] {
              const rlimit bounds{1000, 1000};
              setrlimit(RLIMIT_FSIZE, &bounds);
              write_with_digest(file, std::string(5000, 'x'));
            }),
            static_cast<int>(ExitCode::file));
  EXPECT_EQ(read_with_digest(file), "old");
}

TEST_F(FilesTest, DevicesAndDirectoriesAreNoTargets)
{
  EXPECT_THROW(write_file("/dev/full", "x"), FileError);
  EXPECT_THROW(write_file("/dev/null", "x"), FileError);
  EXPECT_THROW(write_file(directory, "x"), FileError);
  EXPECT_FALSE(fs::is_regular_file("/dev/full"));
}

TEST_F(FilesTest, ALinkIsReplacedAndItsTargetIsNot)
{
  spill(directory / "victim", "kept");
  fs::create_symlink("victim", file);
  write_with_digest(file, "new");
  EXPECT_EQ(slurp(directory / "victim"), "kept");
  EXPECT_FALSE(fs::is_symlink(file));
  EXPECT_EQ(slurp(file), "new");
}

TEST_F(FilesTest, TemporaryNamesAreNeverTheSame)
{
  const TemporaryFile one(file), other(file);
  EXPECT_NE(one.path(), other.path());
  EXPECT_EQ(one.path().parent_path(), directory);
}

TEST_F(FilesTest, OnlyLeftoversOfTheTargetThatNobodyHoldsAreRemoved)
{
  const fs::path left     = directory / ".table.csv.0123456789abcdef.tmp";
  const fs::path others[] = {directory / ".table.csv.sha256.0123456789abcdef.tmp",
                             directory / ".else.csv.0123456789abcdef.tmp",
                             directory / ".table.csv.notes.tmp",
                             directory / "table.csv.0123456789abcdef.tmp"};
  spill(left, "half");
  for (const fs::path &other : others)
    spill(other, "kept");
  const TemporaryFile held(file);
  EXPECT_EQ(in_child([&] { TemporaryFile::remove_leftovers(file); }), 0);
  EXPECT_FALSE(fs::exists(left));
  EXPECT_TRUE(fs::exists(held.path()));
  for (const fs::path &other : others)
    EXPECT_TRUE(fs::exists(other)) << other;
  EXPECT_EQ(in_child([&] { TemporaryFile::remove_all_leftovers(directory); }), 0);
  EXPECT_TRUE(fs::exists(held.path()));
  EXPECT_FALSE(fs::exists(others[0]));
  EXPECT_FALSE(fs::exists(others[1]));
  EXPECT_TRUE(fs::exists(others[2]));
}

TEST_F(FilesTest, AKilledWriterHoldsNothing)
{
  EXPECT_EQ(in_child([&] {
              const TemporaryFile temporary(file);
              ::_exit(99);
            }),
            99);
  EXPECT_EQ(names().size(), 1U);
  TemporaryFile::remove_leftovers(file);
  EXPECT_TRUE(names().empty());
}
