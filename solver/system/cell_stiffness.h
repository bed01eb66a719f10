#ifndef DPCONTACT_SOLVER_SYSTEM_CELL_STIFFNESS_H
#define DPCONTACT_SOLVER_SYSTEM_CELL_STIFFNESS_H

#include "solver/discretisation/discretisation.h"
#include "solver/laws/point.h"

#include <array>
#include <vector>

namespace dpcontact
{
  /// D of δσ = D δε over the strain vector of Kinematics<dim>.
  template <int dim>
  using TangentMatrix =
    std::array<std::array<double, Kinematics<dim>::n_strains>, Kinematics<dim>::n_strains>;

  /// Sets `matrix` to the entries of a spatial tangent that act on the strain vector.
  template <int dim>
  void restrict_tangent(const laws::Tangent &tangent, TangentMatrix<dim> &matrix)
  {
    for (unsigned int s = 0; s < Kinematics<dim>::n_strains; ++s)
      for (unsigned int t = 0; t < Kinematics<dim>::n_strains; ++t)
        {
          const auto [i, j] = Kinematics<dim>::positions[s];
          const auto [k, l] = Kinematics<dim>::positions[t];
          matrix[s][t]      = tangent[i][j][k][l];
        }
  }

  /// Which part of a cell's stiffness is kept.
  enum class StiffnessPart
  {
    upper_triangle, ///< n (n + 1)/2 entries of a symmetric one
    whole           ///< n² entries
  };

  /// Sets `block` to ∫ Bᵀ D B dV over a cell, row by row over its n unknowns.
  /// @param tangent `tangent(q)` points to D at the cell's quadrature point q, or is nullptr where
  /// that is zero.
  template <int dim, class TangentOfPoint>
  void cell_stiffness(const typename Discretisation<dim>::Cell &cell,
                      const TangentOfPoint                     &tangent,
                      const StiffnessPart                       part,
                      std::vector<double>                      &block)
  {
    constexpr unsigned int n_strains = Kinematics<dim>::n_strains;
    const bool             upper     = part == StiffnessPart::upper_triangle;
    const auto             n         = cell.unknowns.size();
    block.assign(upper ? n * (n + 1) / 2 : n * n, 0.);
    std::vector<std::array<double, n_strains>> stress_of(n);
    for (unsigned int q = 0; q < cell.points.size(); ++q)
      {
        const auto               &point = cell.points[q];
        const TangentMatrix<dim> *D     = tangent(q);
        if (D == nullptr)
          continue;
        for (std::size_t i = 0; i < n; ++i)
          for (unsigned int s = 0; s < n_strains; ++s)
            {
              double product = 0;
              for (unsigned int t = 0; t < n_strains; ++t)
                product += (*D)[s][t] * point.strain[i][t];
              stress_of[i][s] = point.weight * product;
            }
        double *entry = block.data();
        for (std::size_t i = 0; i < n; ++i)
          {
            const auto b = point.strain[i];
            for (std::size_t j = upper ? i : 0; j < n; ++j, ++entry)
              {
                double product = 0;
                for (unsigned int s = 0; s < n_strains; ++s)
                  product += b[s] * stress_of[j][s];
                *entry += product;
              }
          }
      }
  }
} // namespace dpcontact

#endif
