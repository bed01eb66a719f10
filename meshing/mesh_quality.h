#ifndef DPCONTACT_MESHING_MESH_QUALITY_H
#define DPCONTACT_MESHING_MESH_QUALITY_H

#include <iosfwd>

namespace dpcontact
{
  /// Figures of a mesh's shape, over its active cells; lengths and areas in the mesh's own unit. In
  /// space a cell's area is its volume.
  ///
  /// The scaled Jacobian of a cell is the least, over its corners, of the Jacobian there (the
  /// determinant of the edges that meet) divided by the product of the edges' lengths. In the plane
  /// it is the sine of the corner's angle: 1 in a rectangle, 0 where a corner is flat, negative
  /// where the cell is inverted. The aspect ratio of a cell is its longest edge divided by its
  /// shortest.
  struct MeshQuality
  {
    unsigned int dimension                = 2;
    unsigned int n_cells                  = 0;
    unsigned int n_hanging_nodes          = 0;
    double       smallest_scaled_jacobian = 0;
    double       mean_scaled_jacobian     = 0;
    double       largest_aspect_ratio     = 0;
    double       mean_aspect_ratio        = 0;
    double       smallest_cell_area       = 0;
    double       largest_cell_area        = 0;
    /// Elements along the surface within the contact radius, the cut one by its fraction inside; in
    /// space along θ = 0.
    double elements_across_contact = 0;
    /// The far boundary's least distance from the origin, over its vertices.
    double domain_radius = 0;
  };

  /// Writes a table for people, one figure a line.
  void print(const MeshQuality &quality, std::ostream &out);
} // namespace dpcontact

#endif
