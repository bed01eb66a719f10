#include "database/files/csv.h"
#include "meshing/errors.h"
#include "meshing/number_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <sstream>

using namespace dpcontact;

namespace
{
  constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity     = std::numeric_limits<double>::infinity();
} // namespace

TEST(NumberText, GivesTheSameDoubleBackInFewDigits)
{
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(-2), "-2");
  EXPECT_EQ(number_text(1e22), "1e+22");
  EXPECT_EQ(number_text(0.1 + 0.2), "0.30000000000000004");
  std::mt19937_64                  random(1);
  std::uniform_real_distribution<> exponent(-300, 300);
  for (unsigned int i = 0; i < 1000; ++i)
    {
      const double value = std::pow(10, exponent(random));
      EXPECT_EQ(std::stod(number_text(value)), value);
    }
}

TEST(NumberText, NamesWhatIsNoNumber)
{
  EXPECT_EQ(number_text(not_a_number), "nan");
  EXPECT_EQ(number_text(-not_a_number), "nan");
  EXPECT_EQ(number_text(infinity), "inf");
  EXPECT_EQ(number_text(-infinity), "-inf");
}

TEST(CsvWriter, WritesCommentsHeaderAndRows)
{
  CsvWriter csv;
  csv.comment("two\nlines");
  csv.header({"name", "count", "value"});
  csv.row("first", 3u, 0.25);
  csv.add(std::string("second"));
  csv.add(std::uint64_t(18446744073709551615u));
  csv.add(-1e-9);
  csv.end_row();
  EXPECT_EQ(csv.text(),
            "# two\n# lines\nname,count,value\nfirst,3,0.25\nsecond,18446744073709551615,-1e-09\n");
}

TEST(CsvWriter, WritesNaNByNameOrAsAnEmptyCell)
{
  for (const bool empty : {false, true})
    {
      CsvFormat format;
      if (empty)
        format.nan = CsvFormat::NotANumber::empty;
      CsvWriter csv(format);
      csv.header({"a", "b", "c"});
      csv.row(not_a_number, infinity, not_a_number);
      EXPECT_EQ(csv.text(), empty ? "a,b,c\n,inf,\n" : "a,b,c\nnan,inf,nan\n");
    }
}

TEST(CsvWriter, WritesAsManyDigitsAsAskedLikeAStream)
{
  for (const int digits : {1, 5, 12, 17})
    for (const double value : {0., -0., 0.1, 1., 123456789., -1. / 3, 6.02214076e23, 1e-5, 1e-310})
      {
        CsvFormat format;
        format.digits = digits;
        CsvWriter csv(format);
        csv.header({"x"});
        csv.row(value);
        std::ostringstream stream;
        stream.precision(digits);
        stream << "x\n" << value << '\n';
        EXPECT_EQ(csv.text(), stream.str());
      }
}

TEST(CsvWriter, QuotesTextsThatTheTableReadsBack)
{
  const std::vector<std::string> texts{
    "", "plain text", "a, b", "\"quoted\"", "two\nlines", "# no comment", ",", "\""};
  CsvWriter csv;
  csv.comment("a, \"comment\"");
  csv.header({"text", "number"});
  for (const std::string &text : texts)
    csv.row(text, 0.1);
  const CsvTable table("table.csv", csv.text());
  ASSERT_EQ(table.rows(), texts.size());
  EXPECT_EQ(table.comments(), std::vector<std::string>{"a, \"comment\""});
  for (std::size_t i = 0; i < texts.size(); ++i)
    {
      EXPECT_EQ(table.text("text", i), texts[i]);
      EXPECT_EQ(table.number("number", i), 0.1);
    }
}

TEST(CsvWriter, RefusesARowUnlikeTheHeader)
{
  CsvWriter csv;
  csv.header({"a", "b"});
  EXPECT_THROW(csv.row(1), Error);
  CsvWriter longer;
  longer.header({"a", "b"});
  EXPECT_THROW(longer.row(1, 2, 3), Error);
}

TEST(CsvTable, RefusesWhatIsNoTable)
{
  for (const char *text : {"a,a\n1,2\n", "a,\n1,2\n", "a,b\n1\n", "a,b\n1,2,3\n", "a,b\n\"1,2\n"})
    EXPECT_THROW(CsvTable("table.csv", text), CorruptData) << text;
}

TEST(CsvTable, RefusesACellThatIsNoNumber)
{
  const CsvTable table("table.csv", "a,b\n1x,\n-1,2\n");
  EXPECT_THROW(table.number("a", 0), CorruptData);
  EXPECT_THROW(table.number("b", 0), CorruptData);
  EXPECT_THROW(table.count("a", 1), CorruptData);
  EXPECT_THROW(table.text("c", 0), CorruptData);
  EXPECT_EQ(table.count("b", 1), 2u);
  EXPECT_TRUE(table.has("a"));
  EXPECT_FALSE(table.has("c"));
}
