#include "solver/problem/options.h"

#include "meshing/errors.h"
#include "solver/problem/option_list.h"

#include <cmath>

namespace dpcontact
{
  namespace
  {
    constexpr unsigned int largest_direct = 30000; ///< unknowns, see runs/benchmark

    /// What is not modelled in space.
    void check_in_space(const SolverOptions &options)
    {
      const std::string in =
        std::string("in space (geometry = ") + to_string(options.geometry) + ") ";
      if (options.element == Element::serendipity_reduced)
        throw InputError(in + "element = serendipity is not for contact: nodes inside a face would "
                              "bear pressure without a displacement; take brick or quadratic");
      if (options.surface == Surface::sphere)
        throw InputError(
          in + "surface = sphere is not modelled: take parabola, or the axisymmetric geometry");
      if (options.octaves > 0 || options.mesh_distortion > 0)
        throw InputError(
          in + "octaves and mesh-distortion must be 0: they are for the axisymmetric geometry");
      if ((options.geometry == Geometry::published) != (options.mesh == MeshKind::published))
        throw InputError(std::string("geometry = ") + to_string(options.geometry) +
                         " does not go with mesh = " + to_string(options.mesh) +
                         ": leave mesh out");
    }
  } // namespace

  SolverOptions SolverOptions::of(const Geometry geometry)
  {
    SolverOptions options;
    options.geometry = geometry;
    if (in_space(geometry))
      {
        options.element    = Element::quadratic_full;
        options.resolution = 6;
      }
    if (geometry == Geometry::published)
      {
        options.element = Element::linear_mean_dilatation;
        options.mesh    = MeshKind::published;
      }
    return options;
  }

  double SolverOptions::angle() const
  {
    return geometry == Geometry::disc     ? 2 * M_PI
           : geometry == Geometry::sector ? sector_angle * (M_PI / 180)
                                          : M_PI / 2;
  }

  LinearSolver linear_solver(const SolverOptions &options, const unsigned int n_unknowns)
  {
    if (options.linear_solver != LinearSolver::automatic)
      return options.linear_solver;
    return n_unknowns <= largest_direct ? LinearSolver::direct : LinearSolver::iterative;
  }

  void SolverOptions::check() const
  {
    if (in_space(geometry))
      check_in_space(*this);
    check_option_ranges(*this);
  }
} // namespace dpcontact
