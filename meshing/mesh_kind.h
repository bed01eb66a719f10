#ifndef DPCONTACT_MESHING_MESH_KIND_H
#define DPCONTACT_MESHING_MESH_KIND_H

#include "meshing/enum_names.h"

namespace dpcontact
{
  /// The meshes that can be asked for by name.
  enum class MeshKind
  {
    fitted,   ///< zones fitted to the contact radius: zoned_mesh.h
    published ///< the three zones of Wang et al. 2018: published_mesh.h
  };

  template <>
  struct EnumNames<MeshKind>
  {
    static constexpr const char        *what     = "mesh";
    static constexpr EnumName<MeshKind> values[] = {{MeshKind::fitted, "fitted"},
                                                    {MeshKind::published, "published"}};
  };
} // namespace dpcontact

#endif
