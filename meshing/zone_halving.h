#ifndef DPCONTACT_MESHING_ZONE_HALVING_H
#define DPCONTACT_MESHING_ZONE_HALVING_H

#include "meshing/boundary_ids.h"

#include <deal.II/grid/tria.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace dpcontact
{
  /// Number of rings from `inner` to `outer` when each is `growth` times as wide as the one before
  /// and the first is about `first` wide.
  inline int
  number_of_rings(const double inner, const double outer, const double first, const double growth)
  {
    return std::max(3,
                    static_cast<int>(std::lround(
                      std::log(1 + (outer - inner) * (growth - 1) / first) / std::log(growth))));
  }

  /// Halves the cells of `mesh` in nested zones around the origin, each a radius and a depth, from
  /// the coarsest cells to the finest: the cells of zone z are halved z + 1 times. Octave k repeats
  /// them at 2^−k of their size with k more halvings. Where a zone is shallower than half a cell,
  /// the cells at the surface are still halved.
  /// @param place takes a cell's centre to its (radius, depth).
  template <int dim, typename Place>
  void halve_zones(const std::vector<std::pair<double, double>> &zones,
                   const unsigned int                            octaves,
                   const Place                                  &place,
                   dealii::Triangulation<dim>                   &mesh)
  {
    const auto at_surface = [](const auto &cell) {
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && face->boundary_id() == boundary::surface)
          return true;
      return false;
    };
    const auto wanted_halvings = [&](const auto &cell) {
      const auto [radius, depth] = place(cell->center());
      unsigned int halvings      = 0;
      for (unsigned int k = 0; k <= octaves; ++k)
        for (unsigned int z = 0; z < zones.size(); ++z)
          {
            const double scale = 1. / static_cast<double>(1u << k);
            if (radius < scale * zones[z].first &&
                (depth < scale * zones[z].second || at_surface(cell)))
              halvings = std::max(halvings, k + z + 1);
          }
      return static_cast<int>(halvings);
    };
    for (bool refined = true; refined;)
      {
        refined = false;
        for (const auto &cell : mesh.active_cell_iterators())
          if (cell->level() < wanted_halvings(cell))
            {
              cell->set_refine_flag();
              refined = true;
            }
        if (refined)
          mesh.execute_coarsening_and_refinement();
      }
  }
} // namespace dpcontact

#endif
