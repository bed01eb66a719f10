#include "database/files/hdf5_handles.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <type_traits>

namespace dpcontact::hdf5
{
  namespace
  {
    /// Innermost entry of the library's error stack, which says most.
    std::string reason()
    {
      std::string text;
      const auto  take = [](unsigned int, const H5E_error2_t *entry, void *target) -> herr_t {
        auto &result = *static_cast<std::string *>(target);
        if (result.empty() && entry->desc != nullptr)
          result = entry->desc;
        return 0;
      };
      H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take, &text);
      return text.empty() ? "no reason given" : text;
    }

    void require(const bool ok, const std::string &what)
    {
      if (!ok)
        throw Failure("cannot " + what + " (HDF5: " + reason() + ")");
    }

    Handle property_list(const hid_t kind)
    {
      return {H5Pcreate(kind), &H5Pclose, "create a property list"};
    }

    Handle simple_space(const hsize_t size)
    {
      return {H5Screate_simple(1, &size, nullptr), &H5Sclose, "create a dataspace"};
    }

    Handle text_type(const std::size_t size)
    {
      Handle type(H5Tcopy(H5T_C_S1), &H5Tclose, "create a text type");
      require(H5Tset_size(type, size) >= 0 && H5Tset_cset(type, H5T_CSET_UTF8) >= 0 &&
                (size == H5T_VARIABLE || H5Tset_strpad(type, H5T_STR_NULLPAD) >= 0),
              "create a text type");
      return type;
    }

    template <typename T>
    hid_t native_type()
    {
      if constexpr (std::is_same_v<T, double>)
        return H5T_NATIVE_DOUBLE;
      else if constexpr (std::is_same_v<T, int>)
        return H5T_NATIVE_INT;
      else
        return H5T_NATIVE_UINT64;
    }

    template <typename T>
    hid_t stored_type()
    {
      if constexpr (std::is_same_v<T, double>)
        return H5T_IEEE_F64LE;
      else if constexpr (std::is_same_v<T, int>)
        return H5T_STD_I32LE;
      else
        return H5T_STD_U64LE;
    }

    /// Text side by side in cells of the longest entry's size.
    std::string pack(const std::vector<std::string> &values, const std::size_t size)
    {
      std::string cells(values.size() * size, '\0');
      for (std::size_t i = 0; i < values.size(); ++i)
        std::copy(values[i].begin(), values[i].end(), cells.begin() + static_cast<long>(i * size));
      return cells;
    }

