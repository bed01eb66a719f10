#include "runs/sweep/merge.h"

#include "database/files/digest.h"
#include "database/rows/row.h"
#include "database/rows/row_json.h"
#include "database/rows/row_store.h"
#include "meshing/errors.h"
#include "runs/interface/documents.h"
#include "runs/sweep/assembly.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>

namespace dpcontact
{
  namespace
  {
    namespace fs = std::filesystem;

    /// The database whose rows a path names: `X.h5.rows` and `X.h5` are the same.
    fs::path database_of(const fs::path &path)
    {
      const fs::path plain = path.has_filename() ? path : path.parent_path(); // no slash at the end
      return plain.extension() == ".rows" ? fs::path(plain).replace_extension() : plain;
    }

    bool is_same(const fs::path &left, const fs::path &right)
    {
      std::error_code error;
      return fs::equivalent(left, right, error);
    }

    /// The rows of one directory.
    struct Source
    {
      fs::path directory;
      RowStore rows;
    };

    Source open(const Sweep &sweep, const fs::path &database)
    {
      return {RowStore::directory_of(database), RowStore(database, row_settings(sweep), log_sweep)};
    }

    /// @throws FileError, CorruptData, SettingsMismatch as merge_shards().
    Source open_shard(const Sweep &sweep, const fs::path &path)
    {
      const fs::path database  = database_of(path);
      const fs::path directory = RowStore::directory_of(database);
      if (!fs::is_directory(directory))
        throw FileError("cannot merge " + path.string() + ": there is no directory " +
                        directory.string());
      if (!RowStore::stored_settings(database))
        throw CorruptData(directory.string() +
                          " holds no settings.json, so it is no row directory of a sweep");
      return open(sweep, database);
    }

    /// @throws SettingsMismatch where a shard holds rows that are not of the grid: they would be
    /// lost.
    void check_grid(const Sweep &sweep, const Source &source)
    {
      std::set<std::string> expected;
      for (const Case &input : sweep.cases)
        expected.insert(source.rows.path_of(input).filename().string());
      std::vector<std::string> foreign;
      for (const std::string &name : source.rows.names())
        if (expected.count(name) == 0)
          foreign.push_back(name);
      if (!foreign.empty())
        throw SettingsMismatch(source.directory.string() + " holds " +
                               std::to_string(foreign.size()) +
                               " rows that are not of this grid, the first in " + foreign.front() +
                               "; merge with the parameter file that the shard was made with");
    }

    /// What must be the same wherever a row was computed.
    nlohmann::json essence(const Record &row)
    {
      if (!row.converged())
        return "failed"; // the reason may be the machine's
      nlohmann::json entries = to_json(row);
      entries.erase("wall_seconds");
      entries.erase("peak_memory_bytes");
      return entries;
    }

    /// "a: 1.25 and 1.26, b: …" of two rows that differ.
    std::string differences(const nlohmann::json &left, const nlohmann::json &right)
    {
      constexpr std::size_t most = 4;
      std::string           text;
      std::size_t           found = 0;
      for (const auto &entry : left.items())
        if (entry.value() != right.at(entry.key()) && ++found <= most)
          text += (found == 1 ? "" : ", ") + entry.key() +
                  (entry.value().is_structured()
                     ? ""
                     : ": " + entry.value().dump() + " and " + right.at(entry.key()).dump());
      if (found > most)
        text += " and " + std::to_string(found - most) + " more";
      return text;
    }

    /// Where the row of a case is to be had.
    struct Choice
    {
      std::size_t source;
      bool        converged;
      std::string digest; ///< of its essence
    };

