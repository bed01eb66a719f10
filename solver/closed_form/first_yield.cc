#include "solver/closed_form/first_yield.h"

#include "solver/closed_form/hertz.h"
#include "solver/laws/criterion.h"
#include "solver/laws/strengths.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>

namespace dpcontact
{
  namespace
  {
    // With t = u atan(1/u): fall = 1 − t and excess = 1/(1+u²) − 3(1 − t), which is O(1/u⁴). At
    // depth both come from their series in x = 1/u², as the differences would lose all digits (x =
    // 0.09, 16 terms: 1e-17).
    struct DepthFunctions
    {
      double fall;
      double excess;
    };

    DepthFunctions depth_functions(const double u)
    {
      const double x = 1 / (u * u);
      if (x > 0.09)
        {
          const double fall = 1 - u * std::atan(1 / u);
          return {fall, 1 / (1 + u * u) - 3 * fall};
        }
      double fall = 0, excess = 0;
      for (int n = 16; n >= 1; --n)
        {
          fall   = x * (1. / (2 * n + 1) - fall);
          excess = x * ((2. * n - 2) / (2 * n + 1) - excess);
        }
      return {fall, excess};
    }

    struct AxisMaximum
    {
      double depth; // u = z/a
      double ratio; // (√J₂ + α I₁)/P₀
    };

    // Model section 3's √J₂/P₀ = (3/(2(1+u²)) − (1+ν)(1−t))/√3 (positive for ν ≤ 0.5) and
    // I₁/P₀ = −2(1+ν)(1−t), regrouped with κ = 1 − √3 α so that nothing cancels:
    //   √3 (√J₂ + α I₁)/P₀ = (3/2) excess + (3(½−ν) + 2κ(1+ν)) fall.
    // It rises from the surface, has one maximum, and falls to zero from above, because the second
    // term, positive for every ν < 0.5 and φ < 90°, decays slower. So the axis always yields, at a
    // finite depth: u = 0.38 at the least (ν = φ = 0), ever deeper as ν → 0.5 and φ → 90° together.
    AxisMaximum axis_maximum(const double poisson_ratio, const double kappa)
    {
      const double weight = 3 * (0.5 - poisson_ratio) + 2 * kappa * (1 + poisson_ratio);
      // Half the digits is all that values near a maximum can tell about its place.
      const int  bits   = std::numeric_limits<double>::digits / 2;
      const auto result = boost::math::tools::brent_find_minima(
        [weight](const double log_u) {
          const DepthFunctions f = depth_functions(std::exp(log_u));
          return -(1.5 * f.excess + weight * f.fall) / std::sqrt(3.);
        },
        std::log(0.1),
        std::log(1e10),
        bits);
      return {std::exp(result.first), -result.second};
    }
  } // namespace

  FirstYield first_yield(const Material &material, const double radius)
  {
    material.check();
    Scene scene;
    scene.radius = radius;
    scene.check();

    const double nu = material.poisson_ratio;
    const double kappa =
      std::sqrt(3.) * laws::drucker_prager_strength(material.friction_angle.radians(), 1);
    const double      k       = material.compressive_strength * kappa / std::sqrt(3.);
    const AxisMaximum maximum = axis_maximum(nu, kappa);

    // The cone inside the yield surface has α and k smaller by the same factor; the largest tension
    // of Hertz's field is (1−2ν)P₀/3, on the ring.
    const double inside       = inscribed_cone(material);
    double       inner_stress = 3 * inside * k / (1 - 2 * nu);
    if (material.tension_cutoff)
      inner_stress = std::min(inner_stress, 3 * *material.tension_cutoff / (1 - 2 * nu));
    const double inner_axis = inside < 1
                                ? inside * k / axis_maximum(nu, 1 - inside * (1 - kappa)).ratio
                                : k / maximum.ratio;

    // Contact radius over sphere radius, a/R = π P₀ (1−ν²)/(2E), and F = (2/3) π a² P₀.
    const double slope = M_PI * (1 - nu * nu) / (2 * material.youngs_modulus);
    const auto   force = [&](const double pressure) {
      const double a = radius * (slope * pressure);
      return 2. / 3. * M_PI * a * a * pressure;
    };

    FirstYield yield;
    yield.pressure                  = k / maximum.ratio;
    yield.force                     = force(yield.pressure);
    yield.contact_radius            = radius * (slope * yield.pressure);
    yield.approach                  = 2 * yield.contact_radius * (slope * yield.pressure);
    yield.depth_over_contact_radius = maximum.depth;
    yield.ring_pressure             = 3 * shear_strength(material) / (1 - 2 * nu);
    yield.ring_force                = force(yield.ring_pressure);
    yield.elastic_pressure          = std::min(inner_axis, inner_stress);
    yield.elastic_force             = force(yield.elastic_pressure);
    yield.body_force                = {yield.force, yield.force};
    return yield;
  }

  FirstYield first_yield(const Material &material, const Scene &scene)
  {
    scene.check();
    if (!scene.second)
      return first_yield(material, scene.radius);

    // Pressures are each body's own; forces and lengths follow from the pair's R* and E*.
    const double radius = scene.effective_radius();
    const double slope = M_PI / (2 * hertz::effective_modulus(material, scene)); // a/R* = slope P₀
    const auto   force = [&](const double pressure) {
      const double a = radius * (slope * pressure);
      return 2. / 3. * M_PI * a * a * pressure;
    };
    FirstYield yield = first_yield(material, scene.radius);
    yield.body_force = {force(yield.pressure), std::numeric_limits<double>::infinity()};
    if (scene.second->material)
      {
        const FirstYield second = first_yield(*scene.second->material, scene.radius);
        yield.body_force[1]     = force(second.pressure);
        if (second.pressure < yield.pressure)
          {
            yield.pressure                  = second.pressure;
            yield.depth_over_contact_radius = second.depth_over_contact_radius;
          }
        yield.ring_pressure    = std::min(yield.ring_pressure, second.ring_pressure);
        yield.elastic_pressure = std::min(yield.elastic_pressure, second.elastic_pressure);
      }
    yield.force          = force(yield.pressure);
    yield.contact_radius = radius * (slope * yield.pressure);
    yield.approach       = yield.contact_radius * (slope * yield.pressure);
    yield.ring_force     = force(yield.ring_pressure);
    yield.elastic_force  = force(yield.elastic_pressure);
    return yield;
  }
} // namespace dpcontact
