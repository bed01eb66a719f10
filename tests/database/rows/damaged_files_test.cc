// Files that are not what the program wrote: a thousand of each kind by a fixed seed, with the
// digest of the original, and with a digest renewed by whoever altered them.
#include "database/files/digest.h"
#include "database/files/hdf5_handles.h"
#include "database/rows/checks.h"
#include "database/rows/exports.h"
#include "database/rows/store.h"
#include "database/tables/universal_checks.h"
#include "database/tables/universal_table.h"
#include "meshing/errors.h"
#include "meshing/number_text.h"
#include "tests/support/records.h"

#include <algorithm>
#include <cmath>

using namespace dpcontact;
using namespace dpcontact::testing_database;

namespace
{
  constexpr int files = 1000;

  /// Damage to a file's bytes, the same sequence from the same seed.
  class Damage
  {
  public:
    Damage(const std::uint64_t seed, std::string whole_, std::vector<std::string> foreign_)
      : random(seed)
      , whole(std::move(whole_))
      , foreign(std::move(foreign_))
    {}

    /// What is left, never the original; `what` names the damage.
    std::string next(std::string &what)
    {
      std::string text;
      do
        text = damaged(what);
      while (text == whole);
      return text;
    }

  private:
    std::size_t below(const std::size_t bound) { return random() % bound; }

    std::string noise(const std::size_t size)
    {
      std::string bytes(size, '\0');
      for (char &byte : bytes)
        byte = static_cast<char>(random());
      return bytes;
    }

    std::string damaged(std::string &what)
    {
      std::string       text = whole;
      const std::size_t at = below(text.size()), other = below(text.size());
      const std::size_t length =
        std::min(1 + below(std::size_t(1) << below(13)), text.size() - std::max(at, other));
      const auto named = [&](const char *const name) {
        what =
          std::string(name) + ", " + std::to_string(length) + " bytes at " + std::to_string(at);
      };
      switch (below(10))
        {
          case 0:
            named("flipped bits from");
            for (std::size_t i = 0, count = 1 + below(4); i < count; ++i)
              {
                char &byte = text[i == 0 ? at : below(text.size())];
                byte       = static_cast<char>(byte ^ (1 << below(8)));
              }
            break;
          case 1:
            named("noise over");
            text.replace(at, length, noise(length));
            break;
          case 2:
            named("zeros over");
            text.replace(at, length, length, '\0');
            break;
          case 3:
            named("ones over");
            text.replace(at, length, length, '\xff');
            break;
          case 4:
            named("cut off");
            text.resize(at);
            break;
          case 5:
            named("beginning lost");
            text.erase(0, at);
            break;
          case 6:
            named("swapped");
            std::swap_ranges(
              text.begin() + static_cast<long>(at),
              text.begin() +
                static_cast<long>(at + std::min(length, at > other ? at - other : other - at)),
              text.begin() + static_cast<long>(other));
            break;
          case 7:
            named("left out");
            text.erase(at, length);
            break;
          case 8:
            named("inserted");
            text.insert(at, below(2) == 0 ? noise(length) : whole.substr(other, length));
            break;
          default:
            const std::size_t which = below(foreign.size());
            what                    = "foreign file " + std::to_string(which);
            text                    = foreign[which];
        }
      return text;
    }

    std::mt19937_64          random;
    std::string              whole;
    std::vector<std::string> foreign;
  };

  class DamagedFiles : public InDirectory
  {
  protected:
    /// Files of other programs, and what begins like one of ours.
    std::vector<std::string> foreign_files(const std::string &whole)
    {
      std::string strange;
      {
        const hdf5::Silence silence;
        hdf5::NewFile       file;
        hdf5::write_attribute(file, "schema_version", 3);
        auto group = hdf5::create_group(file, "rows");
        hdf5::write_dataset(group, "a", std::vector<double>{1, 2, 3}).close_now("close");
        group.close_now("close");
        strange = file.close();
      }
      std::string shuffled = whole;
      std::shuffle(shuffled.begin() + 8, shuffled.end(), std::mt19937_64(3));
      return {"",
              "\n",
              std::string(5000, '\0'),
              "x,y\n1,2\n",
              "# dpcontact: universal table\n",
              "# dpcontact: coefficients of elastic-plastic contact\n# schema_version: 3\nE_Pa\n",
              "{\"rows\": []}",
              std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16) + std::string(200, 'p'),
              std::string("PK\3\4", 4) + std::string(300, 'z'),
              std::string("\x89HDF\r\n\x1a\n", 8),
              whole.substr(0, 48),
              shuffled,
              strange};
    }

