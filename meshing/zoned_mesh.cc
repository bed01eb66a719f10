#include "meshing/zoned_mesh.h"

#include "meshing/boundary_ids.h"
#include "meshing/errors.h"
#include "meshing/gmsh_session.h"
#include "meshing/zone_halving.h"

#include <deal.II/grid/grid_tools.h>

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

namespace dpcontact
{
  namespace
  {
    /// Halvings between the blocks that gmsh makes and the cells at the contact.
    unsigned int number_of_halvings(const unsigned int resolution)
    {
      return std::min(4u, static_cast<unsigned int>(std::log2(resolution)));
    }

    void require(const bool holds, const char *name, const double value, const char *range)
    {
      if (holds)
        return;
      std::ostringstream message;
      message << "mesh zones: " << name << " = " << value << " is out of range; it must be "
              << range;
      throw InputError(message.str());
    }
  } // namespace

  void Zones::check() const
  {
    // First, so that what follows compares numbers only.
    const std::pair<const char *, double> lengths[] = {{"contact_zone", contact_zone},
                                                       {"plastic_zone", plastic_zone},
                                                       {"fine_depth", fine_depth},
                                                       {"surface_depth", surface_depth},
                                                       {"medium_depth", medium_depth},
                                                       {"domain_radius", domain_radius},
                                                       {"growth", growth},
                                                       {"stretch", stretch}};
    for (const auto &[name, value] : lengths)
      require(std::isfinite(value), name, value, "finite");
    require(resolution >= 2 && resolution <= 1024, "resolution", resolution, "from 2 to 1024");
    require(octaves <= 12, "octaves", octaves, "at most 12");
    require(level <= 6, "level", level, "at most 6");
    require(surface_halvings <= 4, "surface_halvings", surface_halvings, "at most 4");
    require(
      contact_zone > 1 && contact_zone < 10, "contact_zone", contact_zone, "above 1 and below 10");
    require(plastic_zone >= contact_zone, "plastic_zone", plastic_zone, "at least contact_zone");
    require(fine_depth > 0 && fine_depth <= medium_depth,
            "fine_depth",
            fine_depth,
            "positive and at most medium_depth");
    require(surface_depth > 0 && surface_depth <= fine_depth,
            "surface_depth",
            surface_depth,
            "positive and at most fine_depth");
    require(medium_depth <= contact_zone, "medium_depth", medium_depth, "at most contact_zone");
    require(domain_radius >= 2 * plastic_zone,
            "domain_radius",
            domain_radius,
            "at least twice plastic_zone");
    require(growth > 1 && growth <= 3, "growth", growth, "above 1 and at most 3");
    require(stretch > 0, "stretch", stretch, "positive");
  }

  void make_zoned_mesh(const Zones &zones, dealii::Triangulation<2> &mesh)
  {
    zones.check();
    // Whole blocks of cells of size 1/resolution that cover the contact zone.
    const unsigned int halvings    = number_of_halvings(zones.resolution);
    const double       block       = static_cast<double>(1u << halvings) / zones.resolution;
    const int          block_cells = static_cast<int>(std::ceil(zones.contact_zone / block - 1e-9));
    const double       c           = block_cells * block;
    const double       d           = zones.domain_radius / std::sqrt(2.);
    // Ring widths shrink with the block's cells, so that `resolution` scales the whole mesh; a
    // ratio above 2 would make slivers of the coarsest.
    const double growth =
      std::min(std::max(2., zones.growth), std::pow(zones.growth, 40. / zones.resolution));
    const int rings = number_of_rings(c, zones.domain_radius, c / block_cells, growth);

    {
      const GmshSession gmsh_session;
      namespace geo         = gmsh::model::geo;
      const int origin      = geo::addPoint(0, 0, 0);
      const int core_right  = geo::addPoint(c, 0, 0);
      const int core_corner = geo::addPoint(c, -c, 0);
      const int core_bottom = geo::addPoint(0, -c, 0);
      const int far_right   = geo::addPoint(zones.domain_radius, 0, 0);
      const int far_corner  = geo::addPoint(d, -d, 0);
      const int far_bottom  = geo::addPoint(0, -zones.domain_radius, 0);

      const int core_surface = geo::addLine(origin, core_right);
      const int core_side    = geo::addLine(core_right, core_corner);
      const int core_floor   = geo::addLine(core_corner, core_bottom);
      const int core_axis    = geo::addLine(core_bottom, origin);
      const int ray_surface  = geo::addLine(core_right, far_right);
      const int ray_diagonal = geo::addLine(core_corner, far_corner);
      const int ray_axis     = geo::addLine(core_bottom, far_bottom);
      const int arc_side     = geo::addCircleArc(far_right, origin, far_corner);
      const int arc_floor    = geo::addCircleArc(far_corner, origin, far_bottom);

      // Counter-clockwise seen with r to the right and y upwards.
      const int core = geo::addPlaneSurface(
        {geo::addCurveLoop({-core_axis, -core_floor, -core_side, -core_surface})});
      const int side = geo::addPlaneSurface(
        {geo::addCurveLoop({core_side, ray_diagonal, -arc_side, -ray_surface})});
      const int floor = geo::addPlaneSurface(
        {geo::addCurveLoop({core_floor, ray_axis, -arc_floor, -ray_diagonal})});

      for (const int line : {core_surface, core_side, core_floor, core_axis, arc_side, arc_floor})
        geo::mesh::setTransfiniteCurve(line, block_cells + 1);
      for (const int ray : {ray_surface, ray_diagonal, ray_axis})
        geo::mesh::setTransfiniteCurve(ray, rings + 1, "Progression", growth);
      for (const int s : {core, side, floor})
        {
          geo::mesh::setTransfiniteSurface(s);
          geo::mesh::setRecombine(2, s);
        }
      geo::synchronize();
      gmsh::model::addPhysicalGroup(1, {core_axis, ray_axis}, boundary::axis);
      gmsh::model::addPhysicalGroup(1, {core_surface, ray_surface}, boundary::surface);
      gmsh::model::addPhysicalGroup(1, {arc_side, arc_floor}, boundary::far);
      gmsh::model::addPhysicalGroup(2, {core, side, floor}, 1);
      gmsh::model::setPhysicalName(1, boundary::axis, "axis");
      gmsh::model::setPhysicalName(1, boundary::surface, "surface");
      gmsh::model::setPhysicalName(1, boundary::far, "far");
      gmsh_session.mesh_into(mesh);
    }

    // From the coarsest cells to the finest.
    std::vector<std::pair<double, double>> sizes = {
      {std::max(c, zones.plastic_zone), zones.plastic_zone},
      {c, zones.medium_depth},
      {c, zones.fine_depth},
      {c, zones.surface_depth}};
    sizes.resize(halvings);
    for (unsigned int k = 1; k <= zones.surface_halvings; ++k)
      sizes.emplace_back(c, zones.surface_depth / static_cast<double>(1u << k));
    halve_zones(
      sizes,
      zones.octaves,
      [](const dealii::Point<2> &p) { return std::make_pair(p[0], -p[1]); },
      mesh);
    mesh.refine_global(zones.level);
    if (zones.stretch != 1)
      dealii::GridTools::scale(zones.stretch, mesh);
    check_mesh(mesh);
  }
} // namespace dpcontact
