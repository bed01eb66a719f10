// The readers of database/ and of the contact law's header, given altered files.

#include "database/contact_law/contact_law.h"
#include "database/files/digest.h"
#include "database/rows/checks.h"
#include "database/rows/exports.h"
#include "database/rows/row_json.h"
#include "database/rows/row_store.h"
#include "database/rows/store.h"
#include "database/tables/lookup.h"
#include "database/tables/universal_checks.h"
#include "tests/support/fuzzing.h"
#include "tests/support/records.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <sstream>

using namespace dpcontact;
using namespace dpcontact::testing_fuzzing;
using nlohmann::json;

namespace
{
  void sign(const fs::path &file, const std::string &bytes)
  {
    write(file, bytes);
    write(digest_path_of(file), sha256(bytes) + "  " + file.filename().string() + "\n");
  }

  /// What `check` grades as an error must not be looked up.
  void require_refusal(const std::vector<Finding> &findings,
                       const LookupMethod          method,
                       const fs::path             &file)
  {
    if (findings.empty() || findings.front().grade != Grade::error)
      return;
    try
      {
        const LookupTable table(method, file);
      }
    catch (const Error &)
      {
        return;
      }
    throw Wrong("looked up although " + findings.front().where + ": " + findings.front().what);
  }

  Reader database_reader(const std::string              &name,
                         const fs::path                 &file,
                         const std::vector<std::string> &seeds)
  {
    return {name, file.extension() == ".csv", seeds, [file](const std::string &bytes) {
              sign(file, bytes);
              require_refusal(check(read_database(file)), LookupMethod::table_2, file);
            }};
  }

  Reader digest_reader(const fs::path &directory)
  {
    const fs::path    file = directory / "digest.csv";
    const std::string text = "x\n1\n", digest = sha256(text);
    return {"digest",
            true,
            {digest + "  digest.csv\n", digest + "  digest.csv\n" + sha256("") + "  digest.csv\n"},
            [file, text, digest](const std::string &bytes) {
              write(file, text);
              write(digest_path_of(file), bytes);
              if (read_with_digest(file) != text || bytes.find(digest) == std::string::npos)
                throw Wrong("accepted without its digest");
            }};
  }

  Reader universal_reader(const fs::path &directory, const std::string &seed)
  {
    const fs::path file = directory / "universal.csv";
    return {"universal", true, {seed}, [file](const std::string &bytes) {
              sign(file, bytes);
              const UniversalTable table = UniversalTable::read(file);
              require_refusal(check(table), LookupMethod::similarity, file);
            }};
  }

  /// The numbers of a table that a law takes, where `check` knows their ranges.
  void require_ranges(const ContactTable &table)
  {
    const std::pair<const char *, const std::vector<double> *> taken[] = {
      {"nu", &table.nu},
      {"phi_deg", &table.phi},
      {"load_level", &table.load_level},
      {"approach", &table.approach},
      {"m_law", &table.m},
      {"n_law", &table.n}};
    for (const auto &[name, values] : taken)
      for (const UniversalColumn &column : universal_columns())
        if (name == std::string(column.name))
          for (const double value : *values)
            {
              Findings findings;
              findings.check_number(name, value, column.range, "the table");
              if (!findings.sorted().empty())
                throw Wrong(findings.sorted().front().what);
            }
  }

  Reader contact_law_reader(const std::string &seed)
  {
    return {"contact_law", true, {seed}, [](const std::string &bytes) {
              ContactTable table;
              try
                {
                  std::istringstream text(bytes);
                  table = ContactTable::read(text);
                  const ContactLaw law =
                    ContactLaw::universal({1e10,
                                           (table.nu.front() + table.nu.back()) / 2,
                                           (table.phi.front() + table.phi.back()) / 2,
                                           1e7},
                                          table);
                  ContactState state;
                  for (const double overlap : {0.1, 1., 3., 30., 20., 1e4, 5e3, 0.})
                    if (const double force =
                          law.evaluate(overlap * law.approach_yield(0.05), 0.05, state).force;
                        !(force >= 0 && std::isfinite(force)))
                      throw Wrong("a force of " + std::to_string(force));
                }
              catch (const std::runtime_error &error) // all that the header throws
                {
                  throw CorruptData(error.what());
                }
              require_ranges(table);
            }};
  }

