#include "solver/output/plastic_zone.h"

#include "meshing/boundary_ids.h"
#include "solver/system/contact_system.h"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <map>
#include <numeric>
#include <vector>

namespace dpcontact
{
  namespace
  {
    /// A region of plastic cells, with what decides which one it is.
    struct Part
    {
      PlasticRegion region;
      bool          on_axis         = false;
      double        axis_depth_min  = std::numeric_limits<double>::infinity();
      double        axis_depth_max  = 0;
      bool          on_free_surface = false;
    };

    void extend(PlasticRegion &region, const PlasticRegion &other)
    {
      region.radius_min = std::min(region.radius_min, other.radius_min);
      region.radius_max = std::max(region.radius_max, other.radius_max);
      region.depth_min  = std::min(region.depth_min, other.depth_min);
      region.depth_max  = std::max(region.depth_max, other.depth_max);
      region.volume += other.volume;
      region.cells += other.cells;
      if (!other.surface)
        return;
      if (!region.surface)
        region.surface.emplace();
      region.surface->radius_min = std::min(region.surface->radius_min, other.surface->radius_min);
      region.surface->radius_max = std::max(region.surface->radius_max, other.surface->radius_max);
    }

    /// Of the cells of one body, in their order.
    std::vector<bool>
    plastic_cells(const ContactSystem<2> &system, const ZoneRule rule, const unsigned int body)
    {
      const auto       &strain = system.points().history().accumulated_strain;
      const auto       &branch = system.points().branches();
      std::vector<bool> plastic;
      std::size_t       point = 0;
      for (const auto &cell : system.discretisation().cells())
        {
          std::size_t yielded = 0;
          for (std::size_t q = 0; q < cell.points.size(); ++q)
            yielded += rule == ZoneRule::yielded ? strain[point + q] > 0
                                                 : branch[point + q] != laws::Branch::elastic;
          if (cell.body == body)
            plastic.push_back(2 * yielded >= cell.points.size());
          point += cell.points.size();
        }
      return plastic;
    }

    using CellIterator = dealii::DoFHandler<2>::active_cell_iterator;

    /// A number of its own for every region of plastic cells that share faces, by cell.
    std::vector<std::size_t> regions_of(const Discretisation<2> &space,
                                        const std::vector<bool> &plastic)
    {
      std::vector<std::size_t> rank(plastic.size()), parent(plastic.size());
      std::iota(parent.begin(), parent.end(), std::size_t(0));
      boost::disjoint_sets sets(rank.data(), parent.data());
      for (const auto &cell : space.dof_handler().active_cell_iterators())
        if (plastic[cell->active_cell_index()])
          for (const unsigned int f : cell->face_indices())
            // A neighbour that is halved further sees this cell from its own side.
            if (!cell->at_boundary(f) && cell->neighbor(f)->is_active() &&
                plastic[cell->neighbor(f)->active_cell_index()])
              sets.union_set(static_cast<std::size_t>(cell->active_cell_index()),
                             static_cast<std::size_t>(cell->neighbor(f)->active_cell_index()));
      std::vector<std::size_t> region(plastic.size());
      for (std::size_t cell = 0; cell < region.size(); ++cell)
        region[cell] = sets.find_set(cell);
      return region;
    }

    /// Adds a cell's extent and volume.
    void add_cell(const CellIterator            &cell,
                  const Discretisation<2>::Cell &points_of,
                  const double                   length,
                  PlasticRegion                 &region)
    {
      ++region.cells;
      for (const auto &point : points_of.points)
        region.volume += point.weight * length * length * length;
      for (const unsigned int v : cell->vertex_indices())
        {
          const double r = cell->vertex(v)[0] * length, depth = -cell->vertex(v)[1] * length;
          region.radius_min = std::min(region.radius_min, r);
          region.radius_max = std::max(region.radius_max, r);
          region.depth_min  = std::min(region.depth_min, depth);
          region.depth_max  = std::max(region.depth_max, depth);
        }
    }

    /// Adds what a cell's faces on the surface and on the axis tell.
    /// @param edge radius of the contact's edge, in the system's unit.
    void add_boundary(const CellIterator &cell, const double edge, const double length, Part &part)
    {
      for (const unsigned int f : cell->face_indices())
        {
          if (!cell->face(f)->at_boundary())
            continue;
          const auto   face = cell->face(f);
          const double r0 = face->vertex(0)[0], r1 = face->vertex(1)[0];
          if (face->boundary_id() == boundary::surface)
            {
              if (!part.region.surface)
                part.region.surface.emplace();
              auto &extent      = *part.region.surface;
              extent.radius_min = std::min(extent.radius_min, std::min(r0, r1) * length);
              extent.radius_max = std::max(extent.radius_max, std::max(r0, r1) * length);
              part.on_free_surface |= (r0 + r1) / 2 > edge;
            }
          else if (face->boundary_id() == boundary::axis)
            {
              part.on_axis = true;
              for (const unsigned int v : {0u, 1u})
                {
                  const double depth  = -face->vertex(v)[1] * length;
                  part.axis_depth_min = std::min(part.axis_depth_min, depth);
                  part.axis_depth_max = std::max(part.axis_depth_max, depth);
                }
            }
        }
    }

    /// Size of the smallest cell at the surface, in m.
    double smallest_surface_cell(const Discretisation<2> &space, const double length)
    {
      double smallest = std::numeric_limits<double>::infinity();
      for (const auto &cell : space.dof_handler().active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() == boundary::surface)
            smallest = std::min(smallest, face->measure() * length);
      return smallest;
    }

    using Parts = std::map<std::size_t, Part>; // by the number of the region

    /// Enters the largest region on the axis as the core, those at the surface as the ring, and
    /// counts the others.
    void enter_parts(const Parts &parts, PlasticZone &zone)
    {
      const Part *core = nullptr;
      for (const auto &[number, part] : parts)
        if (part.on_axis && (!core || part.region.volume > core->region.volume))
          core = &part;
      for (const auto &[number, part] : parts)
        if (&part == core)
          {
            zone.core                      = part.region;
            zone.axis_depth_min            = part.axis_depth_min;
            zone.axis_depth_max            = part.axis_depth_max;
            zone.core_reaches_free_surface = part.on_free_surface;
            zone.elastic_cap               = part.axis_depth_min > 0;
          }
        else if (part.region.surface)
          {
            if (!zone.ring)
              zone.ring.emplace();
            extend(*zone.ring, part.region);
            ++zone.ring_parts;
          }
        else
          ++zone.other_regions;
    }
  } // namespace

  PlasticZone plastic_zone(const ContactSystem<2> &system,
                           const double            length,
                           const ZoneRule          rule,
                           const unsigned int      body)
  {
    const auto                    &space   = system.discretisation();
    const std::vector<bool>        plastic = plastic_cells(system, rule, body);
    const std::vector<std::size_t> region  = regions_of(space, plastic);
    const double                   edge    = system.contact().edge_radius(system.unknowns());
    Parts                          parts;
    for (const auto &cell : space.dof_handler().active_cell_iterators())
      if (const std::size_t index = cell->active_cell_index(); plastic[index])
        {
          Part &part = parts[region[index]];
          add_cell(cell, space.cells()[body * plastic.size() + index], length, part.region);
          add_boundary(cell, edge, length, part);
        }
    PlasticZone zone;
    zone.contact_radius = edge * length;
    zone.cell_size      = smallest_surface_cell(space, length);
    enter_parts(parts, zone);
    return zone;
  }
} // namespace dpcontact
