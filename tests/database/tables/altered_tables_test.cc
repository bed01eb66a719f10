// One value of a table changed at a time, in every column, and signed again: what `check` calls
// wrong no reader takes, and what it lets pass is listed with its reason.
#include "database/contact_law/law_of_case.h"
#include "database/files/digest.h"
#include "database/rows/checks.h"
#include "database/rows/exports.h"
#include "database/tables/lookup.h"
#include "database/tables/universal_checks.h"
#include "meshing/errors.h"
#include "meshing/number_text.h"
#include "tests/support/records.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <set>

using namespace dpcontact;
using namespace dpcontact::testing_database;

namespace
{
  using Table = std::vector<std::vector<std::string>>;

  /// A table as comments, and cells with the header first. No cell of it is quoted.
  struct Sheet
  {
    std::string comments;
    Table       cells;

    std::string text() const
    {
      std::string result = comments;
      for (const auto &row : cells)
        for (std::size_t i = 0; i < row.size(); ++i)
          result += row[i] + (i + 1 == row.size() ? "\n" : ",");
      return result;
    }
  };

  /// The rows of a file whose first two cells are among those given; the comments say how many.
  Sheet part_of(const fs::path                                              &file,
                const std::function<bool(const std::vector<std::string> &)> &in)
  {
    Sheet              sheet;
    std::string        comments;
    std::istringstream lines(slurp(file));
    for (std::string line; std::getline(lines, line);)
      if (line[0] == '#')
        comments += line + "\n";
      else
        {
          std::vector<std::string> cells(1);
          for (const char c : line)
            if (c == ',')
              cells.emplace_back();
            else
              cells.back() += c;
          if (sheet.cells.empty() || in(cells))
            sheet.cells.push_back(cells);
        }
    const auto said = comments.find("# rows: "), end = comments.find('\n', said);
    sheet.comments =
      comments.replace(said, end - said, "# rows: " + std::to_string(sheet.cells.size() - 1));
    return sheet;
  }

  bool is_number(const std::string &cell)
  {
    char *end = nullptr;
    std::strtod(cell.c_str(), &end);
    return !cell.empty() && *end == '\0';
  }

  /// Whether two cells say the same, as 0 and -0 do.
  bool are_same(const std::string &one, const std::string &other)
  {
    return one == other ||
           (is_number(one) && is_number(other) &&
            std::strtod(one.c_str(), nullptr) == std::strtod(other.c_str(), nullptr));
  }

  /// What can be done to a number, and to a text.
  std::vector<std::pair<std::string, std::string>> changes_of(const std::string &cell)
  {
    if (!is_number(cell))
      return {{"emptied", ""}, {"another word", "granite"}};
    const double value = std::strtod(cell.c_str(), nullptr);
    return {{"times 10", number_text(10 * value)},
            {"over 10", number_text(value / 10)},
            {"1e308", "1e308"},
            {"nan", "nan"},
            {"negative", number_text(-value)},
            {"zero", "0"}};
  }

  bool throws_corrupt_data(const std::function<void()> &action)
  {
    try
      {
        action();
      }
    catch (const CorruptData &)
      {
        return true;
      }
    return false;
  }

  /// The worst that a check says; an error where the file cannot be read.
  Grade worst(const std::function<std::vector<Finding>()> &check)
  {
    std::vector<Finding> findings;
    if (throws_corrupt_data([&] { findings = check(); }))
      return Grade::error;
    return findings.empty() ? Grade::note : findings[0].grade;
  }

  class AlteredTables : public InDirectory
  {
  protected:
    /// Without the syncs of write_with_digest(), as there are thousands.
    void write(const Sheet &sheet)
    {
      spill(file, sheet.text());
      spill(file.string() + ".sha256", sha256_of_file(file) + "  table.csv\n");
    }

