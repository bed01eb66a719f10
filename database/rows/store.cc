#include "database/rows/store.h"

#include "database/files/digest.h"
#include "database/files/files.h"
#include "database/files/hdf5_handles.h"
#include "database/rows/read_in_child.h"
#include "database/rows/row_json.h"
#include "database/rows/schema.h"
#include "meshing/errors.h"

#include <algorithm>
#include <type_traits>

namespace dpcontact
{
  namespace
  {
    namespace fs = std::filesystem;

    /// T of a pointer to member T C::*.
    template <typename T, typename C>
    T value_type_of(T C::*);

    /// @param column has a name, a unit and a description.
    template <typename T, typename Column>
    void write_values(const hid_t group, const Column &column, const std::vector<T> &values)
    {
      const auto dataset = hdf5::write_dataset(group, column.name, values);
      hdf5::write_attribute(dataset, "units", std::string(column.unit));
      hdf5::write_attribute(dataset, "description", std::string(column.description));
    }

    template <typename Points, typename Column, typename Member>
    void
    write_member(const hid_t group, const Column &column, const Member member, const Points &points)
    {
      std::vector<decltype(value_type_of(member))> values;
      for (const auto &point : points)
        values.push_back(point.*member);
      write_values(group, column, values);
    }

    /// A column of all rows. T is the type of its cells.
    template <typename T>
    void write_column(const hid_t                group,
                      const schema::Column      &column,
                      const std::vector<Record> &records)
    {
      std::vector<T> values;
      for (const Record &record : records)
        values.push_back(std::get<T>(column.get(record)));
      if constexpr (std::is_same_v<T, std::string>)
        std::transform(values.begin(), values.end(), values.begin(), clean_text);
      write_values(group, column, values);
    }

    template <typename T>
    void read_column(const hid_t           group,
                     const schema::Column &column,
                     const bool            first,
                     std::vector<Record>  &records)
    {
      const auto values = hdf5::read_dataset<T>(group, column.name);
      if (first)
        records.resize(values.size());
      if (values.size() != records.size())
        throw hdf5::Failure("the dataset " + column.name +
                            " has another length than its neighbours");
      try
        {
          for (std::size_t i = 0; i < values.size(); ++i)
            schema::enter(column, values[i], records[i]);
        }
      catch (const CorruptData &error)
        {
          throw hdf5::Failure(error.what());
        }
    }

    /// Calls `act` with a value of the type of the column's cells.
    template <typename Act>
    void with_type_of(const schema::Column &column, const Act &act)
    {
      std::visit(act, column.get(Record()));
    }

    template <typename Points, typename Member>
    void read_member(const hid_t        group,
                     const std::string &name,
                     const Member       member,
                     const bool         first,
                     Points            &points)
    {
      using T           = decltype(value_type_of(member));
      const auto values = hdf5::read_dataset<T>(group, name);
      if (first)
        points.resize(values.size());
      if (values.size() != points.size())
        throw hdf5::Failure("the dataset " + name + " has another length than its neighbours");
      for (std::size_t i = 0; i < values.size(); ++i)
        points[i].*member = values[i];
    }

    void
    write_branch(const hid_t parent, const std::string &name, const std::vector<CurvePoint> &points)
    {
      const auto group = hdf5::create_group(parent, name);
      for (const CurveQuantity &quantity : curve_quantities())
        std::visit([&](const auto member) { write_member(group, quantity, member, points); },
                   quantity.member);
    }

    std::vector<CurvePoint> read_branch(const hid_t parent, const std::string &name)
    {
      const auto              group = hdf5::open_group(parent, name);
      std::vector<CurvePoint> points;
      bool                    first = true;
      for (const CurveQuantity &quantity : curve_quantities())
        {
          std::visit(
            [&](const auto member) { read_member(group, quantity.name, member, first, points); },
            quantity.member);
          first = false;
        }
      return points;
    }

