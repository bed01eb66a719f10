#ifndef DPCONTACT_MESHING_PUBLISHED_MESH_H
#define DPCONTACT_MESHING_PUBLISHED_MESH_H

#include <deal.II/grid/tria.h>

#include <array>

namespace dpcontact
{
  /// The mesh of Wang et al. 2018 (doi 10.1155/2018/6783791, figure 1 and section 3.1), as the half
  /// plane that its 3-D mesh sweeps. Printed: three zones out to 0.02 R, 0.05 R and beyond (R = 0.1
  /// m) with radial sizes 5e-5, 5e-4 and 1e-3 m; sizes in depth from 2e-3 to 2e-4 m towards the
  /// contact; 60 segments around; 73,100 bricks and 76,830 nodes. Lengths here are in metres.
  struct PublishedMesh
  {
    static constexpr double zone_radius[2] = {2e-3, 5e-3};       ///< 0.02 R and 0.05 R
    static constexpr double radial_size[3] = {5e-5, 5e-4, 1e-3}; ///< inwards to outwards
    static constexpr double top_size       = 2e-4; ///< thickness of the layer at the surface
    static constexpr double bottom_size    = 2e-3; ///< thickness of the layer at the bottom
    static constexpr double sphere_radius  = 0.1;

    /// Inferred: 73,100 and 76,830 factor as 25 layers of 2,924 quadrilaterals and 26 planes of
    /// 2,955 nodes. The grading between the two printed sizes is not printed and taken as
    /// geometric; the depth, 19.9 mm, follows.
    static constexpr unsigned int layers = 25;

    /// Not printed. 2,924 = 45 rings of 60 round a core of 14 × 16, so along a radius stand 52 or
    /// 53 elements. The zones I and II take 40 and 6 of them and leave 6 or 7 of 1 mm to zone III:
    /// 11 or 12 mm. The default is the latter, an inference to be checked by trying another radius.
    double       outer_radius = 0.012;
    unsigned int refinements  = 0; ///< uniform refinements on top
    double       unit         = 1; ///< metres in one unit of the mesh's coordinates

    /// The sum of the layers' thicknesses, m.
    static double depth();

    /// The ratio of a layer's thickness to that of the layer above it.
    static double layer_ratio();

    /// Elements of each zone along a radius of the half plane.
    std::array<unsigned int, 3> radial_elements() const;

    /// @throws InputError naming the quantity, its value and its range.
    void check() const;
  };

  /// Fills `mesh` with the half plane 0 ≤ r ≤ outer_radius, −depth ≤ y ≤ 0, divided by `unit`. Its
  /// far boundary is the outer cylinder and the bottom; ids are those of boundary_ids.h.
  /// @throws InputError for values out of range, SolverError where gmsh's mesh is not what was asked.
  void make_published_mesh(const PublishedMesh &published, dealii::Triangulation<2> &mesh);

  /// Fills `mesh` with the body itself, z ≤ 0 about the z axis, or the quarter 0 ≤ θ ≤ π/2 of it,
  /// of which the body is the mirror images: 73,100 bricks and 76,830 nodes with the default outer
  /// radius, 18,275 bricks in the quarter. The half plane above is its section θ = 0. Ids
  /// are those of boundary_ids.h.
  ///
  /// Inferred, as the counts say no more: the core is 16 elements of 5e-5 m along x, 0.8 mm, and 14
  /// along y, as long; the 60 segments of its perimeter are spread evenly over the circles, which
  /// begin at r = 0.8 mm (section_map.h). So 53 elements stand along x and 52 along y, and all
  /// sizes outside the core are those printed.
  /// @param angle π/2 or 2π. @throws as above, InputError for another angle.
  void
  make_published_mesh(const PublishedMesh &published, double angle, dealii::Triangulation<3> &mesh);
} // namespace dpcontact

#endif