    /// Calls `judge(column)` for every change; it gives whether the change was found at all.
    void change_all(const Sheet                                    &sheet,
                    const std::vector<std::size_t>                 &rows,
                    const std::map<std::string, std::string>       &reasons,
                    const std::function<bool(const std::string &)> &judge)
    {
      std::size_t           changes = 0, clean = 0;
      std::set<std::string> unlisted, listed;
      for (std::size_t c = 0; c < sheet.cells[0].size(); ++c)
        for (const std::size_t row : rows)
          for (const auto &[what, cell] : changes_of(sheet.cells[row][c]))
            {
              Sheet altered         = sheet;
              altered.cells[row][c] = cell;
              if (are_same(cell, sheet.cells[row][c]))
                continue;
              write(altered);
              const std::string &column = sheet.cells[0][c];
              SCOPED_TRACE(column + " of row " + std::to_string(row) + ": " + what);
              ++changes;
              if (judge(column))
                continue;
              ++clean;
              (reasons.count(column) == 0 ? unlisted : listed).insert(column + ": " + what);
            }
      for (const std::string &entry : unlisted)
        ADD_FAILURE() << entry << " passes clean, and no reason is listed";
      for (const auto &[column, reason] : reasons)
        EXPECT_TRUE(
          std::any_of(listed.begin(),
                      listed.end(),
                      [&c = column](const auto &entry) { return entry.rfind(c + ": ", 0) == 0; }))
          << column << " is listed, but every change is found";
      RecordProperty("changes", static_cast<int>(changes));
      RecordProperty("clean", static_cast<int>(clean));
      std::cout << clean << " of " << changes << " changes pass clean:\n";
      for (const std::string &entry : listed)
        std::cout << "  " << entry << '\n';
      EXPECT_LT(6 * clean, changes);
    }

    const fs::path file = directory / "table.csv";
  };

  Case rock(const double nu, const double phi)
  {
    Case input;
    input.material.youngs_modulus       = 1e10;
    input.material.poisson_ratio        = nu;
    input.material.friction_angle       = Angle(phi);
    input.material.compressive_strength = 15e6;
    input.scene                         = {0.1, 100, {}};
    return input;
  }
} // namespace

TEST_F(AlteredTables, WhatIsWrongWithAUniversalTableNoReaderTakes)
{
  const std::set<std::string> nu{"0.1125", "0.225"}, phi{"25", "28"};
  const Sheet                 sheet = part_of(DPCONTACT_UNIVERSAL_TABLE, [&](const auto &cells) {
    return nu.count(cells[0]) * phi.count(cells[1]) == 1;
  });
  ASSERT_EQ(sheet.cells.size(), 1u + 4 * 22);
  const Case input     = rock(0.15, 26);
  const auto look_up   = [&] { LookupTable(LookupMethod::similarity, file).at(input); };
  const auto collide   = [&] { contact_law(input, read_universal_table(file.string())); };
  const auto take_away = [&] {
    std::istringstream stream(slurp(file));
    try
      {
        ContactTable::read(stream);
      }
    catch (const std::runtime_error &error)
      {
        throw CorruptData(error.what());
      }
  };
  write(sheet);
  EXPECT_TRUE(check_universal(file.string(), slurp(file)).empty());
  EXPECT_NO_THROW(look_up());
  EXPECT_NO_THROW(collide());
  EXPECT_NO_THROW(take_away());

  const std::set<std::string> of_header{
    "nu", "phi_deg", "load_level", "approach", "residual_approach", "m_law", "n_law"};
  const std::string computed = "what the computation states of itself enters nothing else";
  const std::string misfit =
    "the curves are not in the table, and where nothing yields all is rounding";
  const std::map<std::string, std::string> reasons{{"approach_error", computed},
                                                   {"residual_approach_error", computed},
                                                   {"a_error", computed},
                                                   {"b_error", computed},
                                                   {"m_error", computed},
                                                   {"n_error", computed},
                                                   {"a_misfit", misfit},
                                                   {"b_misfit", misfit},
                                                   {"m_misfit", misfit},
                                                   {"n_misfit", misfit},
                                                   {"rmse_loading", misfit},
                                                   {"rmse_unloading", misfit}};
  // Elastic, next to first yield, and well beyond it.
  change_all(sheet, {2, 8, 15, 22}, reasons, [&](const std::string &column) {
    const Grade grade = worst([&] { return check_universal(file.string(), slurp(file)); });
    const bool  wrong = grade == Grade::error;
    EXPECT_EQ(throws_corrupt_data(look_up), wrong);
    EXPECT_EQ(throws_corrupt_data(collide), wrong);
    EXPECT_EQ(throws_corrupt_data(take_away), wrong && of_header.count(column) == 1);
    return grade != Grade::note;
  });
}

