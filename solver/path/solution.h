#ifndef DPCONTACT_SOLVER_PATH_SOLUTION_H
#define DPCONTACT_SOLVER_PATH_SOLUTION_H

#include "meshing/mesh_quality.h"
#include "solver/closed_form/first_yield.h"
#include "solver/output/plastic_zone.h"
#include "solver/output/pressure_profile.h"
#include "solver/output/recovery.h"
#include "solver/problem/case.h"
#include "solver/problem/curve.h"
#include "solver/problem/options.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dpcontact
{
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
    std::optional<PlasticZone> flow_zone; ///< yielding at F_max; unset in the same case
    /// The same of the second body, where that is another and deforms.
    std::optional<PlasticZone> second_plastic_zone, second_flow_zone;
    /// In space: how far the pressure at F_max is from axisymmetric (pressure_profile.h). Otherwise
    /// 0.
    double axisymmetry_deviation = 0;
    double step_error            = 0; ///< estimated error of F(δ) in the load step, over F_max
    /// The curve with one halving of the load steps less: how far apart both are tells the error
    /// that the load step leaves in a coefficient. Equal to `curve` where it has no such error.
    Curve        coarser_steps;
    double       coarser_share = 0; ///< expected share of that difference, see step_refinement.h
    double       mesh_radius   = 0; ///< contact radius that the mesh is fitted to, m
    MeshQuality  mesh_quality;      ///< of the mesh in units of its contact radius
    Cost         cost;
    PathChecks   checks;               ///< of the finest run; zero where Hertz's form was used
    unsigned int apex_points = 0;      ///< converged apex states met over the whole path
    std::vector<std::string> warnings; ///< e.g. small strain left behind
  };

  /// Adds what limits the trust in a solution to its `warnings`: doubts_about() the case with the
  /// contact radius that was found, and a plastic strain > 0.1.
  void add_warnings(const Case &input, Solution &solution);

  /// Largest memory that this process has held, bytes.
  std::uint64_t peak_memory();
} // namespace dpcontact

#endif
