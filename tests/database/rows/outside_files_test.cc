// Databases that point outside themselves, signed again: to other files, other names, and code.
#include "database/files/digest.h"
#include "database/files/hdf5_handles.h"
#include "database/rows/store.h"
#include "meshing/errors.h"
#include "tests/support/records.h"

#include <chrono>
#include <sys/stat.h>

using namespace dpcontact;
using namespace dpcontact::testing_database;

namespace
{
  using hdf5::Handle;

  class OutsideFiles : public InDirectory
  {
  protected:
    OutsideFiles()
    {
      for (std::size_t i = 0; i < rows; ++i)
        database.records.push_back(any_record(2 * i));
      database.provenance = {{"input", "any"}};
      write_store(file, database);
      spill(secret, "root:x:0:0:root:/root:/bin/bash\ndaemon:x:1:1:daemon:/usr/sbin:/bin/sh\n");
    }

    /// Puts something else in the place of `/rows/<name>` and signs the file.
    template <typename Put>
    void replace(const std::string &group_name, const std::string &name, const Put &put)
    {
      {
        const Handle open(
          H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), &H5Fclose, "open the file");
        const Handle group(
          H5Gopen2(open, group_name.c_str(), H5P_DEFAULT), &H5Gclose, "open the group");
        ASSERT_GE(H5Ldelete(group, name.c_str(), H5P_DEFAULT), 0);
        put(static_cast<hid_t>(group), name.c_str());
      }
      spill(file.string() + ".sha256",
            sha256_of_file(file) + "  " + file.filename().string() + "\n");
    }

    /// A dataset of as many numbers as the database has rows.
    template <typename Prepare>
    void create(const hid_t group, const char *name, const hid_t type, const Prepare &prepare)
    {
      const Handle properties(H5Pcreate(H5P_DATASET_CREATE), &H5Pclose, "create properties");
      const Handle space(H5Screate_simple(1, &rows, nullptr), &H5Sclose, "create a space");
      prepare(static_cast<hid_t>(properties));
      Handle dataset(H5Dcreate2(group, name, type, space, H5P_DEFAULT, properties, H5P_DEFAULT),
                     &H5Dclose,
                     "create a dataset");
      dataset.close_now("close a dataset");
    }

    void expect_refused(const std::string &what)
    {
      const auto        start   = std::chrono::steady_clock::now();
      const std::string message = message_of<CorruptData>([this] { read_store(file); });
      EXPECT_NE(message.find(file.string() + " is not a database of this program: "),
                std::string::npos)
        << message;
      EXPECT_NE(message.find(what), std::string::npos) << message;
      EXPECT_EQ(message.find("root:"), std::string::npos) << message;
      EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
      // and in this process, which reads the bytes once the other has done so
      EXPECT_THROW(read_store_unchecked(file, slurp(file)), CorruptData);
    }

    static constexpr hsize_t rows = 3;

    Database       database;
    const fs::path file = directory / "table.h5", secret = directory / "passwd";
  };
} // namespace

TEST_F(OutsideFiles, TextOfAnotherFileIsNoColumn)
{
  const Handle type(H5Tcopy(H5T_C_S1), &H5Tclose, "create a type");
  ASSERT_GE(H5Tset_size(type, 16), 0);
  replace("rows", "warnings", [&](const hid_t group, const char *name) {
    create(group, name, type, [this](const hid_t properties) {
      ASSERT_GE(H5Pset_external(properties, secret.c_str(), 0, 16 * rows), 0);
    });
  });
  expect_refused("warnings keeps its numbers in another file");
}

TEST_F(OutsideFiles, ALinkToAnotherDatabaseIsNoColumnAndNoGroup)
{
  fs::copy_file(file, directory / "other.h5");
  for (const auto &[group, name, target] : {std::tuple("rows", "a", "/rows/a"),
                                            {"curves/0", "loading", "/curves/0/loading"},
                                            {"/", "rows", "/rows"},
                                            {"/", "provenance", "/provenance"}})
    {
      write_store(file, database);
      replace(group, name, [&, to = target](const hid_t in, const char *link) {
        ASSERT_GE(H5Lcreate_external(
                    (directory / "other.h5").c_str(), to, in, link, H5P_DEFAULT, H5P_DEFAULT),
                  0);
      });
      expect_refused(std::string(name) + " is a link to another file");
    }
}

TEST_F(OutsideFiles, APipeBehindALinkIsNotOpened)
{
  const fs::path pipe = directory / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  replace("rows", "a", [&](const hid_t group, const char *name) {
    ASSERT_GE(H5Lcreate_external(pipe.c_str(), "/a", group, name, H5P_DEFAULT, H5P_DEFAULT), 0);
  });
  expect_refused("a is a link to another file");
  write_store(file, database);
  replace("rows", "a", [&](const hid_t group, const char *name) {
    create(group, name, H5T_IEEE_F64LE, [&](const hid_t properties) {
      ASSERT_GE(H5Pset_external(properties, pipe.c_str(), 0, 8 * rows), 0);
    });
  });
  expect_refused("a keeps its numbers in another file");
}

TEST_F(OutsideFiles, ALinkToAnotherNameIsNoColumn)
{
  replace("rows", "a", [](const hid_t group, const char *name) {
    ASSERT_GE(H5Lcreate_soft("/rows/b", group, name, H5P_DEFAULT, H5P_DEFAULT), 0);
  });
  expect_refused("a is a link to another name");
}

TEST_F(OutsideFiles, ADatasetMadeOfOthersIsNoColumn)
{
  fs::copy_file(file, directory / "other.h5");
  const Handle space(H5Screate_simple(1, &rows, nullptr), &H5Sclose, "create a space");
  for (const std::string &source : {(directory / "other.h5").string(), std::string(".")})
    {
      write_store(file, database);
      replace("rows", "a", [&](const hid_t group, const char *name) {
        create(group, name, H5T_IEEE_F64LE, [&](const hid_t properties) {
          ASSERT_GE(H5Pset_virtual(properties, space, source.c_str(), "/rows/b", space), 0);
        });
      });
      expect_refused("a is a virtual dataset");
    }
}

TEST_F(OutsideFiles, AFilterBesideTheChecksumIsNotCalled)
{
  // One that the library has, and one that it would look for among plugins.
  for (const H5Z_filter_t filter : {H5Z_FILTER_SHUFFLE, H5Z_filter_t(32001)})
    {
      write_store(file, database);
      replace("rows", "a", [&](const hid_t group, const char *name) {
        create(group, name, H5T_IEEE_F64LE, [&](const hid_t properties) {
          ASSERT_GE(H5Pset_chunk(properties, 1, &rows), 0);
          ASSERT_GE(H5Pset_filter(properties, filter, H5Z_FLAG_OPTIONAL, 0, nullptr), 0);
        });
      });
      expect_refused("a passes a filter beside the checksum");
    }
}

TEST_F(OutsideFiles, NoPluginIsLoadedOnceAFileWasOpened)
{
  ASSERT_GE(H5PLset_loading_state(H5PL_ALL_PLUGIN), 0);
  read_store_unchecked(file, slurp(file));
  unsigned int state = H5PL_ALL_PLUGIN;
  ASSERT_GE(H5PLget_loading_state(&state), 0);
  EXPECT_EQ(state, 0u);
}
