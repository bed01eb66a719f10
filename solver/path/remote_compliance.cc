#include "solver/path/remote_compliance.h"

#include "meshing/errors.h"
#include "solver/closed_form/hertz.h"
#include "solver/path/runs.h"

#include <cmath>
#include <sstream>

namespace dpcontact
{
  namespace
  {
    [[noreturn]] void refuse(const double compliance, const char *why)
    {
      std::ostringstream message;
      message << "remove linear compliance: C = " << compliance << " m/N " << why;
      throw InputError(message.str());
    }

    std::vector<CurvePoint>
    without(const std::vector<CurvePoint> &branch, const double compliance, const double direction)
    {
      std::vector<CurvePoint> result = branch;
      for (std::size_t i = 0; i < result.size(); ++i)
        {
          result[i].approach -= compliance * result[i].force;
          if (i > 0 && !(direction * (result[i].approach - result[i - 1].approach) > 0))
            refuse(compliance, "is too large: the approach would no longer grow with the force");
        }
      return result;
    }
  } // namespace

  double remote_compliance(const Material      &material,
                           const double         sphere_radius,
                           const SolverOptions &options,
                           const double         mesh_radius)
  {
    material.check();
    options.check();
    if (!(std::isfinite(mesh_radius) && mesh_radius > 0))
      throw InputError("remote compliance: mesh_radius = " + std::to_string(mesh_radius) +
                       " m is out of range; it must be positive");

    Material elastic             = material;
    elastic.compressive_strength = 1e6 * material.youngs_modulus;
    Scene scene;
    scene.radius    = sphere_radius;
    scene.force_max = hertz::force(
      elastic, sphere_radius, mesh_radius * mesh_radius / hertz::effective_radius(sphere_radius));
    scene.check();

    const auto approach = [&](const Surface surface) {
      SolverOptions used = options;
      used.surface       = surface;
      HalfSpaceModel model(elastic, scene, used, mesh_radius);
      return run_to_peak(model, 1).back().approach;
    };
    return (approach(Surface::sphere) - approach(Surface::parabola)) / scene.force_max;
  }

  Curve remove_linear_compliance(const Curve &curve, const double compliance)
  {
    if (!std::isfinite(compliance))
      refuse(compliance, "is not a number");
    return {without(curve.loading, compliance, 1), without(curve.unloading, compliance, -1)};
  }
} // namespace dpcontact
