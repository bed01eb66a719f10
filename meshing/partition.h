#ifndef DPCONTACT_MESHING_PARTITION_H
#define DPCONTACT_MESHING_PARTITION_H

#include <deal.II/grid/tria.h>

#include <vector>

namespace dpcontact
{
  /// What a partition looks like.
  struct PartitionReport
  {
    std::vector<unsigned int> cells_of_part; ///< active cells, by part
    /// Faces between cells of two parts; where a coarse cell meets fine ones, each of theirs.
    unsigned int cut_faces = 0;
  };

  /// Splits the active cells into `parts` by METIS (recursive graph partitioning with its fixed
  /// seed, so always the same way), as their subdomain ids say afterwards.
  /// @throws InputError where `parts` is 0 or more than the cells, SolverError where a part is left
  /// without a cell.
  template <int dim>
  PartitionReport partition(unsigned int parts, dealii::Triangulation<dim> &mesh);
} // namespace dpcontact

#endif
