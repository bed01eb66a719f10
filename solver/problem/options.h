#ifndef DPCONTACT_SOLVER_PROBLEM_OPTIONS_H
#define DPCONTACT_SOLVER_PROBLEM_OPTIONS_H

#include "meshing/enum_names.h"
#include "meshing/mesh_kind.h"
#include "solver/problem/element.h"
#include "solver/problem/geometry.h"
#include "solver/problem/linear_solver_kind.h"

#include <optional>

namespace dpcontact
{
  /// How the impenetrability of the contact is enforced.
  enum class ContactMethod
  {
    augmented, ///< augmented Lagrangian: the penalty leaves no trace
    penalty    ///< plain penalty: an error that falls with the stiffness
  };

  template <>
  struct EnumNames<ContactMethod>
  {
    static constexpr const char             *what     = "contact";
    static constexpr EnumName<ContactMethod> values[] = {{ContactMethod::augmented, "augmented"},
                                                         {ContactMethod::penalty, "penalty"}};
  };

  /// In which units the equations are solved.
  enum class Units
  {
    scaled, ///< lengths by the expected contact radius, stresses by E a/R
    si      ///< none: a check that the scaling changes nothing
  };

  template <>
  struct EnumNames<Units>
  {
    static constexpr const char     *what     = "units";
    static constexpr EnumName<Units> values[] = {{Units::scaled, "scaled"}, {Units::si, "si"}};
  };

  /// Shape of the body that stands for a sphere.
  enum class Surface
  {
    parabola, ///< half-space under the gap r²/(2R): a/R drops out
    sphere    ///< true profile and curved free surface of radius R, small strain
  };

  template <>
  struct EnumNames<Surface>
  {
    static constexpr const char       *what     = "surface";
    static constexpr EnumName<Surface> values[] = {{Surface::parabola, "parabola"},
                                                   {Surface::sphere, "sphere"}};
  };

  /// Everything that a curve depends on besides material and scene. One source of defaults; every
  /// member has its entry in solver_options() (option_list.h).
  struct SolverOptions
  {
    Geometry     geometry      = Geometry::axisymmetric;
    double       sector_angle  = 45; ///< of Geometry::sector, degrees: 90 or 45
    LinearSolver linear_solver = LinearSolver::automatic; ///< in space
    MeshKind     mesh          = MeshKind::fitted;
    unsigned int resolution    = 40; ///< elements across the contact radius at the peak
    /// Further halvings of the cells at the surface. Unset: 1 where the approach at the peak
    /// is more than strongly_plastic times Hertz's, else 0.
    std::optional<unsigned int> surface_halvings;
    Element                     element     = Element::serendipity_reduced;
    unsigned int                refinements = 0; ///< uniform ones of the whole mesh on top
    /// Contacts down to 2^−octaves of the largest are resolved as well (zones.h).
    unsigned int octaves       = 0;
    double       domain_radius = 200;   ///< far boundary of the fitted mesh, in contact radii
    double       outer_radius  = 0.012; ///< of the published mesh (published_mesh.h), m
    double       mesh_stretch  = 1;     ///< stretches the fitted mesh (similarity checks)
    /// Interior vertices are moved at random by up to this share of an edge, for studies.
    double mesh_distortion = 0;
    double step_tolerance  = 2e-3; ///< stated accuracy of F(δ) in the load step, relative to F_max
    /// Loading steps of the finest run, for studies; 0: as many as step_tolerance needs.
    unsigned int loading_steps = 0;
    bool         extrapolation = true; ///< extrapolate in the load step (step_extrapolation.h)
    bool         predictor     = true; ///< start Newton from the extrapolated last step
    /// In axisymmetry solve for the part that yields or touches (condensed_subdomain.h).
    bool          condensation = true;
    bool          closed_form  = true; ///< Hertz where nothing yields and no fields are asked for
    ContactMethod contact      = ContactMethod::augmented;
    double        penalty_stiffness = 1e6; ///< in units of E/a
    Units         units             = Units::scaled;
    /// `sphere` asks for domain_radius a ≤ R. Its approach holds a compliance linear in the force,
    /// which remove_linear_compliance() takes out.
    Surface surface = Surface::parabola;

    /// The defaults of a geometry: in space quadratic elements, few of them; on the published mesh
    /// the low-order bricks that the paper has.
    static SolverOptions of(Geometry geometry);

    /// Angle that the model covers in space, rad.
    double angle() const;

    /// @throws InputError naming the option, its value and its range, and for options that do not
    /// go together.
    void check() const;
  };

  /// The solver for systems of `n_unknowns` with these options: what `automatic` stands for.
  LinearSolver linear_solver(const SolverOptions &options, unsigned int n_unknowns);
} // namespace dpcontact

#endif
