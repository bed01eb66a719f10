#include "solver/path/elastic_solution.h"

#include "solver/closed_form/hertz.h"

#include <algorithm>
#include <cmath>

namespace dpcontact
{
  namespace
  {
    /// Largest von Mises stress over the peak pressure: where a metal would yield.
    double mises_ratio(const Material &material, const double radius)
    {
      const Material metal{material.youngs_modulus, material.poisson_ratio, Angle(0), 1};
      return 1 / first_yield(metal, radius).pressure;
    }

    CurvePoint point_at(const Material &material,
                        const Scene    &scene,
                        const double    force,
                        const double    mises_ratio)
    {
      CurvePoint point;
      point.force            = force;
      point.approach         = hertz::approach(material, scene, force);
      point.contact_radius   = hertz::contact_radius(scene, point.approach);
      point.pressure_max     = force > 0 ? hertz::peak_pressure(force, point.contact_radius) : 0.;
      point.mises_stress_max = mises_ratio * point.pressure_max;
      point.plastic_volume = point.dissipated_energy = point.plastic_strain_max = 0;
      return point;
    }
  } // namespace

  Solution
  elastic_solution(const Material &material, const Scene &scene, const unsigned int loading_steps)
  {
    Solution solution;
    solution.yield = first_yield(material, scene);
    double ratio   = mises_ratio(material, scene.radius);
    if (scene.second && scene.second->material)
      ratio = std::max(ratio, mises_ratio(*scene.second->material, scene.radius));
    for (unsigned int i = 0; i <= loading_steps; ++i)
      {
        const double tau = static_cast<double>(i) / loading_steps;
        solution.curve.loading.push_back(
          point_at(material, scene, scene.force_max * tau * tau * tau, ratio));
      }
    solution.curve.unloading.assign(solution.curve.loading.rbegin(), solution.curve.loading.rend());
    solution.coarser_steps = solution.curve;

    const CurvePoint      &peak = solution.curve.loading.back();
    const double           a    = peak.contact_radius;
    constexpr unsigned int n    = 80; // points across the contact
    solution.mesh_radius        = a;
    for (unsigned int i = 0; i < n; ++i)
      {
        const double x = (i + 0.5) / n;
        solution.peak_profile.push_back({x * a, peak.pressure_max * std::sqrt(1 - x * x)});
      }
    for (unsigned int i = 0; i <= 5 * n; ++i)
      {
        const double u     = static_cast<double>(i) / n;
        const double shape = 1 / (1 + u * u);
        const double t     = u > 0 ? u * std::atan(1 / u) : 0.;
        solution.peak_axis.push_back(
          {u * a,
           -peak.pressure_max * shape,
           peak.pressure_max * (-(1 + material.poisson_ratio) * (1 - t) + shape / 2)});
      }
    return solution;
  }
} // namespace dpcontact
