#include "database/rows/row_store.h"

#include "database/files/digest.h"
#include "database/files/files.h"
#include "database/files/json_text.h"
#include "database/rows/identity.h"
#include "database/rows/row_json.h"
#include "database/rows/schema.h"
#include "meshing/errors.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>
#include <utility>

namespace dpcontact
{
  namespace
  {
    namespace fs = std::filesystem;
    using nlohmann::json;

    /// A document that can tell whether it is whole: its content and the digest of it.
    std::string seal(const json &content)
    {
      return json{{"content", content}, {"sha256", sha256(content.dump())}}.dump(1) + "\n";
    }

    /// @throws CorruptData unless @p text is what seal() made of some content, byte for byte.
    json unseal(const std::string &text)
    {
      const json document = parse_json<json>(text, "it");
      if (!document.is_object() || !document.contains("content") || !document.contains("sha256"))
        throw CorruptData("it is not a complete JSON document with a content and its digest");
      const json &content = document["content"];
      if (document["sha256"] != sha256(content.dump()) || seal(content) != text)
        throw CorruptData("its content does not match its digest");
      return content;
    }

    /// What a row depends on, and what a reader must agree with.
    json versioned(const json &settings)
    {
      // through text, so that both sides of a comparison have passed the same conversions
      return json::parse(json{{"schema_version", schema::version}, {"settings", settings}}.dump());
    }

    std::optional<json> read_settings(const fs::path &directory)
    {
      const fs::path file = directory / "settings.json";
      if (!fs::exists(file))
        return std::nullopt;
      try
        {
          return unseal(read_file(file));
        }
      catch (const CorruptData &error)
        {
          throw CorruptData(file.string() + " is damaged: " + error.what() +
                            "; move the directory away to start anew");
        }
    }

    /// @throws SettingsMismatch with one line for every entry that differs.
    void compare(const fs::path &directory, const json &stored, const json &given)
    {
      std::string text;
      for (const JsonDifference &entry : differences(stored, given))
        text += "\n  /" + entry.name + ": stored " + entry.left + ", now " + entry.right;
      if (!text.empty())
        throw SettingsMismatch("the rows in " + directory.string() +
                               " were made with other settings:" + text +
                               "\nUse these settings again, or another database.");
    }

    /// Sets a damaged file aside under a name that is free.
    fs::path set_aside(const fs::path &file)
    {
      fs::path aside = file.string() + ".damaged";
      for (unsigned int i = 2; fs::exists(aside); ++i)
        aside = file.string() + ".damaged." + std::to_string(i);
      std::error_code error;
      fs::rename(file, aside, error);
      if (error)
        throw FileError("cannot set " + file.string() + " aside: " + error.message());
      return aside;
    }
  } // namespace

  RowStore::RowStore(const fs::path &database, const json &settings, Reporter reporter)
    : directory(directory_of(database))
    , report(std::move(reporter))
  {
    std::error_code error;
    fs::create_directory(directory, error);
    if (!fs::is_directory(directory, error))
      throw FileError("cannot create the directory " + directory.string() + ": " +
                      (error ? error.message() : "its place is taken"));

    const json given  = versioned(settings);
    auto       stored = read_settings(directory);
    if (!stored)
      {
        const Lock held = lock(); // somebody else may be about to write them
        stored          = read_settings(directory);
        if (!stored)
          write_file(directory / "settings.json", seal(given));
      }
    if (stored)
      compare(directory, *stored, given);
    settings_text = (stored ? *stored : given).dump();
  }

  fs::path RowStore::directory_of(const fs::path &database) { return database.string() + ".rows"; }

  void RowStore::check_settings(const fs::path &database, const json &settings)
  {
    const fs::path directory = directory_of(database);
    if (const auto stored = read_settings(directory))
      compare(directory, *stored, versioned(settings));
  }

  std::optional<std::string> RowStore::stored_settings(const fs::path &database)
  {
    const auto stored = read_settings(directory_of(database));
    if (!stored)
      return std::nullopt;
    return stored->at("settings").dump();
  }

  fs::path RowStore::path_of(const Case &input) const
  {
    const std::string digest = sha256(key_json(input).dump() + settings_text);
    return directory / (digest.substr(0, 32) + ".json");
  }

  std::optional<Record> RowStore::find(const Case &input) const
  {
    const fs::path file = path_of(input);
    return fs::exists(file) ? read(file) : std::nullopt;
  }

  std::optional<Record> RowStore::read(const fs::path &file) const
  {
    try
      {
        Record record = record_from_json(unseal(read_file(file)));
        if (path_of(record.input) != file)
          throw CorruptData("it holds the row of other inputs");
        return record;
      }
    catch (const CorruptData &error)
      {
        const fs::path aside = set_aside(file);
        if (report)
          report("the row file " + file.string() + " is damaged (" + error.what() +
                 "); it was renamed to " + aside.filename().string() +
                 " and its row counts as not done");
        return std::nullopt;
      }
  }

  void RowStore::write(const Record &record) const
  {
    write_file(path_of(record.input), seal(to_json(record)));
  }

  std::vector<Record> RowStore::all() const
  {
    std::vector<Record> rows;
    for (const std::string &name : names())
      if (auto row = read(directory / name))
        rows.push_back(std::move(*row));
    return rows;
  }

  void RowStore::remove(const Case &input) const
  {
    std::error_code error;
    fs::remove(path_of(input), error);
    if (error)
      throw FileError("cannot remove " + path_of(input).string() + ": " + error.message());
  }

  std::vector<std::string> RowStore::names() const
  {
    std::vector<std::string> found;
    std::error_code          error;
    for (const auto &entry : fs::directory_iterator(directory, error))
      if (entry.path().extension() == ".json" && entry.path().filename() != "settings.json")
        found.push_back(entry.path().filename().string());
    if (error)
      throw FileError("cannot list " + directory.string() + ": " + error.message());
    std::sort(found.begin(), found.end());
    return found;
  }

  RowStore::Lock::Lock(const int file)
    : descriptor(file)
  {}

  RowStore::Lock::Lock(Lock &&other) noexcept
    : descriptor(std::exchange(other.descriptor, -1))
  {}

  RowStore::Lock::~Lock()
  {
    if (descriptor >= 0)
      ::close(descriptor);
  }

  RowStore::Lock RowStore::lock() const
  {
    const fs::path file       = directory / "lock";
    const int      descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor < 0)
      throw FileError("cannot open " + file.string() + ": " + std::strerror(errno));
    Lock held(descriptor);

    struct flock region = {};
    region.l_type       = F_WRLCK;
    region.l_whence     = SEEK_SET;
    if (::fcntl(descriptor, F_SETLK, &region) != 0)
      {
        const int error = errno;
        region.l_type   = F_WRLCK;
        if (::fcntl(descriptor, F_GETLK, &region) == 0 && region.l_type != F_UNLCK)
          throw FileError("process " + std::to_string(region.l_pid) + " is working on " +
                          directory.string() + "; wait until it has ended");
        if (error != ENOSYS && error != ENOTSUP && error != ENOLCK)
          throw FileError("cannot lock " + file.string() + ": " + std::strerror(error));
        if (report)
          report("the file system of " + directory.string() +
                 " has no locks: see to it that no other process works on it");
      }

    const fs::path database = fs::path(directory).replace_extension();
    TemporaryFile::remove_all_leftovers(directory);
    TemporaryFile::remove_leftovers(database);
    TemporaryFile::remove_leftovers(digest_path_of(database));
    return held;
  }
} // namespace dpcontact
