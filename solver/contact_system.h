#ifndef DPCONTACT_SOLVER_CONTACT_SYSTEM_H
#define DPCONTACT_SOLVER_CONTACT_SYSTEM_H

#include "solver/arrays.h"
#include "solver/contact.h"
#include "solver/core.h"
#include "solver/discretization.h"
#include "solver/laws/law.h"
#include "solver/linear_solver.h"

#include <vector>

namespace dpcontact
{
  /// Equilibrium of one half-space under the mirror plane, or of two that are pressed together:
  /// residual, tangent, history.
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

    using State = laws::State;

    /// What is rolled back when a step fails.
    struct Snapshot
    {
      std::vector<double> u;
      double              approach = 0;
      std::vector<double> multipliers;
      std::vector<State>  history;
      std::vector<double> accumulated; ///< ∫ √(2/3) |dεᵖ| at every point

      // of the last commit()
      std::vector<laws::StressTensor> stress;
      typename Contact<dim>::Surface  surface;
    };

    /// Integrals over the bodies at the state last evaluated.
    struct Integrals
    {
      double       plastic_volume       = 0;
      double       dissipation          = 0; ///< ∫ σₙ₊₁:Δεᵖ dV of the step
      double       mean_dissipation     = 0; ///< ∫ ½(σₙ + σₙ₊₁):Δεᵖ dV of the step
      double       work                 = 0; ///< of the contact in the step, trapezoidal rule
      double       elastic_energy       = 0; ///< of the body and of the half-space around it
      double       mises_stress_max     = 0;
      double       plastic_strain_max   = 0;
      unsigned int apex_points          = 0;
      double       largest_yield_excess = 0; ///< max of laws::yield_excess() over the points
    };

    /// @param condensed solve for a core that grows with contact and plastic zone (core.h), the rest
    /// condensed; otherwise for the whole body.
    /// @param laws of every body of the discretization.
    /// @param profile the undeformed gap between what touches.
    ContactSystem(const Discretization<dim>    &discretization,
                  const std::vector<laws::Law> &laws,
                  const Profile                &profile,
                  double                        penalty_stiffness,
                  bool                          condensed = false,
                  LinearSolver                  kind      = LinearSolver::direct);
    ContactSystem(const Discretization<dim> &discretization,
                  const laws::Law           &law,
                  const Profile             &profile,
                  double                     penalty_stiffness,
                  bool                       condensed = false)
      : ContactSystem(discretization,
                      std::vector<laws::Law>{law},
                      profile,
                      penalty_stiffness,
                      condensed)
    {}

    /// To be called on a converged step before commit(): brings what lies outside the core to
    /// equilibrium. @return false where it yields or touches there: then the core must grow() and
    /// the step be done again.
    bool complete();
    void grow();
    /// Distance from the centre of the contact to which it or plastic flow reach.
    double reach() const;
    /// Grows the core until `distance` lies well within it.
    void cover(double distance);

    void set_control(Control control, double target, double residual_scale);

    // The problem as solve_newton() sees it.
    double residual();
    bool   correction();
    double slope() const;
    double rounding() const { return contact_response.rounding / residual_scale; }
    void   move(double length);

    /// Residual at the iterate last evaluated, and the tangent there, unscaled.
    const std::vector<double> &residual_vector() const { return rhs; }
    const SparseMatrix        &tangent()
    {
      assemble_tangent();
      return core->matrix;
    }
    /// ∂(residual)/∂d = ∂F/∂u at the iterate last evaluated.
    const std::vector<double> &residual_by_approach() const { return approach_derivative; }

    double                                 force() const { return contact_response.force; }
    const typename Contact<dim>::Response &contact_state() const { return contact_response; }
    Contact<dim>                          &contact() { return contact_condition; }
    const Contact<dim>                    &contact() const { return contact_condition; }

    std::vector<double> u;
    double              approach = 0;

    Snapshot snapshot() const
    {
      return {u,
              approach,
              contact_condition.multipliers,
              history,
              accumulated,
              committed_stress,
              committed_surface};
    }
    void restore(const Snapshot &saved);
    /// The snapshot in the order of the mesh's cells, whichever process they are on. Every process
    /// gets all of it.
    Arrays save() const;
    /// @throws InputError where `saved` is not of this mesh.
    void restore(const Arrays &saved);
    /// Back to the virgin state.
    void reset();

    /// Makes the trial history the history. @return the step's integrals.
    Integrals commit();

    const std::vector<State>  &point_history() const { return history; }
    const std::vector<double> &accumulated_plastic_strain() const { return accumulated; }
    /// Branches of the yield surface in the step last evaluated, at all quadrature points.
    const std::vector<laws::Branch> &branches() const { return branch; }
    /// Stresses at all quadrature points (cell by cell) at the state last evaluated.
    const std::vector<laws::StressTensor> &stresses() const { return stress; }
    const Discretization<dim>             &discretization() const { return space; }
    const std::vector<laws::Law>          &materials() const { return laws; }
    /// Iterations of an iterative linear solver, over how many systems.
    unsigned int linear_iterations() const { return core->linear_iterations(); }
    unsigned int linear_solves() const { return n_linear_solves; }

  private:
    void build_elastic_stiffness();
    void assemble_tangent();
    bool solve_for_step();
    void use_core(std::size_t stage);
    /// The law at the points of a cell, from the iterate's strains.
    void evaluate_points(unsigned int cell);
    /// ∫ Bᵀ D B of a cell, row by row, of a symmetric one the upper triangle; `tangent(q)` points
    /// to D of its point q, or to nothing where that is zero.
    template <class TangentOfPoint>
    void cell_block(const typename Discretization<dim>::Cell &cell,
                    const TangentOfPoint                     &tangent,
                    bool                                      upper_triangle,
                    std::vector<double>                      &block) const;

    const Discretization<dim>      &space;
    std::vector<laws::Law>          laws; ///< of each body
    LinearSolver                    kind;
    bool                            symmetric; ///< tangent
    unsigned int                    n_linear_solves = 0;
    Contact<dim>                    contact_condition;
    typename Contact<dim>::Response contact_response;

    Control control        = Control::approach;
    double  target         = 0;
    double  residual_scale = 1;

    using TangentMatrix =
      std::array<std::array<double, Kinematics<dim>::n_strains>, Kinematics<dim>::n_strains>;

    std::vector<double>                     core_radii; ///< of the cores, growing
    std::vector<std::unique_ptr<Core<dim>>> cores;      ///< made when they are first needed
    std::size_t                             stage = 0;
    Core<dim>                              *core  = nullptr; ///< the present one

    std::vector<TangentMatrix>       elastic_tangent; ///< of each body
    std::vector<std::vector<double>> elastic_blocks;  ///< of every cell
    std::vector<unsigned int>        first_point;     ///< of every cell
    /// Of the points off the elastic branch: what the tangent is more than the elastic one.
    std::vector<TangentMatrix> tangents;
    std::vector<std::pair<unsigned int, std::vector<double>>>
      contact_blocks; ///< (surface face, block)

    // Over all free unknowns; zero outside the core.
    std::vector<double> rhs, approach_derivative;
    std::vector<double> step, step_per_approach;
    double              approach_step = 0;

    std::vector<State>              history, trial;
    std::vector<double>             accumulated;
    std::vector<laws::Branch>       branch;
    std::vector<laws::StressTensor> stress;
    std::vector<laws::StressTensor> committed_stress;
    typename Contact<dim>::Surface  committed_surface;
  };
} // namespace dpcontact

#endif
