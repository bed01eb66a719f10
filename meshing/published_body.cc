#include "meshing/frame.h"
#include "meshing/gmsh_session.h"
#include "meshing/published_mesh.h"
#include "meshing/require.h"
#include "meshing/section_map.h"

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace dpcontact
{
  namespace
  {
    /// Quarter of the core of 14 × 16: its half sides in elements, along which 15 of 60 segments
    /// stand.
    constexpr unsigned int published_kite_cells[2] = {8, 7};

    /// Radius, m, that lies `elements` outwards from the axis on θ = 0.
    double
    radius_at(const double elements, const std::array<unsigned int, 3> &zones, const double outer)
    {
      const std::array<double, 4> radii = {
        {0, PublishedMesh::zone_radius[0], PublishedMesh::zone_radius[1], outer}};
      double left = elements;
      for (unsigned int i = 0; i < 2; ++i)
        {
          if (left <= zones[i])
            return radii[i] + (radii[i + 1] - radii[i]) * left / zones[i];
          left -= zones[i];
        }
      return radii[2] + (radii[3] - radii[2]) * left / zones[2];
    }
  } // namespace

  void make_published_mesh(const PublishedMesh      &published,
                           const double              angle,
                           dealii::Triangulation<3> &mesh)
  {
    published.check();
    const auto is = [angle](const double value) {
      return std::isfinite(angle) && std::abs(angle - value) < 1e-12;
    };
    const bool whole = is(2 * M_PI);
    require(whole || is(M_PI / 2),
            "published mesh",
            "angle",
            angle,
            "pi/2 or 2 pi, of which its 60 segments leave whole bricks and its core whole sides");

    const std::array<unsigned int, 3> zones    = published.radial_elements();
    const unsigned int                elements = zones[0] + zones[1] + zones[2];
    const Frame                       frame    = {published_kite_cells[0],
                                                  published_kite_cells[1],
                                                  published_kite_cells[0],
                                                  elements - published_kite_cells[0],
                                                  PublishedMesh::layers,
                                                  0};
    make_frame(frame, mesh);
    if (whole)
      mirror_to_whole(mesh);
    mesh.refine_global(published.refinements);

    // All segments are 6 degrees: the core's corner stands after 7 of 15.
    const double     kite_radius = published_kite_cells[0] * PublishedMesh::radial_size[0];
    const SectionMap section     = {M_PI / 2,
                                    M_PI / 2 * published_kite_cells[1] /
                                      (published_kite_cells[0] + published_kite_cells[1]),
                                    kite_radius,
                                    2 * kite_radius};
    const double     q           = PublishedMesh::layer_ratio();
    dealii::GridTools::transform(
      [&](const dealii::Point<3> &p) {
        const double extent = std::max(std::abs(p[0]), std::abs(p[1]));
        const double scale =
          extent > 0 ? radius_at(extent, zones, published.outer_radius) / extent : 0;
        dealii::Point<2> s = section(scale * std::abs(p[0]), scale * std::abs(p[1]));
        for (unsigned int k = 0; k < 2; ++k)
          if (p[k] < 0)
            s[k] = -s[k];
        const double depth = PublishedMesh::top_size * (std::pow(q, -p[2]) - 1) / (q - 1);
        return dealii::Point<3>(s[0], s[1], -depth) / published.unit;
      },
      mesh);
    check_mesh(mesh, angle);
  }
} // namespace dpcontact
