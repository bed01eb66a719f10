#ifndef DPCONTACT_MESHING_PARTITION_H
#define DPCONTACT_MESHING_PARTITION_H

#include <deal.II/grid/tria.h>

#include <vector>

namespace dpcontact
{
  /// How the cells and faces of a mesh are shared among the parts of a partition.
  struct PartitionReport
  {
    std::vector<unsigned int> cells_of_part; ///< active cells, by part
    /// Faces between cells of two parts. Where a coarse cell meets fine ones, the fine cells' faces
    /// count.
    unsigned int cut_faces = 0;
  };

  /// Splits the active cells into `parts` by METIS and sets their subdomain ids to the parts. METIS
  /// partitions the graph recursively with a fixed seed, so that the result is always the same.
  /// @throws InputError where `parts` is 0 or more than the cells, SolverError where a part is left
  /// without a cell.
  template <int dim>
  PartitionReport partition(unsigned int parts, dealii::Triangulation<dim> &mesh);
} // namespace dpcontact

#endif