    void write_content(const std::string &path, const Database &database)
    {
      auto file = hdf5::create_file(path);
      {
        hdf5::write_attribute(file, "title", std::string(database_title));
        hdf5::write_attribute(file, "schema_version", schema::version);

        const auto provenance = hdf5::create_group(file, "provenance");
        for (const auto &[name, text] : database.provenance)
          hdf5::write_attribute(provenance, name, clean_text(text));

        const auto rows = hdf5::create_group(file, "rows");
        for (const auto &column : schema::columns())
          with_type_of(column, [&](const auto &example) {
            write_column<std::decay_t<decltype(example)>>(rows, column, database.records);
          });

        const auto curves = hdf5::create_group(file, "curves");
        for (std::size_t i = 0; i < database.records.size(); ++i)
          {
            const Record &record = database.records[i];
            const auto    group  = hdf5::create_group(curves, std::to_string(i));
            write_branch(group, "loading", record.curve.loading);
            write_branch(group, "unloading", record.curve.unloading);
            const auto profile = hdf5::create_group(group, "profile");
            for (const auto &column : schema::profile_columns())
              write_member(profile, column, column.member, record.peak_profile);
          }
      }
      file.close_now("finish the file");
    }

    Database read_content(const fs::path &path)
    {
      const auto file = hdf5::open_file(path.string());
      schema::check_version(path.string(),
                            std::to_string(hdf5::read_integer_attribute(file, "schema_version")));
      Database   database;
      const auto provenance = hdf5::open_group(file, "provenance");
      for (const auto &name : hdf5::attribute_names(provenance))
        database.provenance[name] = hdf5::read_text_attribute(provenance, name);

      const auto rows  = hdf5::open_group(file, "rows");
      bool       first = true;
      for (const auto &column : schema::columns())
        {
          with_type_of(column, [&](const auto &example) {
            read_column<std::decay_t<decltype(example)>>(rows, column, first, database.records);
          });
          first = false;
        }

      const auto curves = hdf5::open_group(file, "curves");
      for (std::size_t i = 0; i < database.records.size(); ++i)
        {
          Record    &record      = database.records[i];
          const auto group       = hdf5::open_group(curves, std::to_string(i));
          record.curve.loading   = read_branch(group, "loading");
          record.curve.unloading = read_branch(group, "unloading");
          const auto profile     = hdf5::open_group(group, "profile");
          first                  = true;
          for (const auto &column : schema::profile_columns())
            {
              read_member(profile, column.name, column.member, first, record.peak_profile);
              first = false;
            }
        }
      return database;
    }
  } // namespace

  void write_store(const fs::path &file, const Database &database)
  {
    TemporaryFile content(file);
    TemporaryFile digest(digest_path_of(file));
    content.write(""); // the system's own reason where the place cannot be written
    try
      {
        const hdf5::Silence silence;
        write_content(content.path().string(), database);
      }
    catch (const hdf5::Failure &failure)
      {
        throw FileError("cannot write " + file.string() + ": " + failure.what());
      }
    content.sync();
    digest.write(sha256_of_file(content.path()) + "  " + file.filename().string() + "\n");
    digest.sync();
    content.publish();
    digest.publish();
  }

  Database read_store(const fs::path &file)
  {
    check_digest(file);
    // Whoever alters a file can renew its digest.
    const ChildReading reading = read_in_child(file);
    if (reading.code == ExitCode::settings_mismatch)
      throw SettingsMismatch(reading.text);
    if (reading.code != ExitCode::success)
      throw CorruptData(reading.text);
    return read_store_unchecked(file);
  }

  Database read_store_unchecked(const fs::path &file)
  {
    try
      {
        const hdf5::Silence silence;
        return read_content(file);
      }
    catch (const hdf5::Failure &failure)
      {
        throw CorruptData(file.string() + " is not a database of this program: " + failure.what());
      }
  }
} // namespace dpcontact
