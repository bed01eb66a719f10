#include "meshing/partition.h"

#include "meshing/errors.h"

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <string>

namespace dpcontact
{
  template <int dim>
  PartitionReport partition(const unsigned int parts, dealii::Triangulation<dim> &mesh)
  {
    if (parts == 0 || parts > mesh.n_active_cells())
      throw InputError("mesh partition: parts = " + std::to_string(parts) +
                       " is out of range; it must be from 1 to the number of cells, " +
                       std::to_string(mesh.n_active_cells()));
    dealii::GridTools::partition_triangulation(
      parts, mesh, dealii::SparsityTools::Partitioner::metis);

    PartitionReport report;
    report.cells_of_part.assign(parts, 0);
    for (const auto &cell : mesh.active_cell_iterators())
      {
        ++report.cells_of_part.at(cell->subdomain_id());
        for (const unsigned int f : cell->face_indices())
          {
            // Seen from the finer side, or between equals from the one of lower index.
            if (cell->at_boundary(f) || cell->neighbor(f)->has_children())
              continue;
            const auto neighbor = cell->neighbor(f);
            if (neighbor->subdomain_id() != cell->subdomain_id() &&
                (neighbor->level() < cell->level() || cell->index() < neighbor->index()))
              ++report.cut_faces;
          }
      }
    const auto &counts = report.cells_of_part;
    if (const auto empty = std::find(counts.begin(), counts.end(), 0u); empty != counts.end())
      throw SolverError("mesh partition: METIS left part " +
                        std::to_string(empty - counts.begin()) + " of " + std::to_string(parts) +
                        " without a cell: ask for fewer parts");
    return report;
  }

  template PartitionReport partition(unsigned int, dealii::Triangulation<2> &);
  template PartitionReport partition(unsigned int, dealii::Triangulation<3> &);
} // namespace dpcontact
