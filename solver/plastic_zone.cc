#include "solver/plastic_zone.h"

#include "meshing/boundary_ids.h"
#include "solver/contact_system.h"

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

    std::vector<bool> plastic_cells(const ContactSystem<2> &system, const ZoneRule rule)
    {
      const auto       &strain = system.accumulated_plastic_strain();
      const auto       &branch = system.branches();
      std::vector<bool> plastic;
      std::size_t       point = 0;
      for (const auto &cell : system.discretization().cells())
        {
          std::size_t yielded = 0;
          for (std::size_t q = 0; q < cell.points.size(); ++q)
            yielded += rule == ZoneRule::yielded ? strain[point + q] > 0
                                                 : branch[point + q] != laws::Branch::elastic;
          plastic.push_back(2 * yielded >= cell.points.size());
          point += cell.points.size();
        }
      return plastic;
    }
  } // namespace

  PlasticZone plastic_zone(const ContactSystem<2> &system, const double length, const ZoneRule rule)
  {
    const auto              &space   = system.discretization();
    const std::vector<bool>  plastic = plastic_cells(system, rule);
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

    PlasticZone  zone;
    const double edge   = system.contact().edge_radius(system.u, system.approach);
    zone.contact_radius = edge * length;
    zone.cell_size      = std::numeric_limits<double>::infinity();

    std::map<std::size_t, Part> parts; // by representative
    for (const auto &cell : space.dof_handler().active_cell_iterators())
      {
        const std::size_t index = cell->active_cell_index();
        Part             *part  = plastic[index] ? &parts[sets.find_set(index)] : nullptr;
        if (part)
          {
            ++part->region.cells;
            for (const auto &point : space.cells()[index].points)
              part->region.volume += point.weight * length * length * length;
            for (const unsigned int v : cell->vertex_indices())
              {
                const double r = cell->vertex(v)[0] * length, depth = -cell->vertex(v)[1] * length;
                part->region.radius_min = std::min(part->region.radius_min, r);
                part->region.radius_max = std::max(part->region.radius_max, r);
                part->region.depth_min  = std::min(part->region.depth_min, depth);
                part->region.depth_max  = std::max(part->region.depth_max, depth);
              }
          }
        for (const unsigned int f : cell->face_indices())
          {
            if (!cell->face(f)->at_boundary())
              continue;
            const auto   face = cell->face(f);
            const double r0 = face->vertex(0)[0], r1 = face->vertex(1)[0];
            if (face->boundary_id() == boundary::surface)
              {
                zone.cell_size = std::min(zone.cell_size, face->measure() * length);
                if (!part)
                  continue;
                if (!part->region.surface)
                  part->region.surface.emplace();
                auto &extent      = *part->region.surface;
                extent.radius_min = std::min(extent.radius_min, std::min(r0, r1) * length);
                extent.radius_max = std::max(extent.radius_max, std::max(r0, r1) * length);
                part->on_free_surface |= (r0 + r1) / 2 > edge;
              }
            else if (part && face->boundary_id() == boundary::axis)
              {
                part->on_axis = true;
                for (const unsigned int v : {0u, 1u})
                  {
                    const double depth   = -face->vertex(v)[1] * length;
                    part->axis_depth_min = std::min(part->axis_depth_min, depth);
                    part->axis_depth_max = std::max(part->axis_depth_max, depth);
                  }
              }
          }
      }

    const Part *core = nullptr;
    for (const auto &[representative, part] : parts)
      if (part.on_axis && (!core || part.region.volume > core->region.volume))
        core = &part;
    for (const auto &[representative, part] : parts)
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
    return zone;
  }
} // namespace dpcontact
