#include "meshing/published_mesh.h"

#include "meshing/gmsh_session.h"
#include "meshing/require.h"

#include <deal.II/grid/grid_tools.h>

#include <gmsh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace dpcontact
{
  double PublishedMesh::layer_ratio()
  {
    return std::pow(bottom_size / top_size, 1. / (layers - 1));
  }

  std::array<unsigned int, 3> PublishedMesh::radial_elements() const
  {
    const double widths[] = {
      zone_radius[0], zone_radius[1] - zone_radius[0], outer_radius - zone_radius[1]};
    std::array<unsigned int, 3> elements;
    for (unsigned int i = 0; i < 3; ++i)
      elements[i] =
        static_cast<unsigned int>(std::max(1l, std::lround(widths[i] / radial_size[i])));
    return elements;
  }

  double PublishedMesh::depth()
  {
    const double q = layer_ratio();
    return (bottom_size * q - top_size) / (q - 1);
  }

  void PublishedMesh::check() const
  {
    const char *const what = "published mesh";
    require(std::isfinite(outer_radius) && outer_radius >= zone_radius[1] + radial_size[2] &&
              outer_radius <= sphere_radius,
            what,
            "outer-radius",
            outer_radius,
            "from 0.006 m (one element of zone III) to 0.1 m (the sphere's radius)");
    require(refinements <= 6, what, "refinements (option level)", refinements, "at most 6");
    require(std::isfinite(unit) && unit > 0, what, "unit", unit, "positive");
  }

  void make_published_mesh(const PublishedMesh &published, dealii::Triangulation<2> &mesh)
  {
    published.check();
    const double                depth         = PublishedMesh::depth();
    const auto                  zone_elements = published.radial_elements();
    const std::array<double, 4> radii         = {
              {0, PublishedMesh::zone_radius[0], PublishedMesh::zone_radius[1], published.outer_radius}};

    {
      const GmshSession gmsh_session;
      namespace geo = gmsh::model::geo;
      // Column i of points and lines stands at radii[i]; zone i lies between columns i and i + 1.
      std::array<int, 4> top, bottom, downwards;
      std::vector<int>   surfaces, floors, zones;
      for (unsigned int i = 0; i < 4; ++i)
        {
          top[i]       = geo::addPoint(radii[i], 0, 0);
          bottom[i]    = geo::addPoint(radii[i], -depth, 0);
          downwards[i] = geo::addLine(top[i], bottom[i]);
          geo::mesh::setTransfiniteCurve(downwards[i],
                                         static_cast<int>(PublishedMesh::layers) + 1,
                                         "Progression",
                                         PublishedMesh::layer_ratio());
        }
      for (unsigned int i = 0; i < 3; ++i)
        {
          const int elements = static_cast<int>(zone_elements[i]);
          surfaces.push_back(geo::addLine(top[i], top[i + 1]));
          floors.push_back(geo::addLine(bottom[i], bottom[i + 1]));
          geo::mesh::setTransfiniteCurve(surfaces[i], elements + 1);
          geo::mesh::setTransfiniteCurve(floors[i], elements + 1);
          // Counter-clockwise seen with r to the right and y upwards.
          zones.push_back(geo::addPlaneSurface(
            {geo::addCurveLoop({downwards[i], floors[i], -downwards[i + 1], -surfaces[i]})}));
          geo::mesh::setTransfiniteSurface(zones[i]);
          geo::mesh::setRecombine(2, zones[i]);
        }
      std::vector<int> far = floors;
      far.push_back(downwards[3]);
      gmsh_session.name_groups({downwards[0]}, surfaces, far, zones);
      gmsh_session.mesh_into(mesh);
    }

    mesh.refine_global(published.refinements);
    if (published.unit != 1)
      dealii::GridTools::scale(1 / published.unit, mesh);
    check_mesh(mesh);
  }
} // namespace dpcontact
