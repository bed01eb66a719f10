#ifndef DPCONTACT_DATABASE_ROWS_ROW_STORE_H
#define DPCONTACT_DATABASE_ROWS_ROW_STORE_H

#include "database/rows/record.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dpcontact
{
  /// Finished rows, one synced file each, so that a kill at any moment loses only rows in progress.
  ///
  /// The directory `<database>.rows` holds `settings.json` and one `<key>.json` per row, the key
  /// being a digest of the inputs and the settings. Files appear under their names complete or not
  /// at all. Several processes may read and write at the same time.
  class RowStore
  {
  public:
    using Reporter = std::function<void(const std::string &)>;

    /// Opens the rows of @p database, creating the directory if needed (not its parent). Settings
    /// that are not stored yet are written under the lock.
    /// @param settings an object with everything the rows depend on besides their inputs.
    /// @param report is told about damaged rows that were set aside.
    /// @throws SettingsMismatch printing both values of every entry that differs, FileError where
    /// the directory cannot be made, read or written, CorruptData where its settings are damaged.
    RowStore(const std::filesystem::path &database,
             const nlohmann::json        &settings,
             Reporter                     report = {});

    /// `<database>.rows`
    static std::filesystem::path directory_of(const std::filesystem::path &database);

    /// The same checks as the constructor, changing nothing on disk. A directory that does not
    /// exist yet matches everything.
    static void check_settings(const std::filesystem::path &database,
                               const nlohmann::json        &settings);

    /// The settings that the rows of @p database were made with; nothing if there are none yet.
    static std::optional<std::string> stored_settings(const std::filesystem::path &database);

    /// The finished row of this case (its status may be "failed"), or nothing. A damaged file is
    /// renamed to `<key>.json.damaged[.k]`, reported, and counts as not done.
    std::optional<Record> find(const Case &input) const;

    /// All finished rows, whatever their inputs, in the order of names(); damaged ones as in
    /// find().
    std::vector<Record> all() const;

    /// Stores a row durably, replacing the one of the same case. @throws FileError.
    void write(const Record &record) const;

    /// Forgets the row of a case. @throws FileError.
    void remove(const Case &input) const;

    /// The file that holds the row of this case.
    std::filesystem::path path_of(const Case &input) const;

    /// The names of all row files, whatever their inputs, sorted.
    std::vector<std::string> names() const;

    /// Keeps other processes from taking the same lock; released with the object or the process,
    /// not inherited by forked children.
    class Lock
    {
    public:
      ~Lock();
      Lock(Lock &&other) noexcept;
      Lock(const Lock &)            = delete;
      Lock &operator=(const Lock &) = delete;
      Lock &operator=(Lock &&)      = delete;

    private:
      friend class RowStore;
      explicit Lock(int descriptor);
      int descriptor;
    };

    /// Claims the rows for one sweep and removes the temporary files that killed ones left among
    /// the rows and beside the database.
    /// @throws FileError naming the process that holds the lock. A file system without locks is
    /// reported, and nothing keeps others away.
    Lock lock() const;

  private:
    std::optional<Record> read(const std::filesystem::path &file) const;

    std::filesystem::path directory;
    std::string           settings_text;
    Reporter              report;
  };
} // namespace dpcontact

#endif
