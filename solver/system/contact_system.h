#ifndef DPCONTACT_SOLVER_SYSTEM_CONTACT_SYSTEM_H
#define DPCONTACT_SOLVER_SYSTEM_CONTACT_SYSTEM_H

#include "solver/discretisation/discretisation.h"
#include "solver/laws/law.h"
#include "solver/system/arrays.h"
#include "solver/system/contact.h"
#include "solver/system/material_points.h"
#include "solver/system/nested_subdomains.h"
#include "solver/system/step_integrals.h"
#include "solver/system/unknowns.h"

#include <utility>
#include <vector>

namespace dpcontact
{
  /// Equilibrium of one half-space under the mirror plane, or of two that are pressed together:
  /// residual, tangent and Newton step.
  ///
  /// Unknowns are the free displacements u and the plane's approach d; one scalar equation closes
  /// the system, either d = given or F(u, d) = given. The tangent is that of everything: material
  /// (consistent), contact, far field, and the scalar equation (by block elimination).
  template <int dim>
  class ContactSystem
  {
  public:
    /// The scalar equation that closes the system.
    enum class Control
    {
      approach, ///< d = target
      force,    ///< F(u, d) = target
      released  ///< no contact; d plays no role
    };

    /// What is rolled back when a step fails.
    struct Snapshot
    {
      Unknowns                              unknowns;
      std::vector<double>                   multipliers; ///< of the contact
      typename MaterialPoints<dim>::History points;
      typename Contact<dim>::NodalFields    contact_fields; ///< of the last commit()
    };

    /// @param discretisation must outlive this object.
    /// @param laws of every body of the discretisation.
    /// @param undeformed_gap between what touches.
    /// @param penalty_stiffness pressure over length, in the system's units.
    ContactSystem(const Discretisation<dim>    &discretisation,
                  const std::vector<laws::Law> &laws,
                  const UndeformedGap          &undeformed_gap,
                  double                        penalty_stiffness,
                  Condensation                  condensation = Condensation::none,
                  LinearSolver                  kind         = LinearSolver::direct);

    /// To be called on a converged step before commit(): brings what lies outside the subdomain to
    /// equilibrium. @return false where it yields or touches there: then the subdomain must grow()
    /// and the step be done again.
    bool complete();
    void grow();
    /// Distance from the centre of the contact to which it or plastic flow reach.
    double reach() const;
    /// Grows the subdomain until `distance` lies well within it.
    void cover(double distance);

    void set_control(Control control, double target, double residual_scale);

    // The problem as solve_newton() sees it.
    double residual();
    bool   correction();
    double slope() const;
    double rounding() const { return contribution.rounding / residual_scale; }
    void   move(double length);

    /// Residual at the iterate last evaluated, over all free unknowns, unscaled.
    const std::vector<double> &residual_vector() const { return rhs; }
    /// The tangent there, over the subdomain's unknowns.
    const SparseMatrix &tangent();
    /// ∂(residual)/∂d = ∂F/∂u at the iterate last evaluated.
    const std::vector<double> &residual_by_approach() const { return approach_derivative; }

    double force() const { return contribution.force; }
    /// What the contact adds at the iterate last evaluated.
    const typename Contact<dim>::Contribution &contact_contribution() const { return contribution; }
    Contact<dim>                              &contact() { return contact_condition; }
    const Contact<dim>                        &contact() const { return contact_condition; }

    Unknowns       &unknowns() { return iterate; }
    const Unknowns &unknowns() const { return iterate; }

    Snapshot snapshot() const;
    void     restore(const Snapshot &saved);
    /// The snapshot in the order of the mesh's cells, whichever process they are on. Every process
    /// gets all of it.
    Arrays save() const;
    /// @throws InputError where `saved` is not of this mesh.
    void restore(const Arrays &saved);
    /// Back to the virgin state.
    void reset();

    /// Makes the state last evaluated the history. @return the step's integrals.
    StepIntegrals commit();

    const MaterialPoints<dim>    &points() const { return material; }
    const Discretisation<dim>    &discretisation() const { return space; }
    const std::vector<laws::Law> &materials() const { return material.laws(); }
    /// Iterations of an iterative linear solver, over how many systems.
    unsigned int linear_iterations() const { return subdomains.present().linear_iterations(); }
    unsigned int linear_solves() const { return n_linear_solves; }

  private:
    void add_internal_forces();
    void add_contact();
    void assemble_tangent();
    bool solve_for_step();

    const Discretisation<dim> &space;
    bool                       symmetric; ///< tangent
    MaterialPoints<dim>        material;
    NestedSubdomains<dim>      subdomains;
    Contact<dim>               contact_condition;

    Unknowns                            iterate;
    typename Contact<dim>::Contribution contribution;
    typename Contact<dim>::NodalFields  committed_fields;

    Control control        = Control::approach;
    double  target         = 0;
    double  residual_scale = 1;

    /// Of the iterate: the faces in contact and their blocks of the tangent.
    std::vector<std::pair<unsigned int, std::vector<double>>> contact_blocks;

    // Over all free unknowns; zero outside the subdomain.
    std::vector<double> rhs, approach_derivative;
    std::vector<double> step, step_per_approach;
    double              approach_step   = 0;
    unsigned int        n_linear_solves = 0;
  };
} // namespace dpcontact

#endif
