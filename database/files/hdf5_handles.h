#ifndef DPCONTACT_DATABASE_FILES_HDF5_HANDLES_H
#define DPCONTACT_DATABASE_FILES_HDF5_HANDLES_H

#include <hdf5.h>

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// What the store needs of HDF5's C interface, with owned handles and exceptions.
namespace dpcontact::hdf5
{
  /// Says that a call of the library failed: what was tried, and the library's own innermost
  /// reason.
  struct Failure : std::runtime_error
  {
    using std::runtime_error::runtime_error;
  };

  /// Keeps the library from printing its error stack while it lives.
  class Silence
  {
  public:
    Silence();
    ~Silence();
    Silence(const Silence &)            = delete;
    Silence &operator=(const Silence &) = delete;

  private:
    H5E_auto2_t function = nullptr;
    void       *data     = nullptr;
  };

  /// An identifier that is closed with the object.
  class Handle
  {
  public:
    /// @throws Failure saying @p what could not be done where @p id is negative.
    Handle(hid_t id, herr_t (*close)(hid_t), const std::string &what);
    ~Handle();
    Handle(Handle &&other) noexcept
      : id(std::exchange(other.id, -1))
      , close(other.close)
    {}
    Handle(const Handle &)            = delete;
    Handle &operator=(const Handle &) = delete;
    Handle &operator=(Handle &&)      = delete;

    operator hid_t() const { return id; }

    /// Closes now, so that a failure is noticed. Whatever writes ends like this.
    void close_now(const std::string &what);

  private:
    hid_t id;
    herr_t (*close)(hid_t);
  };

  // All of the following throw Failure, saying what could not be done.

  // Files are images in memory: HDF5 opens, locks and writes nothing on disk, so that no fault of a
  // file system is its own.

  /// A new file in the 1.10 format, with checksums of metadata and without time stamps.
  class NewFile
  {
  public:
    NewFile();
    ~NewFile();
    NewFile(const NewFile &)            = delete;
    NewFile &operator=(const NewFile &) = delete;

    operator hid_t() const { return file; }

    /// Closes the file, once all its groups and datasets are closed. @return its bytes.
    std::string close();

  private:
    struct Memory;
    std::unique_ptr<Memory> memory;
    Handle                  file;
  };

  /// Opens the bytes of a file for reading. From then on HDF5 loads no plugins.
  Handle open_image(const std::string &bytes);

  /// Makes a group that lists its entries and attributes in the order of their creation.
  Handle create_group(hid_t parent, const std::string &name);

  /// Only what lies in the file itself: an object that its parent holds, without a link to another
  /// name or file; of a dataset all numbers, behind no filter but HDF5's checksum. Failure says
  /// what else it is, before anything outside is touched.
  Handle open_group(hid_t parent, const std::string &name);
  Handle open_dataset(hid_t parent, const std::string &name);

  void        write_attribute(hid_t object, const std::string &name, const std::string &text);
  void        write_attribute(hid_t object, const std::string &name, int value);
  int         read_integer_attribute(hid_t object, const std::string &name);
  std::string read_text_attribute(hid_t object, const std::string &name);
  std::vector<std::string> attribute_names(hid_t object);

  /// One-dimensional datasets with HDF5's own checksum (fletcher32); text is fixed-length UTF-8
  /// padded with NUL. T is double, std::uint64_t, int or std::string.
  template <typename T>
  Handle write_dataset(hid_t group, const std::string &name, const std::vector<T> &values);
  template <typename T>
  std::vector<T> read_dataset(hid_t group, const std::string &name);
} // namespace dpcontact::hdf5

#endif
