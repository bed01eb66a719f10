#ifndef DPCONTACT_SOLVER_SOLVE_H
#define DPCONTACT_SOLVER_SOLVE_H

#include "meshing/mesh_kind.h"
#include "meshing/mesh_quality.h"
#include "solver/checkpoint.h"
#include "solver/communicator.h"
#include "solver/curve.h"
#include "solver/element.h"
#include "solver/first_yield.h"
#include "solver/geometry.h"
#include "solver/linear_solver.h"
#include "solver/plastic_zone.h"
#include "solver/scene.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dpcontact
{
  namespace laws
  {
    enum class Branch : unsigned char; // laws/point.h, which only the solver and its tests need
  }

  /// Raised by one with every change that moves computed numbers: rows of different methods do not
  /// mix in one database.
  constexpr int method_version = 2;

  /// How the impenetrability of the contact is enforced.
  enum class ContactMethod
  {
    augmented, ///< augmented Lagrangian: the penalty leaves no trace
    penalty    ///< plain penalty: an error that falls with the stiffness
  };

  /// In which units the equations are solved.
  enum class Units
  {
    scaled, ///< lengths by the expected contact radius, stresses by E a/R
    si      ///< none: a check that the scaling changes nothing
  };

  /// Shape of the body that stands for a sphere.
  enum class Surface
  {
    parabola, ///< half-space under the gap r²/(2R): a/R drops out
    sphere    ///< true profile and curved free surface of radius R, small strain
  };

  /// Everything that a curve depends on besides material and scene. One source of defaults.
  struct SolverOptions
  {
    Geometry     geometry     = Geometry::axisymmetric;
    double       sector_angle = 45; ///< of Geometry::sector, degrees: 90 or 45
    MeshKind     mesh         = MeshKind::fitted;
    unsigned int resolution   = 40; ///< elements across the contact radius at the peak
    /// Further halvings of the cells at the surface. Unset: 1 where the approach at the peak
    /// is more than strongly_plastic times Hertz's, else 0.
    std::optional<unsigned int> surface_halvings;
    Element                     element = Element::serendipity_reduced;
    unsigned int                level   = 0; ///< uniform refinements of the whole mesh on top
    double domain_radius = 200;              ///< far boundary of the fitted mesh, in contact radii
    double outer_radius  = 0.012;            ///< of the published mesh (published_mesh.h), m
    double mesh_stretch  = 1;                ///< stretches the fitted mesh (similarity checks)
    /// Interior vertices are moved at random by up to this share of an edge, for studies.
    double       mesh_distortion = 0;
    unsigned int octaves  = 0;    ///< contacts down to 2^−octaves are resolved as well (zones.h)
    double step_tolerance = 2e-3; ///< stated accuracy of F(δ) in the load step, relative to F_max
    /// Loading steps of the finest run, for studies; 0: as many as step_tolerance needs.
    unsigned int  loading_steps = 0;
    bool          extrapolation = true; ///< extrapolate in the load step (step_extrapolation.h)
    bool          predictor     = true; ///< start Newton from the extrapolated last step
    bool          closed_form   = true; ///< Hertz where nothing yields and no fields are asked for
    ContactMethod contact       = ContactMethod::augmented;
    double        penalty_stiffness = 1e6; ///< in units of E/a
    Units         units             = Units::scaled;
    LinearSolver  linear_solver     = LinearSolver::automatic; ///< in space
    /// In axisymmetry solve for the part that yields or touches (core.h).
    bool condensation = true;
    /// `sphere` asks for domain_radius a ≤ R. Its approach holds a compliance linear in the force,
    /// which remove_linear_compliance() takes out.
    Surface surface = Surface::parabola;

    /// The defaults of a geometry: in space quadratic elements, few of them; on the published mesh
    /// the low-order bricks that the paper has.
    static SolverOptions of(Geometry geometry);

    /// Angle that the model covers in space, rad.
    double angle() const;

    /// @throws InputError naming the option, its value and its range.
    void check() const;
  };

  /// The solver for systems of `n_unknowns` with these options: what `automatic` stands for.
  LinearSolver linear_solver(const SolverOptions &options, unsigned int n_unknowns);

  /// Contact pressure at one radius.
  struct PressurePoint
  {
    double radius;   ///< m
    double pressure; ///< Pa, compression positive
  };

  /// Stress on the axis of symmetry.
  struct AxisPoint
  {
    double depth;         ///< m
    double axial_stress;  ///< σ_z, Pa, tension positive
    double radial_stress; ///< σ_r = σ_θ, Pa
  };

  /// State of a material point, stresses tension positive.
  struct PointState
  {
    double                radius, depth; ///< m
    double                volume;        ///< share of one sphere's volume that it stands for, m³
    double                radial_stress, axial_stress, hoop_stress, shear_stress; ///< Pa
    std::array<double, 3> principal_stress; ///< σ₁ ≥ σ₂ ≥ σ₃, Pa
    double                mises_stress;     ///< Pa
    double                plastic_strain;   ///< accumulated, ∫ √(2/3) |dεᵖ|
    laws::Branch          branch;           ///< of the load step that led here
  };

  /// What a curve cost.
  struct Cost
  {
    unsigned int  dofs              = 0;
    unsigned int  steps             = 0; ///< converged load steps, both branches
    unsigned int  newton_iterations = 0;
    unsigned int  cut_backs         = 0;
    unsigned int  linear_solves     = 0; ///< of an iterative solver,
    unsigned int  linear_iterations = 0; ///< and its iterations in all
    unsigned int  processes         = 1;
    double        wall_seconds      = 0;
    std::uint64_t peak_memory_bytes = 0;
  };

  /// A computed scene.
  struct Solution
  {
    SolverOptions used; ///< with surface_halvings and loading_steps as they were in the end
    FirstYield    yield;
    Curve         curve;
    std::vector<PressurePoint> peak_profile; ///< contact pressure at F_max
    std::vector<AxisPoint>     peak_axis;    ///< stresses on the axis at F_max
    std::vector<PointState>    peak_points;  ///< at F_max; empty unless fields are asked for
    std::optional<PlasticZone>
      plastic_zone; ///< yielded up to F_max; unset where Hertz's form was used
    std::optional<PlasticZone> flow_zone; ///< yielding at F_max; likewise
    /// In space: how far the pressure at F_max is from axisymmetric (contact_model.h). Otherwise 0.
    double axisymmetry_deviation = 0;
    double step_error            = 0; ///< estimated error of F(δ) in the load step, over F_max
    /// The curve with one halving of the load steps less: how far apart both are tells the error
    /// that the load step leaves in a coefficient. Equal to `curve` where it has no such error.
    Curve                    coarser_steps;
    double                   coarser_share = 0; ///< expected share of that difference, see solve.cc
    double                   mesh_radius   = 0; ///< contact radius that the mesh is fitted to, m
    MeshQuality              mesh_quality;      ///< of the mesh in units of its contact radius
    Cost                     cost;
    PathChecks               checks; ///< of the finest run; zero where Hertz's form was used
    unsigned int             apex_points = 0; ///< converged apex states met over the whole path
    std::vector<std::string> warnings;        ///< e.g. small strain left behind
  };

  /// Adds what limits the trust in a solution to its `warnings`: a/R > 0.1, plastic strain > 0.1.
  void add_warnings(const Scene &scene, Solution &solution);

  /// Told after every converged step: stage, fraction of the branch done (0…1), Newton iterations.
  using StepObserver =
    std::function<void(const char *stage, double fraction, int newton_iterations)>;

  /// Computes one loading–unloading curve of two spheres by finite elements.
  /// @param fields_directory where the VTU files of the peak and the released state go; empty: none.
  /// @param processes that solve it together, in space; all get the same solution.
  /// @throws InputError for values out of range, SolverError where the load path cannot be completed.
  Solution solve_contact(const Material      &material,
                         const Scene         &scene,
                         const SolverOptions &options,
                         const std::string   &fields_directory = {},
                         const StepObserver  &observer         = {},
                         const Communicator  &processes        = Communicator(),
                         const Checkpoint    &checkpoint       = {});
} // namespace dpcontact

#endif
