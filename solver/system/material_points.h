#ifndef DPCONTACT_SOLVER_SYSTEM_MATERIAL_POINTS_H
#define DPCONTACT_SOLVER_SYSTEM_MATERIAL_POINTS_H

#include "solver/discretisation/discretisation.h"
#include "solver/laws/law.h"
#include "solver/system/arrays.h"
#include "solver/system/cell_stiffness.h"
#include "solver/system/step_integrals.h"

#include <vector>

namespace dpcontact
{
  /// The material at all quadrature points, cell by cell: what the points remember of the converged
  /// load steps, and what their laws answer to the displacements that were evaluated last.
  template <int dim>
  class MaterialPoints
  {
  public:
    /// What the points remember of the last converged step.
    struct History
    {
      std::vector<laws::State>        states;
      std::vector<double>             accumulated_strain; ///< ∫ √(2/3) |dεᵖ|
      std::vector<laws::StressTensor> stresses;
    };

    /// @param space must outlive this object.
    /// @param laws one of each body.
    MaterialPoints(const Discretisation<dim> &space, const std::vector<laws::Law> &laws);

    /// Evaluates the law at the points of a cell.
    /// @param u all free displacements.
    void evaluate(unsigned int cell, const std::vector<double> &u);

    /// Makes what was evaluated last the history. Of the integrals those over the bodies are set;
    /// `work`, and what the half-space around them holds, are the caller's.
    StepIntegrals commit();
    /// Back to the virgin state.
    void reset();

    const History &history() const { return committed; }
    void           restore(const History &saved) { committed = saved; }
    /// The history in the order of the mesh's cells, whichever process they are on. Every process
    /// gets all of it.
    std::vector<double> save() const;
    /// @throws InputError where `saved` has no array "points" of this mesh.
    void restore(const Arrays &saved);

    const std::vector<laws::Law> &laws() const { return material_laws; }
    /// Index of the first point of a cell.
    std::size_t first(const unsigned int cell) const { return first_point[cell]; }

    // Of every point as evaluated last.
    const std::vector<laws::Branch>       &branches() const { return branch; }
    const std::vector<laws::StressTensor> &stresses() const { return stress; }
    /// Whether any point of a cell is off the elastic branch.
    bool yields(unsigned int cell) const;
    /// What the tangent is more than the elastic one; nullptr on the elastic branch.
    const TangentMatrix<dim> *plastic_tangent(const std::size_t point) const
    {
      return branch[point] == laws::Branch::elastic ? nullptr : &tangents[point];
    }
    const TangentMatrix<dim> &elastic_tangent(const unsigned int body) const
    {
      return elastic[body];
    }

  private:
    void add_point(std::size_t                                          index,
                   const laws::Law                                     &law,
                   const typename Discretisation<dim>::QuadraturePoint &point,
                   StepIntegrals                                       &integrals);

    const Discretisation<dim>      &space;
    std::vector<laws::Law>          material_laws;
    std::vector<TangentMatrix<dim>> elastic;     ///< of each body
    std::vector<unsigned int>       first_point; ///< of every cell

    History                         committed;
    std::vector<laws::State>        trial;
    std::vector<laws::Branch>       branch;
    std::vector<laws::StressTensor> stress;
    std::vector<TangentMatrix<dim>> tangents; ///< of the points off the elastic branch
  };
} // namespace dpcontact

#endif
