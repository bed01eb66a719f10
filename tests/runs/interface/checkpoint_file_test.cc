#include "database/files/digest.h"
#include "database/files/files.h"
#include "meshing/errors.h"
#include "runs/interface/checkpoint_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <sys/stat.h>

namespace
{
  using namespace dpcontact;

  const Json   settings = {{"material", {{"E", 1e10}}}, {"options", {{"level", 0}}}};
  const Arrays state    = {{"steps", {16}}, {"u", {1, -2.5, 1e-300}}, {"none", {}}};

  /// A checkpoint that is removed with its test.
  class CheckpointFile : public testing::Test
  {
  protected:
    void SetUp() override
    {
      const auto *const test = testing::UnitTest::GetInstance()->current_test_info();
      file = std::filesystem::path(testing::TempDir()) / (std::string(test->name()) + ".kept");
      std::filesystem::remove(file);
    }
    void TearDown() override { std::filesystem::remove(file); }

    /// Exchanges the line of JSON and signs the file again.
    void write_with_header(const std::string &header) const
    {
      write_checkpoint(file, settings, state);
      const std::string text    = read_file(file);
      const std::size_t title   = text.find('\n') + 1;
      const std::size_t content = text.find('\n', title) + 1;
      const std::string changed = header + text.substr(text.find('\n', content));
      write_file(file, text.substr(0, title) + sha256(changed) + "\n" + changed);
    }

    std::string with_sizes(const std::string &sizes) const
    {
      return R"({"settings":)" + settings.dump() + R"(,"sizes":)" + sizes + "}";
    }

    std::filesystem::path file;
  };

  TEST_F(CheckpointFile, numbers_come_back)
  {
    write_checkpoint(file, settings, state);
    EXPECT_EQ(read_checkpoint(file, settings), state);
    write_with_header(with_sizes(R"([["none",0],["steps",1],["u",3]])"));
    EXPECT_EQ(read_checkpoint(file, settings), state);
  }

  TEST_F(CheckpointFile, sizes_that_are_not_those_of_the_numbers_are_refused)
  {
    for (const std::string sizes : {R"([["u",1000000000000]])",
                                    R"([["u",2305843009213693952]])",
                                    R"([["u",18446744073709551615]])",
                                    R"([["steps",1],["u",4]])",
                                    R"([["steps",1],["u",2]])",
                                    R"([["u",-1]])",
                                    R"([["u",3.5]])",
                                    R"([["u"]])",
                                    R"([[4,4]])",
                                    R"({"u":4})",
                                    "[]"})
      {
        write_with_header(with_sizes(sizes));
        EXPECT_THROW(read_checkpoint(file, settings), CorruptData) << sizes;
      }
  }

  TEST_F(CheckpointFile, headers_that_are_none_are_refused)
  {
    for (const std::string &header : {std::string("{"),
                                      std::string("[]"),
                                      std::string(300000, '['),
                                      std::string(R"({"settings":{}})"),
                                      std::string(R"({"sizes":[]})")})
      {
        write_with_header(header);
        EXPECT_THROW(read_checkpoint(file, settings), Error) << header.substr(0, 40);
      }
    write_with_header(R"({"settings":1,"sizes":[]})");
    EXPECT_THROW(read_checkpoint(file, settings), SettingsMismatch);
  }

  TEST_F(CheckpointFile, a_pipe_is_refused_before_it_is_opened)
  {
    ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0);
    EXPECT_THROW(read_checkpoint(file, settings), FileError);
  }
} // namespace
