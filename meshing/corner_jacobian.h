#ifndef DPCONTACT_MESHING_CORNER_JACOBIAN_H
#define DPCONTACT_MESHING_CORNER_JACOBIAN_H

#include <deal.II/base/tensor.h>

namespace dpcontact
{
  /// Jacobian at a corner of a quadrilateral or brick: the determinant of the edges that meet
  /// there, positive where the cell is not inverted. `lengths` becomes the product of their
  /// lengths.
  /// @param cell an iterator to a cell of deal.II's lexicographic numbering: the neighbours of corner
  /// v are v with one bit turned.
  template <int dim, typename Cell>
  double corner_jacobian(const Cell &cell, const unsigned int v, double &lengths)
  {
    dealii::Tensor<2, dim> edges;
    double                 sign = 1;
    lengths                     = 1;
    for (unsigned int k = 0; k < dim; ++k)
      {
        edges[k] = cell->vertex(v ^ (1u << k)) - cell->vertex(v);
        lengths *= edges[k].norm();
        if (v & (1u << k))
          sign = -sign;
      }
    return sign * determinant(edges);
  }
} // namespace dpcontact

#endif
