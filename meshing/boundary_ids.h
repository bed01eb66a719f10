#ifndef DPCONTACT_MESHING_BOUNDARY_IDS_H
#define DPCONTACT_MESHING_BOUNDARY_IDS_H

namespace dpcontact::boundary
{
  // The named boundaries of every mesh. In gmsh they are physical groups of these names.

  constexpr unsigned int axis    = 1; ///< r = 0; in space the planes of symmetry
  constexpr unsigned int surface = 2; ///< of the sphere, which is y = 0 of a half-space
  constexpr unsigned int far     = 3; ///< where the exterior takes over
} // namespace dpcontact::boundary

#endif
