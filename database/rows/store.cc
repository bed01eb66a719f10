#include "database/rows/store.h"

#include "database/files/digest.h"
#include "database/files/hdf5_handles.h"
#include "database/rows/read_in_child.h"
#include "database/rows/row_json.h"
#include "database/rows/schema.h"
#include "meshing/errors.h"

#include <nlohmann/json.hpp>

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
      auto dataset = hdf5::write_dataset(group, column.name, values);
      hdf5::write_attribute(dataset, "units", std::string(column.unit));
      hdf5::write_attribute(dataset, "description", std::string(column.description));
      dataset.close_now(std::string("finish the dataset ") + column.name);
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

    /// @throws hdf5::Failure where the dataset is not there, or is in another unit.
    template <typename T>
    std::vector<T> read_values(const hid_t group, const std::string &name, const std::string &unit)
    {
      const std::string said = hdf5::read_text_attribute(hdf5::open_dataset(group, name), "units");
      if (said != unit)
        throw hdf5::Failure(name + " is in '" + said + "', it should be in '" + unit + "'");
      return hdf5::read_dataset<T>(group, name);
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
      const auto values = read_values<T>(group, column.name, column.unit);
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

    /// @param column has a name and a unit.
    template <typename Points, typename Column, typename Member>
    void read_member(const hid_t   group,
                     const Column &column,
                     const Member  member,
                     const bool    first,
                     Points       &points)
    {
      using T           = decltype(value_type_of(member));
      const auto values = read_values<T>(group, column.name, column.unit);
      if (first)
        points.resize(values.size());
      if (values.size() != points.size())
        throw hdf5::Failure(std::string("the dataset ") + column.name +
                            " has another length than its neighbours");
      for (std::size_t i = 0; i < values.size(); ++i)
        points[i].*member = values[i];
    }

    void
    write_branch(const hid_t parent, const std::string &name, const std::vector<CurvePoint> &points)
    {
      auto group = hdf5::create_group(parent, name);
      for (const CurveQuantity &quantity : curve_quantities())
        std::visit([&](const auto member) { write_member(group, quantity, member, points); },
                   quantity.member);
      group.close_now("finish the group " + name);
    }

    std::vector<CurvePoint> read_branch(const hid_t parent, const std::string &name)
    {
      const auto              group = hdf5::open_group(parent, name);
      std::vector<CurvePoint> points;
      bool                    first = true;
      for (const CurveQuantity &quantity : curve_quantities())
        {
          std::visit(
            [&](const auto member) { read_member(group, quantity, member, first, points); },
            quantity.member);
          first = false;
        }
      return points;
    }

    void write_rows(const hid_t file, const std::vector<Record> &records)
    {
      auto rows = hdf5::create_group(file, "rows");
      for (const auto &column : schema::columns())
        with_type_of(column, [&](const auto &example) {
          write_column<std::decay_t<decltype(example)>>(rows, column, records);
        });
      rows.close_now("finish the group rows");
    }

    void write_curves(const hid_t file, const std::vector<Record> &records)
    {
      auto curves = hdf5::create_group(file, "curves");
      for (std::size_t i = 0; i < records.size(); ++i)
        {
          auto group = hdf5::create_group(curves, std::to_string(i));
          write_branch(group, "loading", records[i].curve.loading);
          write_branch(group, "unloading", records[i].curve.unloading);
          auto profile = hdf5::create_group(group, "profile");
          for (const auto &column : schema::profile_columns())
            write_member(profile, column, column.member, records[i].peak_profile);
          profile.close_now("finish the group profile");
          group.close_now("finish the group of a row's curves");
        }
      curves.close_now("finish the group curves");
    }

    /// The bytes of the file.
    std::string image_of(const Database &database)
    {
      hdf5::NewFile file;
      hdf5::write_attribute(file, "title", std::string(database_title));
      hdf5::write_attribute(file, "schema_version", schema::version);
      auto provenance = hdf5::create_group(file, "provenance");
      for (const auto &[name, text] : database.provenance)
        hdf5::write_attribute(provenance, name, clean_text(text));
      provenance.close_now("finish the group provenance");
      write_rows(file, database.records);
      write_curves(file, database.records);
      return file.close();
    }

    Database read_content(const fs::path &path, const std::string &bytes)
    {
      const auto file = hdf5::open_image(bytes);
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
              read_member(profile, column, column.member, first, record.peak_profile);
              first = false;
            }
        }
      return database;
    }
  } // namespace

  namespace
  {
    /// What the bytes hold instead of the database, NaN being equal to NaN; empty if nothing.
    std::string difference(const Database &meant, const Database &found)
    {
      if (found.records.size() != meant.records.size())
        return std::to_string(found.records.size()) + " rows for " +
               std::to_string(meant.records.size());
      for (std::size_t i = 0; i < meant.records.size(); ++i)
        if (to_json(found.records[i]).dump() != to_json(meant.records[i]).dump())
          return "another row " + std::to_string(i);
      if (found.provenance.size() != meant.provenance.size())
        return "another provenance";
      for (const auto &[name, text] : meant.provenance)
        if (found.provenance.count(name) == 0 || found.provenance.at(name) != clean_text(text))
          return "another " + name;
      return {};
    }
  } // namespace

  void write_store(const fs::path &file, const Database &database)
  {
    std::string image;
    try
      {
        const hdf5::Silence silence;
        image                   = image_of(database);
        const std::string other = difference(database, read_content(file, image));
        if (!other.empty())
          throw hdf5::Failure("reading back gives " + other);
      }
    catch (const hdf5::Failure &failure)
      {
        throw FileError("cannot write " + file.string() + ": " + failure.what());
      }
    write_with_digest(file, image);
  }

  Database read_store(const fs::path &file)
  {
    const std::string bytes = read_with_digest(file);
    if (!begins_as_hdf5(bytes))
      throw CorruptData(file.string() +
                        " is not a database of this program: it is no HDF5 file, as `dpcontact "
                        "sweep` writes it (.h5); a CSV table has no curves");
    // Whoever alters a file can renew its digest.
    const ChildReading reading = read_in_child(file, bytes);
    if (reading.code == ExitCode::settings_mismatch)
      throw SettingsMismatch(reading.text);
    if (reading.code != ExitCode::success)
      throw CorruptData(reading.text);
    return read_store_unchecked(file, bytes);
  }

  Database read_store_unchecked(const fs::path &file, const std::string &bytes)
  {
    try
      {
        const hdf5::Silence silence;
        return read_content(file, bytes);
      }
    catch (const hdf5::Failure &failure)
      {
        throw CorruptData(file.string() + " is not a database of this program: " + failure.what());
      }
  }
} // namespace dpcontact