TEST_F(AlteredTables, WhatIsWrongWithRowsNoReaderTakes)
{
  const Sheet sheet = part_of(DPCONTACT_PAPERS_ROWS, [](const auto &cells) {
    return cells[0] == "1e+10" && cells[1] == "0.1";
  });
  ASSERT_EQ(sheet.cells.size(), 1u + 18);
  write(sheet);
  EXPECT_TRUE(check(read_database(file)).empty());
  const std::string machine = "it depends on the machine and the program, not on the contact";
  const std::string sign    = "only its magnitude enters the error of the fit";
  const std::string flow =
    "another material, whose first yield and first elastic state are the same";
  const std::string where =
    "how strains are distributed is not in the row: energy and size bound it";
  const std::map<std::string, std::string> reasons{
    {"plastic_volume_m3", where},
    {"plastic_strain_max", where},
    {"dissipated_energy_J", "how much stays in the bodies as residual stress is not in the row"},
    {"step_error", "it is estimated from states that are not stored"},
    {"a_window_change", sign},
    {"b_window_change", sign},
    {"m_window_change", sign},
    {"n_window_change", sign},
    {"dofs", machine},
    {"newton_iterations", machine},
    {"wall_seconds", machine},
    {"peak_memory_bytes", machine},
    {"dilation_deg", flow}};
  change_all(sheet, {1, 9, 18}, reasons, [&](const std::string &) {
    const Grade grade = worst([&] { return check(read_database(file)); });
    EXPECT_EQ(throws_corrupt_data([&] { read_checked_database(file); }), grade == Grade::error);
    return grade != Grade::note;
  });
}

TEST_F(AlteredTables, RowsThatAreDroppedRepeatedOrElsewhereAreSeen)
{
  for (const char *const table : {DPCONTACT_UNIVERSAL_TABLE, DPCONTACT_PAPERS_ROWS})
    {
      const bool  of_rows = std::string(table) == DPCONTACT_PAPERS_ROWS;
      const Sheet sheet   = part_of(table, [](const auto &) { return true; });
      const auto  verdict = [&](const Sheet &altered) {
        write(altered);
        return of_rows ? check(read_database(file)) : check_universal(file.string(), slurp(file));
      };
      EXPECT_TRUE(verdict(sheet).empty());

      Sheet dropped = sheet;
      dropped.cells.erase(dropped.cells.begin() + 100);
      EXPECT_EQ(worst([&] { return verdict(dropped); }), Grade::error);
      const auto last = dropped.comments.find("# rows: ");
      dropped.comments.replace(last,
                               dropped.comments.find('\n', last) - last,
                               "# rows: " + std::to_string(dropped.cells.size() - 1));
      if (of_rows) // its count is right: a hole in the grid is left
        EXPECT_NE(verdict(dropped).at(0).what.find("1 of the 162 rows of its grid are missing"),
                  std::string::npos);
      else
        EXPECT_THROW(verdict(dropped), CorruptData);

      Sheet repeated      = sheet;
      repeated.cells[100] = repeated.cells[101];
      EXPECT_EQ(worst([&] { return verdict(repeated); }), Grade::error);

      Sheet swapped = sheet;
      std::swap(swapped.cells[100], swapped.cells[101]);
      const auto findings = verdict(swapped);
      ASSERT_EQ(findings.size(), 1u);
      EXPECT_EQ(findings[0].grade, Grade::warning);
      EXPECT_NE(findings[0].what.find("order of their grid"), std::string::npos);
    }
}

TEST_F(AlteredTables, AnotherUnitIsRefusedByEveryReader)
{
  Sheet sheet = part_of(DPCONTACT_PAPERS_ROWS, [](const auto &) { return true; });
  for (const auto &[said, instead] : {std::pair("#   E_Pa, Pa,", "#   E_Pa, GPa,"),
                                      {"#   nu, 1, Poisson's ratio\n", ""},
                                      {"#   criterion, text,", "#   criterion, 1,"}})
    {
      Sheet altered = sheet;
      altered.comments.replace(altered.comments.find(said), std::string(said).size(), instead);
      write(altered);
      EXPECT_THROW(read_database(file), CorruptData) << instead;
    }
  sheet                  = part_of(DPCONTACT_UNIVERSAL_TABLE, [](const auto &) { return true; });
  const std::string said = "#   phi_deg, deg,";
  sheet.comments.replace(sheet.comments.find(said), said.size(), "#   phi_deg, rad,");
  write(sheet);
  EXPECT_NE(message_of<CorruptData>([this] {
              UniversalTable::read(file);
            }).find("phi_deg is in 'rad', it should be in 'deg'"),
            std::string::npos);
  EXPECT_THROW(read_universal_table(file.string()), CorruptData);
  EXPECT_THROW(LookupTable(LookupMethod::similarity, file), CorruptData);
  std::istringstream stream(sheet.text());
  EXPECT_THROW(ContactTable::read(stream), std::runtime_error);
}
