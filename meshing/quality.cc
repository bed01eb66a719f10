#include "meshing/quality.h"

#include "meshing/boundary_ids.h"
#include "meshing/errors.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <ostream>
#include <sstream>

namespace dpcontact
{
  namespace
  {
    using Cell = dealii::Triangulation<2>::active_cell_iterator;

    double scaled_jacobian(const Cell &cell)
    {
      // Each corner with its neighbours, counter-clockwise (deal.II numbers lexicographically).
      constexpr unsigned int corners[4][3] = {{0, 1, 2}, {1, 3, 0}, {3, 2, 1}, {2, 0, 3}};

      double smallest = std::numeric_limits<double>::max();
      for (const auto &c : corners)
        {
          const dealii::Tensor<1, 2> a = cell->vertex(c[1]) - cell->vertex(c[0]);
          const dealii::Tensor<1, 2> b = cell->vertex(c[2]) - cell->vertex(c[0]);
          smallest = std::min(smallest, (a[0] * b[1] - a[1] * b[0]) / (a.norm() * b.norm()));
        }
      return smallest;
    }

    double aspect_ratio(const Cell &cell)
    {
      double shortest = std::numeric_limits<double>::max(), longest = 0;
      for (const auto &face : cell->face_iterators())
        {
          const double length = face->vertex(0).distance(face->vertex(1));
          shortest            = std::min(shortest, length);
          longest             = std::max(longest, length);
        }
      return longest / shortest;
    }
  } // namespace

  MeshQuality assess(const dealii::Triangulation<2> &mesh, const double contact_radius)
  {
    if (!(std::isfinite(contact_radius) && contact_radius > 0))
      throw InputError("mesh quality: contact_radius = " + std::to_string(contact_radius) +
                       " is out of range; it must be positive");
    if (mesh.n_active_cells() == 0)
      throw SolverError("mesh quality: the mesh has no cells");

    MeshQuality quality;
    quality.n_cells                  = mesh.n_active_cells();
    quality.smallest_scaled_jacobian = std::numeric_limits<double>::max();
    quality.smallest_cell_area       = std::numeric_limits<double>::max();
    quality.domain_radius            = std::numeric_limits<double>::max();
    double surface_reach             = 0;
    for (const auto &cell : mesh.active_cell_iterators())
      {
        if (!cell->reference_cell().is_hyper_cube())
          throw SolverError("mesh quality: the mesh has other cells than quadrilaterals");
        const double jacobian = scaled_jacobian(cell), aspect = aspect_ratio(cell),
                     area                = cell->measure();
        quality.smallest_scaled_jacobian = std::min(quality.smallest_scaled_jacobian, jacobian);
        quality.mean_scaled_jacobian += jacobian / quality.n_cells;
        quality.largest_aspect_ratio = std::max(quality.largest_aspect_ratio, aspect);
        quality.mean_aspect_ratio += aspect / quality.n_cells;
        quality.smallest_cell_area = std::min(quality.smallest_cell_area, area);
        quality.largest_cell_area  = std::max(quality.largest_cell_area, area);
        for (const auto &face : cell->face_iterators())
          {
            // The coarse side of an irregular face sees its children: one hanging node each.
            if (face->has_children())
              ++quality.n_hanging_nodes;
            if (!face->at_boundary())
              continue;
            if (face->boundary_id() == boundary::far)
              for (const unsigned int v : {0u, 1u})
                quality.domain_radius = std::min(quality.domain_radius, face->vertex(v).norm());
            if (face->boundary_id() == boundary::surface)
              {
                const auto [inner, outer] = std::minmax({face->vertex(0)[0], face->vertex(1)[0]});
                surface_reach             = std::max(surface_reach, outer);
                quality.elements_across_contact +=
                  std::clamp((contact_radius - inner) / (outer - inner), 0., 1.);
              }
          }
      }
    if (contact_radius > surface_reach)
      throw InputError(
        "mesh quality: contact_radius = " + std::to_string(contact_radius) +
        " reaches past the surface, which ends at r = " + std::to_string(surface_reach));
    return quality;
  }

  void print(const MeshQuality &quality, std::ostream &out)
  {
    std::ostringstream table;
    const auto         line = [&table](const char *name, const auto value) {
      table << "  " << std::left << std::setw(28) << name << value << '\n';
    };
    table << std::setprecision(5) << "mesh quality\n";
    line("cells", quality.n_cells);
    line("hanging nodes", quality.n_hanging_nodes);
    line("scaled Jacobian, smallest", quality.smallest_scaled_jacobian);
    line("scaled Jacobian, mean", quality.mean_scaled_jacobian);
    line("aspect ratio, largest", quality.largest_aspect_ratio);
    line("aspect ratio, mean", quality.mean_aspect_ratio);
    line("cell area, smallest", quality.smallest_cell_area);
    line("cell area, largest", quality.largest_cell_area);
    line("elements across the contact", quality.elements_across_contact);
    line("domain radius", quality.domain_radius);
    out << table.str();
  }
} // namespace dpcontact
