// Opening what a file names: its own groups and datasets, and nothing that it points at elsewhere.
#include "database/files/hdf5_handles.h"

namespace dpcontact::hdf5
{
  namespace
  {
    [[noreturn]] void refuse(const std::string &name, const std::string &why)
    {
      throw Failure(name + " " + why + ", which this program never writes");
    }

    /// Soft and external links are followed when the object behind them is opened, so that they are
    /// asked for their kind before.
    void require_hard_link(const hid_t parent, const std::string &name)
    {
      H5L_info_t link;
      if (H5Lget_info(parent, name.c_str(), &link, H5P_DEFAULT) < 0)
        throw Failure("there is no " + name);
      if (link.type == H5L_TYPE_EXTERNAL)
        refuse(name, "is a link to another file");
      if (link.type != H5L_TYPE_HARD)
        refuse(name, "is a link to another name");
    }

    /// Storage outside the file is read, and filters are called, when the numbers are asked for;
    /// the sources of a virtual dataset as early as when it is asked for its size.
    void require_own_storage(const hid_t dataset, const std::string &name)
    {
      const Handle properties(H5Dget_create_plist(dataset), &H5Pclose, "open the dataset " + name);
      const H5D_layout_t layout = H5Pget_layout(properties);
      if (layout == H5D_VIRTUAL)
        refuse(name, "is a virtual dataset, made of others");
      if (layout != H5D_CHUNKED && layout != H5D_CONTIGUOUS)
        refuse(name, "has another layout");
      if (H5Pget_external_count(properties) != 0)
        refuse(name, "keeps its numbers in another file");
      const int filters = H5Pget_nfilters(properties);
      for (int i = 0; i < filters; ++i)
        {
          unsigned int flags = 0, configuration = 0;
          std::size_t  values = 0;
          if (H5Pget_filter2(properties,
                             static_cast<unsigned int>(i),
                             &flags,
                             &values,
                             nullptr,
                             0,
                             nullptr,
                             &configuration) != H5Z_FILTER_FLETCHER32)
            refuse(name, "passes a filter beside the checksum");
        }
    }
  } // namespace

  Handle open_group(const hid_t parent, const std::string &name)
  {
    require_hard_link(parent, name);
    return {H5Gopen2(parent, name.c_str(), H5P_DEFAULT), &H5Gclose, "open the group " + name};
  }

  Handle open_dataset(const hid_t parent, const std::string &name)
  {
    require_hard_link(parent, name);
    Handle dataset{
      H5Dopen2(parent, name.c_str(), H5P_DEFAULT), &H5Dclose, "open the dataset " + name};
    require_own_storage(dataset, name);
    return dataset;
  }
} // namespace dpcontact::hdf5
