#include "meshing/quality.h"

#include "meshing/boundary_ids.h"
#include "meshing/corner_jacobian.h"
#include "meshing/errors.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <map>
#include <ostream>
#include <set>
#include <sstream>
#include <utility>

namespace dpcontact
{
  namespace
  {
    template <typename Cell>
    double scaled_jacobian(const Cell &cell)
    {
      double smallest = std::numeric_limits<double>::max(), lengths;
      for (const unsigned int v : cell->vertex_indices())
        {
          const double jacobian = corner_jacobian<Cell::AccessorType::dimension>(cell, v, lengths);
          smallest              = std::min(smallest, jacobian / lengths);
        }
      return smallest;
    }

    template <typename Cell>
    double aspect_ratio(const Cell &cell)
    {
      double shortest = std::numeric_limits<double>::max(), longest = 0;
      for (const unsigned int l : cell->line_indices())
        {
          const double length = cell->line(l)->vertex(0).distance(cell->line(l)->vertex(1));
          shortest            = std::min(shortest, length);
          longest             = std::max(longest, length);
        }
      return longest / shortest;
    }

    /// The coarse side of an irregular face sees its children.
    template <typename Face>
    void collect_hanging_vertices(const Face &face, std::set<unsigned int> &hanging)
    {
      if (!face->has_children())
        return;
      if constexpr (Face::AccessorType::structure_dimension == 1)
        hanging.insert(face->child(0)->vertex_index(1));
      else
        {
          hanging.insert(face->child(0)->vertex_index(3));
          for (const unsigned int l : face->line_indices())
            hanging.insert(face->line(l)->child(0)->vertex_index(1));
        }
    }

    /// The lines of a surface face along which elements are counted, by index: the face of the
    /// plane, or the lines on θ = 0 in space.
    template <typename Face>
    void collect_radial_lines(const Face &face, std::map<int, std::pair<double, double>> &lines)
    {
      if constexpr (Face::AccessorType::structure_dimension == 1)
        lines[face->index()] = std::minmax({face->vertex(0)[0], face->vertex(1)[0]});
      else
        for (const unsigned int l : face->line_indices())
          {
            const auto                 line   = face->line(l);
            const dealii::Point<3>     middle = line->center();
            const dealii::Tensor<1, 3> along  = line->vertex(1) - line->vertex(0);
            if (middle[0] > 0 && std::abs(middle[1]) + std::abs(along[1]) < 1e-9 * along.norm())
              lines[line->index()] = std::minmax({line->vertex(0)[0], line->vertex(1)[0]});
          }
    }
  } // namespace

  template <int dim>
  MeshQuality assess(const dealii::Triangulation<dim> &mesh, const double contact_radius)
  {
    if (!(std::isfinite(contact_radius) && contact_radius > 0))
      throw InputError("mesh quality: contact_radius = " + std::to_string(contact_radius) +
                       " is out of range; it must be positive");
    if (mesh.n_active_cells() == 0)
      throw SolverError("mesh quality: the mesh has no cells");

    MeshQuality quality;
    quality.dimension                                      = dim;
    quality.n_cells                                        = mesh.n_active_cells();
    quality.smallest_scaled_jacobian                       = std::numeric_limits<double>::max();
    quality.smallest_cell_area                             = std::numeric_limits<double>::max();
    quality.domain_radius                                  = std::numeric_limits<double>::max();
    double                                   surface_reach = 0;
    std::set<unsigned int>                   hanging;
    std::map<int, std::pair<double, double>> lines;
    for (const auto &cell : mesh.active_cell_iterators())
      {
        if (!cell->reference_cell().is_hyper_cube())
          throw SolverError("mesh quality: the mesh has other cells than quadrilaterals or bricks");
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
            collect_hanging_vertices(face, hanging);
            if (!face->at_boundary())
              continue;
            if (face->boundary_id() == boundary::far)
              for (const unsigned int v : face->vertex_indices())
                quality.domain_radius = std::min(quality.domain_radius, face->vertex(v).norm());
            if (face->boundary_id() == boundary::surface)
              collect_radial_lines(face, lines);
          }
      }
    quality.n_hanging_nodes = static_cast<unsigned int>(hanging.size());
    for (const auto &[index, reach] : lines)
      {
        const auto [inner, outer] = reach;
        surface_reach             = std::max(surface_reach, outer);
        quality.elements_across_contact +=
          std::clamp((contact_radius - inner) / (outer - inner), 0., 1.);
      }
    if (contact_radius > surface_reach)
      throw InputError(
        "mesh quality: contact_radius = " + std::to_string(contact_radius) +
        " reaches past the surface, which ends at r = " + std::to_string(surface_reach));
    return quality;
  }

  template MeshQuality assess(const dealii::Triangulation<2> &, double);
  template MeshQuality assess(const dealii::Triangulation<3> &, double);

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
    const bool plane = quality.dimension == 2;
    line(plane ? "cell area, smallest" : "cell volume, smallest", quality.smallest_cell_area);
    line(plane ? "cell area, largest" : "cell volume, largest", quality.largest_cell_area);
    line("elements across the contact", quality.elements_across_contact);
    line("domain radius", quality.domain_radius);
    out << table.str();
  }
} // namespace dpcontact
