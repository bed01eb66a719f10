#ifndef DPCONTACT_SOLVER_GEOMETRY_H
#define DPCONTACT_SOLVER_GEOMETRY_H

#include "meshing/errors.h"

#include <cmath>
#include <string>

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

  /// The name by which a geometry is asked for.
  inline const char *to_string(const Geometry geometry)
  {
    return geometry == Geometry::axisymmetric ? "axisymmetric"
           : geometry == Geometry::sector     ? "sector"
           : geometry == Geometry::disc       ? "disc"
                                              : "published";
  }

  /// @throws InputError where `name` is none of the names that to_string() gives.
  inline Geometry parse_geometry(const std::string &name)
  {
    for (const Geometry geometry :
         {Geometry::axisymmetric, Geometry::sector, Geometry::disc, Geometry::published})
      if (name == to_string(geometry))
        return geometry;
    throw InputError("geometry = '" + name +
                     "' is unknown; it must be axisymmetric, sector, disc or published");
  }
} // namespace dpcontact

#endif
