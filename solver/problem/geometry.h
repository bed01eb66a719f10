#ifndef DPCONTACT_SOLVER_PROBLEM_GEOMETRY_H
#define DPCONTACT_SOLVER_PROBLEM_GEOMETRY_H

#include "meshing/enum_names.h"

namespace dpcontact
{
  /// How much of the bodies is modelled.
  enum class Geometry
  {
    axisymmetric, ///< the half plane r ≥ 0
    sector,       ///< a wedge in space between planes of symmetry
    disc,         ///< all of the body in space
    published     ///< a quarter of the body in space, on the mesh of Wang et al. 2018
  };

  inline bool in_space(const Geometry geometry) { return geometry != Geometry::axisymmetric; }

  template <>
  struct EnumNames<Geometry>
  {
    static constexpr const char        *what     = "geometry";
    static constexpr EnumName<Geometry> values[] = {{Geometry::axisymmetric, "axisymmetric"},
                                                    {Geometry::sector, "sector"},
                                                    {Geometry::disc, "disc"},
                                                    {Geometry::published, "published"}};
  };
} // namespace dpcontact

#endif