  /// Whether what nlohmann's library does recursively stays within the stack.
  bool is_flat(const std::string &text)
  {
    std::size_t depth = 0, deepest = 0;
    for (const char c : text)
      {
        depth += c == '[' || c == '{' ? 1 : 0;
        depth -= (c == ']' || c == '}') && depth > 0 ? 1 : 0;
        deepest = std::max(deepest, depth);
      }
    return deepest < 100;
  }

  /// A document of a content and its digest, as the row store writes it, if the content is JSON.
  std::string sealed(const std::string &content)
  {
    const json parsed =
      is_flat(content) ? json::parse(content, nullptr, false) : json(json::value_t::discarded);
    if (parsed.is_discarded())
      return "{\n \"content\": " + content + ",\n \"sha256\": \"" + sha256(content) + "\"\n}\n";
    return json{{"content", parsed}, {"sha256", sha256(parsed.dump())}}.dump(1) + "\n";
  }

  const json settings = {{"mode", "direct"}, {"resolution", 12}, {"list", {1, 2.5, "x"}}};

  /// Whether two documents hold other numbers, but for rounding; texts are made valid UTF-8.
  bool differ(const json &left, const json &right)
  {
    if (left.is_number() && right.is_number())
      return !is_close(left.get<double>(), right.get<double>(), 1e-12);
    if (!left.is_structured())
      return left.is_number() != right.is_number();
    for (const auto &entry : left.items())
      if (differ(entry.value(),
                 left.is_object() ? right.at(entry.key()) : right.at(std::stoul(entry.key()))))
        return true;
    return false;
  }

  Reader row_reader(const fs::path &directory, const std::vector<Record> &rows)
  {
    const fs::path           database = directory / "row.h5";
    std::vector<std::string> seeds;
    for (const Record &row : rows)
      seeds.push_back(to_json(row).dump(1));
    return {"row", true, seeds, [database, row = rows.front()](const std::string &content) {
              const RowStore store(database, settings);
              write(store.path_of(row.input), sealed(content));
              static_cast<void>(store.all());
              fs::remove_all(RowStore::directory_of(database));
              if (!is_flat(content))
                throw CorruptData("nested");
              const json parsed = json::parse(content, nullptr, false);
              const json again  = to_json(record_from_json(parsed));
              if (differ(again, parsed))
                throw Wrong("another number than in the file");
            }};
  }

  Reader settings_reader(const fs::path &directory)
  {
    const fs::path database = directory / "settings.h5";
    fs::create_directory(RowStore::directory_of(database));
    const json content = {{"schema_version", schema::version}, {"settings", settings}};
    return {"settings", true, {content.dump(1)}, [database](const std::string &text) {
              write(RowStore::directory_of(database) / "settings.json", sealed(text));
              const RowStore store(database, settings);
              if (json::parse(*RowStore::stored_settings(database)) != settings)
                throw Wrong("other settings were accepted");
            }};
  }

  std::vector<Reader> all_readers(const fs::path &directory)
  {
    const fs::path file = directory / "seed.csv";
    sign(file, read_whole(DPCONTACT_PAPERS_ROWS));
    Database rows = read_csv(file);
    rows.records.resize(3);
    Database curves{{rows.records[0], testing_database::any_record(2, 3)}, rows.provenance};
    curves.records[0].curve = curves.records[1].curve;
    write_store(directory / "seed.h5", curves);
    return {database_reader("csv", directory / "table.csv", {csv_text(rows)}),
            database_reader("h5", directory / "table.h5", {read_whole(directory / "seed.h5")}),
            digest_reader(directory),
            universal_reader(directory, few_families(read_whole(DPCONTACT_UNIVERSAL_TABLE))),
            contact_law_reader(read_whole(DPCONTACT_SMALL_TABLE)),
            row_reader(directory, curves.records),
            settings_reader(directory)};
  }
} // namespace

int main(int argc, char **argv)
{
  const Directory directory;
  return run(argc, argv, directory.path, all_readers(directory.path));
}