    void renew_digest(const fs::path &file)
    {
      spill(file.string() + ".sha256",
            sha256_of_file(file) + "  " + file.filename().string() + "\n");
    }

    /// Reads every damaged file with the original's digest, which must say so before anything is
    /// read, and with a renewed one.
    template <typename Read>
    void read_all(const fs::path &file, const std::uint64_t seed, const Read &read)
    {
      const std::string whole = slurp(file), digest = slurp(file.string() + ".sha256");
      Damage            damage(seed, whole, foreign_files(whole));
      for (int i = 0; i < files; ++i)
        {
          std::string what;
          spill(file, damage.next(what));
          SCOPED_TRACE("file " + std::to_string(i) + ": " + what);
          spill(file.string() + ".sha256", digest);
          const std::string message = message_of<CorruptData>([&] { read(); });
          EXPECT_NE(message.find("truncated or altered: its SHA-256 is"), std::string::npos)
            << message;
          renew_digest(file);
          try
            {
              read();
              ++accepted;
            }
          catch (const Error &error)
            {
              ++refused;
              EXPECT_TRUE(error.code() == ExitCode::corrupt_data ||
                          error.code() == ExitCode::settings_mismatch)
                << error.what();
              EXPECT_NE(std::string(error.what()).find(file.filename().string()), std::string::npos)
                << error.what();
            }
        }
      EXPECT_EQ(accepted + refused, files);
      RecordProperty("accepted", accepted);
      RecordProperty("refused", refused);
    }

    int accepted = 0, refused = 0;
  };

  Database rows_of_any_kind()
  {
    Database database;
    for (std::size_t i = 0; i < 3; ++i)
      database.records.push_back(any_record(i));
    database.provenance = {{"git_revision", "0123abc"}, {"input", std::string(500, 'x')}};
    return database;
  }
} // namespace

TEST_F(DamagedFiles, ADatabaseIsRefusedOrItsNumbersAreTheOriginals)
{
  // HDF5's checksums are on its metadata and on every dataset: what is damaged and still accepted
  // has lost text of the provenance, or bytes that nothing refers to.
  const Database database = rows_of_any_kind();
  const fs::path file     = directory / "table.h5";
  write_store(file, database);
  read_all(file, 20181, [&] {
    const Database found = read_store(file);
    ASSERT_EQ(found.records.size(), database.records.size());
    for (std::size_t i = 0; i < found.records.size(); ++i)
      testing_database::expect_same(found.records[i], database.records[i]);
  });
  EXPECT_GT(refused, files / 2);
}

TEST_F(DamagedFiles, ACsvTableIsRefusedOrCanBeChecked)
{
  const fs::path file = directory / "table.csv";
  write_csv(file, rows_of_any_kind());
  read_all(file, 20182, [&] { check(read_csv(file)); });
  EXPECT_GT(refused, files / 2);
}

TEST_F(DamagedFiles, AUniversalTableIsRefusedOrCanBeChecked)
{
  // Two nu by two phi of the shipped table.
  const UniversalTable shipped = UniversalTable::read(DPCONTACT_UNIVERSAL_TABLE);
  std::istringstream   lines(slurp(DPCONTACT_UNIVERSAL_TABLE));
  std::string          text;
  for (std::string line; std::getline(lines, line);)
    for (const std::size_t i : {0, 1})
      for (const std::size_t k : {0, 1})
        if (line[0] == '#' || line[0] == 'n' ? i + k == 0
                                             : line.rfind(number_text(shipped.nu()[i]) + "," +
                                                            number_text(shipped.phi_deg()[k]) + ",",
                                                          0) == 0)
          text += line + "\n";
  const fs::path file = directory / "universal.csv";
  write_with_digest(file, text);
  ASSERT_EQ(UniversalTable::read(file).all().size(), 4 * shipped.load_level().size());
  read_all(file, 20183, [&] {
    const UniversalTable table = UniversalTable::read(file);
    for (const UniversalNode &node : table.all())
      EXPECT_TRUE(std::isfinite(node.a * node.b * node.m * node.n * node.approach));
    check(table);
  });
  EXPECT_GT(refused, files / 2);
}
