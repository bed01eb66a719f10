#ifndef DPCONTACT_MESHING_MESH_KIND_H
#define DPCONTACT_MESHING_MESH_KIND_H

#include "meshing/errors.h"

#include <string>

namespace dpcontact
{
  /// The meshes that can be asked for by name.
  enum class MeshKind
  {
    fitted,   ///< zones fitted to the contact radius: zoned_mesh.h
    published ///< the three zones of Wang et al. 2018: published_mesh.h
  };

  inline const char *to_string(const MeshKind kind)
  {
    return kind == MeshKind::fitted ? "fitted" : "published";
  }

  /// @throws InputError where `name` is none of the names that to_string() gives.
  inline MeshKind parse_mesh_kind(const std::string &name)
  {
    for (const MeshKind kind : {MeshKind::fitted, MeshKind::published})
      if (name == to_string(kind))
        return kind;
    throw InputError("mesh = '" + name + "' is unknown; it must be 'fitted' or 'published'");
  }
} // namespace dpcontact

#endif
