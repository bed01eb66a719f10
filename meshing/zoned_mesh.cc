#include "meshing/zoned_mesh.h"

#include "meshing/gmsh_session.h"
#include "meshing/require.h"
#include "meshing/zone_halving.h"

#include <deal.II/grid/grid_tools.h>

#include <gmsh.h>

#include <algorithm>
#include <cmath>
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

    /// The blocks that gmsh makes: a square core at the origin, and to its right and below it
    /// blocks of rings that lead to the far boundary. Lengths are in contact radii.
    struct Blocks
    {
      int    core_cells;   ///< along a side of the core
      double core_side;    ///< length of that side
      int    rings;        ///< between the core and the far boundary
      double growth;       ///< ratio of the widths of neighbouring rings, outwards
      double outer_radius; ///< of the far boundary
    };

    /// Whole cells of size 2^halvings/resolution that cover the contact zone.
    Blocks blocks_of(const Zones &zones, const unsigned int halvings)
    {
      const double block = static_cast<double>(1u << halvings) / zones.resolution;
      Blocks       blocks;
      blocks.core_cells   = static_cast<int>(std::ceil(zones.contact_zone / block - 1e-9));
      blocks.core_side    = blocks.core_cells * block;
      blocks.outer_radius = zones.domain_radius;
      // Ring widths shrink with the block's cells, so that `resolution` scales the whole mesh; a
      // ratio above 2 would make slivers of the coarsest.
      blocks.growth =
        std::min(std::max(2., zones.growth), std::pow(zones.growth, 40. / zones.resolution));
      blocks.rings = number_of_rings(
        blocks.core_side, zones.domain_radius, blocks.core_side / blocks.core_cells, blocks.growth);
      return blocks;
    }

    void make_blocks(const Blocks &blocks, dealii::Triangulation<2> &mesh)
    {
      const double      c = blocks.core_side;
      const double      d = blocks.outer_radius / std::sqrt(2.);
      const GmshSession gmsh_session;
      namespace geo         = gmsh::model::geo;
      const int origin      = geo::addPoint(0, 0, 0);
      const int core_right  = geo::addPoint(c, 0, 0);
      const int core_corner = geo::addPoint(c, -c, 0);
      const int core_bottom = geo::addPoint(0, -c, 0);
      const int far_right   = geo::addPoint(blocks.outer_radius, 0, 0);
      const int far_corner  = geo::addPoint(d, -d, 0);
      const int far_bottom  = geo::addPoint(0, -blocks.outer_radius, 0);

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
        geo::mesh::setTransfiniteCurve(line, blocks.core_cells + 1);
      for (const int ray : {ray_surface, ray_diagonal, ray_axis})
        geo::mesh::setTransfiniteCurve(ray, blocks.rings + 1, "Progression", blocks.growth);
      for (const int s : {core, side, floor})
        {
          geo::mesh::setTransfiniteSurface(s);
          geo::mesh::setRecombine(2, s);
        }
      gmsh_session.name_groups({core_axis, ray_axis},
                               {core_surface, ray_surface},
                               {arc_side, arc_floor},
                               {core, side, floor});
      gmsh_session.mesh_into(mesh);
    }

    /// Half sides and depths of the zones in which cells are halved, from the coarsest cells to the
    /// finest.
    std::vector<std::pair<double, double>>
    halved_zones(const Zones &zones, const double core_side, const unsigned int halvings)
    {
      std::vector<std::pair<double, double>> sizes = {
        {std::max(core_side, zones.plastic_zone), zones.plastic_zone},
        {core_side, zones.medium_depth},
        {core_side, zones.fine_depth},
        {core_side, zones.surface_depth}};
      sizes.resize(halvings);
      for (unsigned int k = 1; k <= zones.surface_halvings; ++k)
        sizes.emplace_back(core_side, zones.surface_depth / static_cast<double>(1u << k));
      return sizes;
    }
  } // namespace

  void Zones::check() const
  {
    const auto zone =
      [](const bool holds, const char *name, const double value, const char *range) {
        require(holds, "mesh zones", name, value, range);
      };
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
      zone(std::isfinite(value), name, value, "finite");
    zone(resolution >= 2 && resolution <= 1024, "resolution", resolution, "from 2 to 1024");
    zone(octaves <= 12, "octaves", octaves, "at most 12");
    zone(refinements <= 6, "refinements (option level)", refinements, "at most 6");
    zone(surface_halvings <= 4, "surface_halvings", surface_halvings, "at most 4");
    zone(
      contact_zone > 1 && contact_zone < 10, "contact_zone", contact_zone, "above 1 and below 10");
    zone(plastic_zone >= contact_zone, "plastic_zone", plastic_zone, "at least contact_zone");
    zone(fine_depth > 0 && fine_depth <= medium_depth,
         "fine_depth",
         fine_depth,
         "positive and at most medium_depth");
    zone(surface_depth > 0 && surface_depth <= fine_depth,
         "surface_depth",
         surface_depth,
         "positive and at most fine_depth");
    zone(medium_depth <= contact_zone, "medium_depth", medium_depth, "at most contact_zone");
    zone(domain_radius >= 2 * plastic_zone,
         "domain_radius",
         domain_radius,
         "at least twice plastic_zone");
    zone(growth > 1 && growth <= 3, "growth", growth, "above 1 and at most 3");
    zone(stretch > 0, "stretch", stretch, "positive");
  }

  void make_zoned_mesh(const Zones &zones, dealii::Triangulation<2> &mesh)
  {
    zones.check();
    const unsigned int halvings = number_of_halvings(zones.resolution);
    const Blocks       blocks   = blocks_of(zones, halvings);
    make_blocks(blocks, mesh);
    halve_zones(
      halved_zones(zones, blocks.core_side, halvings),
      zones.octaves,
      [](const dealii::Point<2> &p) { return std::make_pair(p[0], -p[1]); },
      mesh);
    mesh.refine_global(zones.refinements);
    if (zones.stretch != 1)
      dealii::GridTools::scale(zones.stretch, mesh);
    check_mesh(mesh);
  }
} // namespace dpcontact
