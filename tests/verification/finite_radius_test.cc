// What the small-strain half-space leaves out: the sphere's own profile and free surface, measured
// against it at equal Λ and growing a/R, both on the same mesh (mapped and not) with the same far
// boundary, and without the remote compliance. Strains stay small in both: rotations and finite
// strains, which are of order a/R as well, are in neither.

#include "solver/closed_form/first_yield.h"
#include "solver/path/remote_compliance.h"
#include "solver/path/runs.h"
#include "solver/path/step_extrapolation.h"
#include "tests/support/rocks.h"
#include "tests/support/solver_environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

using namespace dpcontact;
using tests::rock;

namespace
{
  const auto *const solver_environment = tests::SolverEnvironment::install();

  constexpr double far_over_R = 0.8;

  /// Relative changes of the coefficients, and of both approaches over δ_max.
  struct Change
  {
    double a, b, m, n, peak, released;
  };

  Curve run(const Material      &material,
            const Scene         &scene,
            const SolverOptions &options,
            const double         mesh_radius,
            const unsigned int   steps)
  {
    HalfSpaceModel model(material, scene, options, mesh_radius);
    const Curve    coarse = run_cycle(model, steps / 2);
    return extrapolate_steps(coarse, run_cycle(model, steps));
  }

  /// @param mesh_radius of the scene of `material`, R = 0.1 m and 100 N. By similarity, σc λ and F λ³
  /// at the same E and R leave Λ and multiply a/R by λ.
  /// @param kappa a/R to reach.
  Change change(const char        *name,
                const Material    &material,
                const double       mesh_radius,
                const double       kappa,
                const unsigned int resolution,
                const unsigned int steps)
  {
    Material     scaled = material;
    Scene        scene;
    const double lambda = kappa / (mesh_radius / scene.radius);
    scaled.compressive_strength *= lambda;
    scene.force_max *= lambda * lambda * lambda;

    SolverOptions options;
    options.resolution    = resolution;
    options.domain_radius = far_over_R / kappa;
    const double a        = kappa * scene.radius;
    const Curve  flat     = run(scaled, scene, options, a, steps);
    options.surface       = Surface::sphere;
    const Curve  raw      = run(scaled, scene, options, a, steps);
    const double C        = remote_compliance(scaled, scene.radius, options, a);
    const Curve  sphere   = remove_linear_compliance(raw, C);

    const FirstYield yield = first_yield(scaled, scene.radius);
    const auto       of    = [&](const Curve &curve) {
      return fit_curve(curve, yield.force, yield.approach);
    };
    const auto  before = of(flat), after = of(sphere);
    const auto  relative = [](const double x, const double reference) { return x / reference - 1; };
    const auto &l0 = before.loading.fit.law, &l1 = after.loading.fit.law;
    const auto &u0 = before.unloading.fit.law, &u1 = after.unloading.fit.law;
    const double peak = flat.loading.back().approach;
    const Change result{relative(l1.coefficient, l0.coefficient),
                        relative(l1.exponent, l0.exponent),
                        relative(u1.coefficient, u0.coefficient),
                        relative(u1.exponent, u0.exponent),
                        relative(sphere.loading.back().approach, peak),
                        (sphere.residual_approach() - flat.residual_approach()) / peak};
    std::printf(
      "%s, a/R %.4f, Lambda %.1f: C F/delta_max %.5f; relative change of a %+.5f b %+.5f m %+.5f "
      "n %+.5f delta_max %+.5f; delta_res over delta_max %+.5f\n",
      name,
      kappa,
      scene.force_max / yield.force,
      C * scene.force_max / peak,
      result.a,
      result.b,
      result.m,
      result.n,
      result.peak,
      result.released);
    return result;
  }
} // namespace

TEST(FiniteRadius, Type1ChangesInProportionToContactOverSphereRadius)
{
  // Slopes as resolution 40 with 64 steps gives them too, to 0.01; the second order is below 2
  // (a/R)².
  const auto material = rock(10, 0.15, 25, 15);
  for (const double kappa : {0.00955, 0.02, 0.04})
    {
      const Change c      = change("type 1", material, 0.955e-3, kappa, 16, 32);
      const double second = 2 * kappa * kappa;
      EXPECT_NEAR(c.a, -0.15 * kappa, 0.01 * kappa + second);
      EXPECT_NEAR(c.b, 0.11 * kappa, 0.01 * kappa + second);
      EXPECT_NEAR(c.m, -0.42 * kappa, 0.02 * kappa + second);
      EXPECT_NEAR(c.n, 0.066 * kappa, 0.01 * kappa + second);
      EXPECT_NEAR(c.peak, -0.08 * kappa, 0.01 * kappa + second);
      EXPECT_NEAR(c.released, -0.25 * kappa, 0.02 * kappa + second);
    }
}

TEST(FiniteRadius, MostPlasticRowChangesLinearlyInUnloadingAndQuadraticallyInLoading)
{
  // The mesh and the steps scatter a and m by 0.005 and b and n by 0.001 here.
  const auto material = rock(30, 0.1, 20, 5);
  for (const double kappa : {0.00944, 0.02, 0.04})
    {
      const Change c = change("most plastic row", material, 0.944e-3, kappa, 40, 128);
      EXPECT_NEAR(c.a, 25 * kappa * kappa, 0.006);
      EXPECT_NEAR(c.b, -3 * kappa * kappa, 0.0015);
      EXPECT_NEAR(c.m, -0.8 * kappa, 0.006 + 6 * kappa * kappa);
      EXPECT_NEAR(c.n, 0.22 * kappa, 0.001 + 2 * kappa * kappa);
    }
}