    Handle
    create_dataset(const hid_t group, const std::string &name, const hid_t type, const hsize_t size)
    {
      const std::string what       = "create the dataset " + name;
      const Handle      properties = property_list(H5P_DATASET_CREATE);
      require(H5Pset_obj_track_times(properties, false) >= 0, what);
      if (size > 0) // an empty dataset has no chunk to check
        {
          const hsize_t chunk = std::min<hsize_t>(size, 65536);
          require(H5Pset_chunk(properties, 1, &chunk) >= 0 && H5Pset_fletcher32(properties) >= 0,
                  what);
        }
      return {
        H5Dcreate2(
          group, name.c_str(), type, simple_space(size), H5P_DEFAULT, properties, H5P_DEFAULT),
        &H5Dclose,
        what};
    }
  } // namespace

  Silence::Silence()
  {
    H5Eget_auto2(H5E_DEFAULT, &function, &data);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }

  Silence::~Silence() { H5Eset_auto2(H5E_DEFAULT, function, data); }

  Handle::Handle(const hid_t new_id, herr_t (*const closer)(hid_t), const std::string &what)
    : id(new_id)
    , close(closer)
  {
    require(id >= 0, what);
  }

  Handle::~Handle()
  {
    if (id >= 0)
      close(id);
  }

  void Handle::close_now(const std::string &what)
  {
    require(close(std::exchange(id, -1)) >= 0, what);
  }

  namespace
  {
    /// Of a file in memory alone.
    Handle access_to_memory()
    {
      constexpr std::size_t increment = 1 << 20; // bytes by which the memory grows
      Handle                access    = property_list(H5P_FILE_ACCESS);
      require(H5Pset_fapl_core(access, increment, /*backing_store=*/false) >= 0,
              "keep the file in memory");
      return access;
    }

    /// HDF5 takes files in memory that have the same name for the same file.
    std::string name_in_memory()
    {
      static std::atomic<unsigned long> count{0};
      return "database in memory " + std::to_string(count++);
    }
  } // namespace

  /// The library's memory of a file. The whole of it is seen only when the library gives it back:
  /// H5Fget_file_image() changes a flag in the superblock without its checksum.
  struct NewFile::Memory
  {
    std::size_t size = 0; ///< of the file before it is closed, which may make it smaller
    std::string bytes;

    /// The end of the file as the superblock has it (version 2 or 3 of it, section II.A of the
    /// format's specification), eight bytes of which the first counts least.
    static std::size_t end_of_file(const unsigned char *image)
    {
      constexpr std::size_t at   = 28;
      std::size_t           size = 0;
      for (std::size_t i = 8; i-- > 0;)
        size = 256 * size + image[at + i];
      return size;
    }

    static void *allocate(const std::size_t size, H5FD_file_image_op_t, void *)
    {
      return std::malloc(size);
    }

    static void *
    copy(void *target, const void *source, const std::size_t size, H5FD_file_image_op_t, void *)
    {
      return std::memcpy(target, source, size);
    }

    static void *resize(void *old, const std::size_t size, H5FD_file_image_op_t, void *)
    {
      return std::realloc(old, size);
    }

    static herr_t release(void *image, const H5FD_file_image_op_t when, void *owner)
    {
      auto &memory = *static_cast<Memory *>(owner);
      if (when == H5FD_FILE_IMAGE_OP_FILE_CLOSE)
        memory.bytes.assign(
          static_cast<const char *>(image),
          memory.size == 0
            ? 0
            : std::min(memory.size, end_of_file(static_cast<const unsigned char *>(image))));
      std::free(image);
      return 0;
    }

    static void  *share(void *owner) { return owner; }
    static herr_t leave(void *) { return 0; }
  };

  namespace
  {
    Handle create_in_memory(H5FD_file_image_callbacks_t callbacks)
    {
      const Handle access   = access_to_memory();
      const Handle creation = property_list(H5P_FILE_CREATE);
      require(
        H5Pset_file_image_callbacks(access, &callbacks) >= 0 &&
          H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110) >= 0 &&
          H5Pset_obj_track_times(creation, false) >= 0 &&
          H5Pset_link_creation_order(creation, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED) >= 0,
        "prepare the file");
      return {H5Fcreate(name_in_memory().c_str(), H5F_ACC_TRUNC, creation, access),
              &H5Fclose,
              "create the file"};
    }
  } // namespace

  NewFile::NewFile()
    : memory(std::make_unique<Memory>())
    , file(create_in_memory({&Memory::allocate,
                             &Memory::copy,
                             &Memory::resize,
                             &Memory::release,
                             &Memory::share,
                             &Memory::leave,
                             memory.get()}))
  {}

  NewFile::~NewFile() = default;

  std::string NewFile::close()
  {
    require(H5Fflush(file, H5F_SCOPE_GLOBAL) >= 0, "finish the file");
    const ssize_t size = H5Fget_file_image(file, nullptr, 0);
    require(size > 0, "finish the file");
    memory->size = static_cast<std::size_t>(size);
    file.close_now("finish the file");
    return std::move(memory->bytes);
  }

  Handle open_image(const std::string &bytes)
  {
    const Handle access = access_to_memory();
    std::string  copy   = bytes; // HDF5 takes a pointer to what may be written
    // A filter that the library does not have would be looked for among plugins and run.
    require(H5PLset_loading_state(0) >= 0, "keep HDF5 from loading plugins");
    require(!copy.empty() && H5Pset_file_image(access, copy.data(), copy.size()) >= 0,
            "open the file");
    return {H5Fopen(name_in_memory().c_str(), H5F_ACC_RDONLY, access), &H5Fclose, "open the file"};
  }

  Handle create_group(const hid_t parent, const std::string &name)
  {
    const std::string what       = "create the group " + name;
    const Handle      properties = property_list(H5P_GROUP_CREATE);
    require(
      H5Pset_obj_track_times(properties, false) >= 0 &&
        H5Pset_link_creation_order(properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED) >= 0,
      what);
    return {
      H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, properties, H5P_DEFAULT), &H5Gclose, what};
  }

  void write_attribute(const hid_t object, const std::string &name, const std::string &text)
  {
    const std::string what = "write the attribute " + name;
    const Handle      type = text_type(H5T_VARIABLE); // h5py gives these as str
    const Handle      space(H5Screate(H5S_SCALAR), &H5Sclose, what);
    Handle            attribute(
      H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), &H5Aclose, what);
    const char *const characters = text.c_str();
    require(H5Awrite(attribute, type, &characters) >= 0, what);
    attribute.close_now(what);
  }

  void write_attribute(const hid_t object, const std::string &name, const int value)
  {
    const std::string what = "write the attribute " + name;
    const Handle      space(H5Screate(H5S_SCALAR), &H5Sclose, what);
    Handle            attribute(
      H5Acreate2(object, name.c_str(), H5T_STD_I32LE, space, H5P_DEFAULT, H5P_DEFAULT),
      &H5Aclose,
      what);
    require(H5Awrite(attribute, H5T_NATIVE_INT, &value) >= 0, what);
    attribute.close_now(what);
  }

  int read_integer_attribute(const hid_t object, const std::string &name)
  {
    const std::string what = "read the attribute " + name;
    const Handle      attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), &H5Aclose, what);
    const Handle      space(H5Aget_space(attribute), &H5Sclose, what);
    int               value = 0;
    require(H5Sget_simple_extent_npoints(space) == 1 &&
              H5Aread(attribute, H5T_NATIVE_INT, &value) >= 0,
            what);
    return value;
  }

  std::string read_text_attribute(const hid_t object, const std::string &name)
  {
    const std::string what = "read the attribute " + name;
    const Handle      attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), &H5Aclose, what);
    const Handle      space(H5Aget_space(attribute), &H5Sclose, what);
    const Handle      type(H5Aget_type(attribute), &H5Tclose, what);
    require(H5Sget_simple_extent_npoints(space) == 1 && H5Tis_variable_str(type) > 0, what);
    char *characters = nullptr;
    require(H5Aread(attribute, text_type(H5T_VARIABLE), &characters) >= 0, what);
    std::string text = characters == nullptr ? "" : characters;
    H5free_memory(characters);
    return text;
  }

  std::vector<std::string> attribute_names(const hid_t object)
  {
    std::vector<std::string> names;
    const auto take = [](hid_t, const char *name, const H5A_info_t *, void *target) -> herr_t {
      static_cast<std::vector<std::string> *>(target)->emplace_back(name);
      return 0;
    };
    require(H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, take, &names) >= 0,
            "list the attributes");
    return names;
  }

  template <typename T>
  Handle write_dataset(const hid_t group, const std::string &name, const std::vector<T> &values)
  {
    const std::string what = "write the dataset " + name;
    if constexpr (std::is_same_v<T, std::string>)
      {
        std::size_t size = 1;
        for (const auto &value : values)
          size = std::max(size, value.size());
        const Handle type    = text_type(size);
        Handle       dataset = create_dataset(group, name, type, values.size());
        require(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, pack(values, size).data()) >=
                  0,
                what);
        return dataset;
      }
    else
      {
        Handle dataset = create_dataset(group, name, stored_type<T>(), values.size());
        require(H5Dwrite(dataset, native_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >=
                  0,
                what);
        return dataset;
      }
  }

  template <typename T>
  std::vector<T> read_dataset(const hid_t group, const std::string &name)
  {
    const std::string what    = "read the dataset " + name;
    const Handle      dataset = open_dataset(group, name);
    const Handle      space(H5Dget_space(dataset), &H5Sclose, what);
    const Handle      type(H5Dget_type(dataset), &H5Tclose, what);
    require(H5Sget_simple_extent_ndims(space) == 1, what);
    const auto size = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space));
    // Before memory is asked for.
    const std::size_t width = H5Tget_size(type);
    require(width > 0 && size <= H5Dget_storage_size(dataset) / width, what);
    if constexpr (std::is_same_v<T, std::string>)
      {
        require(H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0, what);
        std::string cells(size * width, '\0');
        require(H5Dread(dataset, text_type(width), H5S_ALL, H5S_ALL, H5P_DEFAULT, cells.data()) >=
                  0,
                what);
        std::vector<std::string> values(size);
        for (std::size_t i = 0; i < size; ++i)
          values[i] = std::string(cells, i * width, width).c_str(); // up to the padding
        return values;
      }
    else
      {
        require(H5Tequal(type, stored_type<T>()) > 0, what);
        std::vector<T> values(size);
        require(H5Dread(dataset, native_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >=
                  0,
                what);
        return values;
      }
  }

  template Handle write_dataset(hid_t, const std::string &, const std::vector<double> &);
  template Handle write_dataset(hid_t, const std::string &, const std::vector<int> &);
  template Handle write_dataset(hid_t, const std::string &, const std::vector<std::uint64_t> &);
  template Handle write_dataset(hid_t, const std::string &, const std::vector<std::string> &);
  template std::vector<double>        read_dataset(hid_t, const std::string &);
  template std::vector<int>           read_dataset(hid_t, const std::string &);
  template std::vector<std::uint64_t> read_dataset(hid_t, const std::string &);
  template std::vector<std::string>   read_dataset(hid_t, const std::string &);
} // namespace dpcontact::hdf5