    /// Compares the rows of one case in all sources and chooses one. @throws CorruptData.
    std::optional<Choice>
    choose(const Case &input, const std::vector<Source> &sources, std::size_t &copies)
    {
      std::optional<Choice> best;
      for (std::size_t s = 0; s < sources.size(); ++s)
        {
          const auto row = sources[s].rows.find(input);
          if (!row)
            continue;
          ++copies;
          const Choice found{s, row->converged(), sha256(essence(*row).dump())};
          if (!best || (found.converged && !best->converged))
            best = found;
          else if (found.converged && found.digest != best->digest)
            throw CorruptData(
              "the rows of " + label(input) + " in " + sources[best->source].directory.string() +
              " and " + sources[s].directory.string() + " contradict each other (" +
              differences(essence(*sources[best->source].rows.find(input)), essence(*row)) +
              "); compute one of the two again and see which is right");
        }
      return best;
    }

    [[noreturn]] void throw_missing(const Sweep &sweep, const std::vector<std::size_t> &missing)
    {
      constexpr std::size_t most = 20;
      std::string           names;
      for (std::size_t k = 0; k < std::min(most, missing.size()); ++k)
        names += (k == 0 ? "" : "; ") + label(sweep.cases[missing[k]]);
      if (missing.size() > most)
        names += "; and " + std::to_string(missing.size() - most) + " more";
      throw Error(ExitCode::incomplete,
                  std::to_string(missing.size()) + " of " + std::to_string(sweep.cases.size()) +
                    " rows are missing; name all shards, and run those again that were stopped. "
                    "Missing: " +
                    names);
    }
  } // namespace

  MergeSummary merge_shards(const Sweep &sweep, const std::vector<fs::path> &shards)
  {
    check_database(sweep);
    RowStore::check_settings(sweep.database, row_settings(sweep));
    const fs::path      target = RowStore::directory_of(sweep.database);
    std::vector<Source> sources;
    for (const fs::path &path : shards)
      {
        Source source = open_shard(sweep, path);
        if (!is_same(source.directory, target))
          check_grid(sweep, source);
        const bool known = is_same(source.directory, target) ||
                           std::any_of(sources.begin(), sources.end(), [&](const Source &other) {
                             return is_same(source.directory, other.directory);
                           });
        if (!known)
          sources.push_back(std::move(source));
      }
    const std::size_t own = sources.size(); // the number of the target
    if (RowStore::stored_settings(sweep.database))
      sources.push_back(open(sweep, sweep.database));

    MergeSummary             summary;
    std::vector<Choice>      choices;
    std::vector<std::size_t> missing;
    for (std::size_t i = 0; i < sweep.cases.size(); ++i)
      {
        std::size_t copies = 0;
        if (const auto choice = choose(sweep.cases[i], sources, copies))
          choices.push_back(*choice);
        else
          missing.push_back(i);
        if (own < sources.size() && sources[own].rows.find(sweep.cases[i]))
          --copies; // not a shard's
        summary.duplicates += copies > 1;
      }
    if (!missing.empty())
      throw_missing(sweep, missing);
    if (summary.duplicates > 0)
      log_sweep(std::to_string(summary.duplicates) + " rows are in several shards, and alike");

    const RowStore       rows(sweep.database, row_settings(sweep), log_sweep);
    const RowStore::Lock lock = rows.lock();
    take_up_rows(sweep, rows);
    std::size_t added = 0;
    for (std::size_t i = 0; i < choices.size(); ++i)
      {
        const Case &inputs = sweep.cases[i];
        const auto  stored = rows.find(inputs);
        if (choices[i].source == own || (stored && (stored->converged() || !choices[i].converged)))
          continue;
        const auto row = sources[choices[i].source].rows.find(inputs);
        if (!row)
          throw FileError("the row of " + label(sweep.cases[i]) + " has vanished from " +
                          sources[choices[i].source].directory.string() + "; merge again");
        rows.write(*row);
        ++added;
      }
    log_sweep(std::to_string(added) + " rows merged into " + target.string() + ", " +
              std::to_string(choices.size() - added) + " were there");

    const Assembled assembled = assemble_database(sweep, rows);
    summary.rows              = sweep.cases.size();
    summary.converged         = assembled.converged;
    summary.failed            = assembled.failed;
    summary.kept              = assembled.kept;
    return summary;
  }
} // namespace dpcontact
