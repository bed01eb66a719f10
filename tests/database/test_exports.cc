#include "database/exports.h"
#include "meshing/errors.h"
#include "tests/database/support.h"

#include <set>

using namespace dpcontact;
using namespace dpcontact::testing_database;

namespace
{
  using CsvTest = InDirectory;

  /// RFC 4180, beginning after the comment lines.
  std::vector<std::vector<std::string>> parse_csv(const std::string &text)
  {
    std::size_t at = 0;
    while (text[at] == '#')
      at = text.find('\n', at) + 1;
    std::vector<std::vector<std::string>> lines(1, {""});
    bool                                  quoted = false;
    for (; at + 1 < text.size(); ++at)
      if (quoted && text[at] == '"' && text[at + 1] == '"')
        lines.back().back() += text[++at];
      else if (text[at] == '"')
        quoted = !quoted;
      else if (!quoted && text[at] == ',')
        lines.back().emplace_back();
      else if (!quoted && text[at] == '\n')
        lines.push_back({""});
      else
        lines.back().back() += text[at];
    return lines;
  }

  Database sample()
  {
    Database database;
    for (std::uint64_t seed = 0; seed < 8; ++seed)
      database.records.push_back(any_record(seed));
    database.provenance = {{"git_revision", "0123abc"}, {"input", "two\nlines"}};
    return database;
  }
} // namespace

TEST_F(CsvTest, HeaderBeginsAsPromised)
{
  write_csv(directory / "table.csv", sample());
  const std::string text = slurp(directory / "table.csv");
  const std::string header =
    "E_Pa,nu,phi_deg,sigma_c_Pa,radius_m,force_max_N,force_yield_N,approach_yield_m,"
    "pressure_yield_Pa,contact_radius_yield_m,yield_strength_Pa,a,b,m,n,a_published,m_published,"
    "approach_residual_m,approach_peak_m,status,";
  EXPECT_NE(text.find("\n" + header), std::string::npos);
  std::istringstream in(text);
  std::string        line;
  while (std::getline(in, line) && line[0] == '#')
    {}
  EXPECT_EQ(line.rfind(header, 0), 0U); // nothing but comments before it
  for (const char *part : {"# schema_version: 3\n",
                           "# git_revision: 0123abc\n",
                           "# input: two\n# lines\n",
                           "#   force_yield_N, N, F_y"})
    EXPECT_NE(text.find(part), std::string::npos) << part;
}

TEST_F(CsvTest, NumbersAndTextsComeBack)
{
  const Database database = sample();
  write_csv(directory / "table.csv", database);
  const auto lines = parse_csv(slurp(directory / "table.csv"));
  ASSERT_EQ(lines.size(), 1 + database.records.size());
  const auto &columns = schema::columns();
  for (std::size_t row = 0; row < database.records.size(); ++row)
    {
      ASSERT_EQ(lines[row + 1].size(), columns.size());
      for (std::size_t j = 0; j < columns.size(); ++j)
        {
          const Record      &record = database.records[row];
          const std::string &cell   = lines[row + 1][j];
          EXPECT_EQ(lines[0][j], columns[j].name);
          if (const auto *number = std::get_if<double Record::*>(&columns[j].member))
            EXPECT_TRUE(same(std::strtod(cell.c_str(), nullptr), record.**number))
              << columns[j].name << ' ' << cell;
          else if (const auto *count = std::get_if<std::uint64_t Record::*>(&columns[j].member))
            EXPECT_EQ(cell, std::to_string(record.**count));
          else
            EXPECT_EQ(cell, record.*std::get<std::string Record::*>(columns[j].member));
        }
    }
}

TEST_F(CsvTest, UnwritablePlacesAreFileErrorsAndTouchNothing)
{
  spill(directory / "file", "untouched");
  const std::string message =
    message_of<FileError>([&] { write_csv(directory / "file" / "table.csv", sample()); });
  EXPECT_NE(message.find("table.csv"), std::string::npos);
  EXPECT_EQ(slurp(directory / "file"), "untouched");
  EXPECT_THROW(write_csv(directory / "absent" / "table.csv", sample()), FileError);
  EXPECT_FALSE(fs::exists(directory / "absent"));
}

TEST(Schema, ColumnsAreDistinctAndDescribed)
{
  std::set<std::string>                                                                       names;
  std::vector<std::variant<double Record::*, std::uint64_t Record::*, std::string Record::*>> seen;
  for (const auto &column : schema::columns())
    {
      EXPECT_TRUE(names.insert(column.name).second) << column.name;
      EXPECT_FALSE(std::string(column.description).empty()) << column.name;
      const bool text = std::holds_alternative<std::string Record::*>(column.member);
      EXPECT_EQ(std::string(column.unit).empty(), text) << column.name;
      for (const auto &other : seen)
        EXPECT_FALSE(other == column.member) << column.name;
      seen.push_back(column.member);
    }
}

// A member of Record that no column names would be lost silently.
TEST(Schema, EveryNumberAndTextOfARecordHasAColumn)
{
  std::size_t bytes = sizeof(Curve) + sizeof(std::vector<PressurePoint>);
  for (const auto &column : schema::columns())
    bytes += std::visit([](const auto member) { return sizeof(std::declval<Record &>().*member); },
                        column.member);
  EXPECT_EQ(bytes, sizeof(Record)); // all members are aligned to 8 bytes: there is no padding
}
