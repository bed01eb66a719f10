#include "database/rows/exports.h"
#include "meshing/errors.h"
#include "tests/support/records.h"

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
          const schema::Cell stored = columns[j].get(record);
          if (const auto *number = std::get_if<double>(&stored))
            EXPECT_TRUE(same(std::strtod(cell.c_str(), nullptr), *number))
              << columns[j].name << ' ' << cell;
          else if (const auto *count = std::get_if<std::uint64_t>(&stored))
            EXPECT_EQ(cell, std::to_string(*count));
          else
            EXPECT_EQ(cell, std::get<std::string>(stored));
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
  std::set<std::string> names;
  for (const schema::Column &column : schema::columns())
    {
      EXPECT_TRUE(names.insert(column.name).second) << column.name;
      EXPECT_FALSE(column.description.empty()) << column.name;
      EXPECT_EQ(column.unit.empty(), column.is_text()) << column.name;
    }
}

TEST(Schema, EveryColumnHasAPlaceOfItsOwn)
{
  Record before                        = any_record(4);
  before.input.material.dilation_angle = Angle(5); // associated flow would follow phi
  for (const schema::Column &column : schema::columns())
    {
      Record after = before;
      if (column.is_number())
        column.set(after, 0.0625);
      else if (!column.is_text())
        column.set(after, std::uint64_t(625));
      else
        column.set(after, column.choices.empty() ? "another" : column.choices.back());
      EXPECT_FALSE(same(column.get(before), column.get(after))) << column.name;
      for (const schema::Column &other : schema::columns())
        {
          const bool kept = same(other.get(before), other.get(after));
          EXPECT_TRUE(kept || other.name == column.name) << column.name << " moves " << other.name;
        }
    }
}

// A member of Record that no column names would be lost silently.
TEST(Schema, EveryNumberAndTextOfARecordHasAColumn)
{
  std::set<std::string> inputs;
  for (const schema::Column &column : schema::input_columns())
    inputs.insert(column.name);
  std::size_t bytes = sizeof(Case) + sizeof(Curve) + sizeof(std::vector<PressurePoint>);
  for (const schema::Column &column : schema::columns())
    if (inputs.count(column.name) == 0)
      bytes += std::visit([](const auto &value) { return sizeof(value); }, column.get(Record()));
  EXPECT_EQ(bytes, sizeof(Record)); // all members are aligned to 8 bytes: there is no padding
}
