#ifndef DPCONTACT_MESHING_FRAME_H
#define DPCONTACT_MESHING_FRAME_H

#include <deal.II/grid/tria.h>

namespace dpcontact
{
  /// The frame in which bodies of revolution are meshed: the quarter a, b ≥ 0, w ≤ 0 of a box,
  /// whose coordinates count rings and layers. section_map.h says how its squares become circles.
  ///
  /// The kite is the column a, b ≤ kite_side; rings surround it out to the core's side kite_side +
  /// rings, and layers lead down. Shells, if any, surround the core on its side and bottom; the
  /// core must then be as deep as wide. A ring, layer or shell is 1 wide.
  struct Frame
  {
    unsigned int kite_cells_a; ///< along a, and along the outer edge from M to B
    unsigned int kite_cells_b; ///< along b, and along the outer edge from A to M
    unsigned int kite_side;    ///< largest a and b of the kite
    unsigned int rings;        ///< between the kite and the core's side
    unsigned int layers;       ///< of the core, downwards
    unsigned int shells;       ///< around the core; 0: none

    unsigned int core_side() const { return kite_side + rings; }
  };

  /// Fills `mesh` with the cells of a frame, which gmsh makes. The planes a = 0 and b = 0 carry
  /// boundary::axis, w = 0 boundary::surface, all other faces boundary::far.
  /// @throws SolverError where other cells than bricks come out.
  void make_frame(const Frame &frame, dealii::Triangulation<3> &mesh);

  /// Replaces a quarter that is not refined by the whole of it and its three mirror images in the
  /// planes a = 0 and b = 0, which become part of the inside. Mirror images agree bit for bit.
  void mirror_to_whole(dealii::Triangulation<3> &mesh);
} // namespace dpcontact

#endif
