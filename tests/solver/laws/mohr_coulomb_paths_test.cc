#include "solver/laws/mohr_coulomb.h"
#include "solver/laws/strengths.h"
#include "tests/support/floating_point_traps.h"
#include "tests/support/law_checks.h"
#include "tests/support/soil.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <ostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace
{
  using namespace dpcontact;
  using namespace dpcontact::tests;

  const auto *const traps = FloatingPointTraps::install();

  // Stresses are of the size of C, strains of C/E with E = 1: a few roundings of either.
  constexpr double rounding = 1e-15 * cohesion;

  /// The stress at the end of a monotonic path of axial strain along z under lateral stresses held
  /// by Newton's method; E = 1.
  Response driven(const MohrCoulomb &law,
                  const double       lateral_x,
                  const double       lateral_y,
                  const double       axial_strain,
                  const unsigned int steps = 10)
  {
    const double mean   = (lateral_x + lateral_y) / 3;
    StressTensor strain = diagonal(lateral_x - mean, lateral_y - mean, -mean);
    strain /= 2 * law.shear_modulus;
    strain += mean / (3 * law.bulk_modulus) * dealii::unit_symmetric_tensor<3>();
    const double start = strain[2][2];
    Response     response;
    State        state;
    for (unsigned int step = 1; step <= steps; ++step)
      {
        strain[2][2]            = start + axial_strain * step / steps;
        unsigned int iterations = 0;
        for (;; ++iterations)
          {
            response        = law.evaluate(state, strain);
            const auto  &D  = response.tangent;
            const double rx = response.stress[0][0] - lateral_x;
            const double ry = response.stress[1][1] - lateral_y;
            const double xx = D[0][0][0][0], xy = D[0][0][1][1];
            const double yx = D[1][1][0][0], yy = D[1][1][1][1];
            const double det = xx * yy - xy * yx;
            if (std::max(std::abs(rx), std::abs(ry)) < 10 * rounding || iterations == 30)
              break;
            // Two tied directions: the two equations are the same.
            if (std::abs(det) < 1e-8 * xx * xx)
              {
                strain[0][0] -= rx / (xx + xy);
                strain[1][1] -= ry / (xx + xy);
              }
            else
              {
                strain[0][0] -= (yy * rx - xy * ry) / det;
                strain[1][1] -= (xx * ry - yx * rx) / det;
              }
          }
        EXPECT_LT(iterations, 30u);
        state = response.state;
      }
    return response;
  }

  const std::vector<Flow> flows{Flow::associated, Flow::half, Flow::isochoric};

  TEST(MohrCoulombPoint, UniaxialCompressionYieldsAtItsStrength)
  {
    for (const double phi : {0., 10., 30., 60.})
      for (const Flow flow : flows)
        {
          const MohrCoulomb law    = soil(0.2, phi, flow, Cutoff::none);
          const double      sine   = std::sin(phi * degree);
          const double      sig_c  = 2 * cohesion * std::cos(phi * degree) / (1 - sine);
          const auto        strain = diagonal(0.2, 0.2, -1) * sig_c;
          EXPECT_EQ(law.evaluate({}, (1 - 1e-9) * strain).branch, Branch::elastic);
          EXPECT_EQ(law.evaluate({}, (1 + 1e-9) * strain).branch, Branch::compression_edge);
          const auto end = driven(law, 0, 0, -5 * sig_c);
          EXPECT_NEAR(end.stress[2][2], -sig_c, 200 * rounding) << phi;
        }
  }

  TEST(MohrCoulombPoint, ConfinedCompressionFlowsAtTheConfinedStrength)
  {
    for (const double phi : {0., 10., 30., 60.})
      for (const Flow flow : flows)
        {
          const MohrCoulomb law      = soil(0.2, phi, flow, Cutoff::none);
          const double      sine     = std::sin(phi * degree);
          const double      N        = (1 + sine) / (1 - sine);
          const double      strength = 2 * cohesion * std::cos(phi * degree) / (1 - sine);
          // σ₂ = σ₁, and σ₂ between σ₁ and σ₃, where it has no influence
          for (const double middle : {-cohesion, -1.2 * cohesion})
            {
              const auto end = driven(law, -cohesion, middle, -10 * strength);
              EXPECT_EQ(end.branch,
                        middle == -cohesion ? Branch::compression_edge : Branch::regular);
              EXPECT_NEAR(end.stress[2][2], -strength - N * cohesion, 50 * (N + 4) * rounding);
              EXPECT_NEAR(dealii::trace(end.state.plastic_strain) *
                            (1 - std::sin(law.dilation_angle.value_or(law.friction_angle))),
                          -2 * end.state.plastic_strain[2][2] *
                            std::sin(law.dilation_angle.value_or(law.friction_angle)),
                          1e-13 * strength);
            }
        }
  }

  TEST(MohrCoulombPoint, UniaxialTensionYieldsAtItsStrengthOrTheCutoff)
  {
    for (const double phi : {0., 10., 30., 60.})
      for (const Flow flow : flows)
        {
          const double sine    = std::sin(phi * degree);
          const double pyramid = 2 * cohesion * std::cos(phi * degree) / (1 + sine);
          for (const Cutoff cutoff : {Cutoff::none, Cutoff::low, Cutoff::near_apex})
            {
              const MohrCoulomb law      = soil(0.2, phi, flow, cutoff);
              const double      strength = std::min(pyramid, law.tension_cutoff.value_or(1));
              const auto        strain   = diagonal(-0.2, -0.2, 1) * strength;
              EXPECT_EQ(law.evaluate({}, (1 - 1e-9) * strain).branch, Branch::elastic);
              EXPECT_EQ(law.evaluate({}, (1 + 1e-9) * strain).branch,
                        strength == pyramid ? Branch::extension_edge : Branch::cutoff);
              EXPECT_NEAR(driven(law, 0, 0, 5 * strength).stress[2][2], strength, 100 * rounding);
            }
        }
  }

  TEST(MohrCoulombPoint, BiaxialAndTriaxialExtension)
  {
    // Pulled along x and y, free along z: σ₁ = σ₂ stop where the pyramid's plane does, σ₃ = 0.
    for (const double phi : {0., 10., 30., 60.})
      {
        const double      sine    = std::sin(phi * degree);
        const MohrCoulomb law     = soil(0.2, phi, Flow::associated, Cutoff::none);
        const double      pull    = 2 * cohesion * std::cos(phi * degree) / (1 + sine);
        const auto        elastic = diagonal(1 - 0.2, 1 - 0.2, -2 * 0.2) * pull;
        EXPECT_EQ(law.evaluate({}, (1 - 1e-9) * elastic).branch, Branch::elastic);
        EXPECT_EQ(law.evaluate({}, (1 + 1e-9) * elastic).branch, Branch::compression_edge);
        // Triaxial extension: lateral −2 C, σ₃ = σ₂ = −2 C, axial σ₁ = (2 C cosφ + (1 − sinφ)
        // σ₃)/(1 + sinφ)
        const auto end = driven(law, -2 * cohesion, -2 * cohesion, 20 * cohesion);
        EXPECT_EQ(end.branch, Branch::extension_edge);
        EXPECT_NEAR(end.stress[2][2],
                    (2 * cohesion * std::cos(phi * degree) - (1 - sine) * 2 * cohesion) /
                      (1 + sine),
                    200 * rounding);
      }
    const MohrCoulomb cut     = soil(0.2, 30, Flow::associated, Cutoff::low);
    const auto        biaxial = cut.evaluate({}, diagonal(1, 1, -0.5) * (0.2 * cohesion));
    EXPECT_EQ(biaxial.branch, Branch::cutoff_edge);
    EXPECT_EQ(biaxial.stress[0][0], *cut.tension_cutoff);
    EXPECT_EQ(biaxial.stress[1][1], *cut.tension_cutoff);
    // σ₃ = 2 ν σ₁ + E ε₃
    EXPECT_NEAR(biaxial.stress[2][2], (2 * 0.2 * 0.1 - 0.1) * cohesion, rounding);
  }

  TEST(MohrCoulombPoint, HydrostaticTensionStopsAtTheApexOrTheCutoff)
  {
    for (const double nu : {0.2, 0.499})
      for (const double phi : {0., 1e-300, 1., 10., 30., 60., 70.})
        for (const Flow flow : flows)
          for (const Cutoff cutoff : {Cutoff::none, Cutoff::low, Cutoff::zero, Cutoff::near_apex})
            {
              MohrCoulomb law = soil(nu, phi, flow, cutoff);
              if (cutoff == Cutoff::near_apex)
                law.tension_cutoff = phi > 1e-3 ? 0.999 * cohesion / std::tan(phi * degree) : 1.;
              for (const double strain : {1e-6, 1e-3, 1., 1e3})
                {
                  const auto   r = law.evaluate({}, strain * dealii::unit_symmetric_tensor<3>());
                  const double trial = 3 * law.bulk_modulus * strain;
                  // C cosφ/sinφ, beyond every number here where φ vanishes
                  const double apex  = phi > 1e-3 ? cohesion / std::tan(phi * degree) : 1e300;
                  const double limit = std::min(apex, law.tension_cutoff.value_or(1e300));
                  EXPECT_EQ(r.branch,
                            trial <= limit           ? Branch::elastic
                            : cutoff == Cutoff::none ? Branch::apex
                                                     : Branch::cutoff_apex);
                  const double p = std::min(trial, limit);
                  EXPECT_LE((r.stress - p * dealii::unit_symmetric_tensor<3>()).norm(), 1e-15 * p);
                  if (trial > limit)
                    {
                      EXPECT_EQ(r.tangent.norm(), 0);
                      EXPECT_NEAR(dealii::trace(r.state.plastic_strain),
                                  (trial - p) / law.bulk_modulus,
                                  1e-14 * strain);
                    }
                }
            }
  }

  TEST(MohrCoulombPoint, ACutoffAtTheApexDoesNothing)
  {
    Uniform     uniform(11);
    MohrCoulomb cut = soil(0.2, 30, Flow::associated, Cutoff::none), uncut = cut;
    for (const double factor : {1 + 1e-15, 1.5, 1e300})
      {
        cut.tension_cutoff = factor * cohesion / std::tan(cut.friction_angle);
        for (unsigned int i = 0; i < 200; ++i)
          {
            const auto strain = random_strain(uniform, 10 * cohesion);
            const auto a = cut.evaluate({}, strain), b = uncut.evaluate({}, strain);
            EXPECT_EQ(a.branch, b.branch);
            EXPECT_EQ((a.stress - b.stress).norm(), 0);
          }
      }
  }

  TEST(MohrCoulombPoint, UniaxialStrainCompression)
  {
    // Elastic ratio σ₁/σ₃ = ν/(1 − ν). With x = −ε E(1 − ν)/((1 + ν)(1 − 2ν)) = −σ₃ yield is where
    // x (1 − N ν/(1 − ν)) = σc, never if N ν ≥ 1 − ν; then σ₃ = N σ₁ − σc.
    for (const double nu : {0.1, 0.2, 0.3, 0.45})
      for (const double phi : {0., 10., 30., 50.})
        {
          const MohrCoulomb law   = soil(nu, phi, Flow::associated, Cutoff::none);
          const double      sine  = std::sin(phi * degree);
          const double      N     = (1 + sine) / (1 - sine);
          const double      sig_c = laws::mohr_coulomb_compressive_strength(phi * degree, cohesion);
          const double      ratio = nu / (1 - nu);
          const double      excess = 1 - N * ratio;
          if (excess < 0)
            {
              EXPECT_EQ(law.evaluate({}, diagonal(0, 0, -1e3)).branch, Branch::elastic);
              continue;
            }
          const double modulus = (1 - nu) / ((1 + nu) * (1 - 2 * nu));
          const double yield   = sig_c / excess / modulus;
          EXPECT_EQ(law.evaluate({}, diagonal(0, 0, -(1 - 1e-9) * yield)).branch, Branch::elastic);
          const auto past = law.evaluate({}, diagonal(0, 0, -3 * yield));
          EXPECT_EQ(past.branch, Branch::compression_edge);
          EXPECT_EQ(past.stress[0][0], past.stress[1][1]);
          const double size = past.stress.norm();
          EXPECT_NEAR(past.stress[2][2], N * past.stress[0][0] - sig_c, 20 * N * 1e-16 * size);
          // With the stress on the edge, flow rule and Hooke's law leave no other answer.
          const auto &e = past.state.plastic_strain;
          EXPECT_NEAR(e[0][0] * (1 - sine), -e[2][2] * (1 + sine) / 2, 1e-15 * yield);
          EXPECT_EQ(e[0][0], e[1][1]);
          EXPECT_LE((past.stress - hooke(law, diagonal(0, 0, -3 * yield) - e)).norm(),
                    1e-14 * size);
        }
  }

  TEST(MohrCoulombPoint, DilatesOnThePlane)
  {
    // Δεᵖ = Δγ ((1 + sinψ)/2, 0, −(1 − sinψ)/2)
    for (const Flow flow : flows)
      {
        const MohrCoulomb law = soil(0.2, 30, flow, Cutoff::none);
        const auto        r   = law.evaluate({}, diagonal(3, 0, -3) * cohesion);
        ASSERT_EQ(r.branch, Branch::regular);
        const auto  &e     = r.state.plastic_strain;
        const double gamma = e[0][0] - e[2][2];
        EXPECT_GT(gamma, cohesion);
        EXPECT_EQ(e[1][1], 0);
        EXPECT_NEAR(dealii::trace(e),
                    gamma * std::sin(law.dilation_angle.value_or(law.friction_angle)),
                    10 * rounding);
      }
  }

  /// Tresca's return for principal trial deviators s₁ ≥ s₂ ≥ s₃ and pressure p: σ₁ − σ₃ = 2 C. On
  /// the plane σ₂ is kept; if that leaves the order the other two differ by 2 C and the tied ones
  /// are equal (the deviators sum to zero).
  std::array<double, 3> tresca(const std::array<double, 3> &s, const double p)
  {
    const double excess = (s[0] - s[2]) / 2 - cohesion;
    if (excess <= 0)
      return {s[0] + p, s[1] + p, s[2] + p};
    if (s[0] - excess < s[1])
      return {2 * cohesion / 3 + p, 2 * cohesion / 3 + p, -4 * cohesion / 3 + p};
    if (s[2] + excess > s[1])
      return {4 * cohesion / 3 + p, -2 * cohesion / 3 + p, -2 * cohesion / 3 + p};
    return {s[0] - excess + p, s[1] + p, s[2] + excess + p};
  }

  TEST(MohrCoulombPoint, FrictionlessIsTresca)
  {
    Uniform uniform(12);
    for (const double nu : {0.2, 0.499})
      for (const double phi : {0., 1e-300, 1e-12, 1e-6})
        {
          MohrCoulomb law    = soil(nu, 0, Flow::associated, Cutoff::none);
          law.friction_angle = phi;
          for (unsigned int i = 0; i < 500; ++i)
            {
              std::array<double, 3> x{};
              for (double &entry : x)
                entry = 10 * cohesion * uniform();
              std::sort(x.begin(), x.end(), std::greater<double>());
              const double          volume = x[0] + x[1] + x[2];
              const double          p      = law.bulk_modulus * volume;
              std::array<double, 3> s{};
              for (unsigned int d = 0; d < 3; ++d)
                s[d] = 2 * law.shear_modulus * (x[d] - volume / 3);
              const auto   expected = tresca(s, p);
              const auto   strain   = diagonal(x[2], x[0], x[1]);
              const auto   r        = law.evaluate({}, strain);
              const double size     = std::abs(p) + 20 * cohesion;
              // f changes by (σ₁ + σ₃)/2 sinφ, and K sinφ Δγ changes the pressure
              const double tolerance = 10 * rounding_of_stress(law, {}, strain) +
                                       10 * phi * (size + law.bulk_modulus * 30 * cohesion);
              EXPECT_NEAR(r.stress[1][1], expected[0], tolerance);
              EXPECT_NEAR(r.stress[2][2], expected[1], tolerance);
              EXPECT_NEAR(r.stress[0][0], expected[2], tolerance);
            }
        }
  }

  TEST(MohrCoulombPoint, EqualPrincipalStrainsGiveEqualStresses)
  {
    // As on an axis of symmetry, exactly or up to rounding: the spin term of a tied pair vanishes,
    // that of a pair which nothing parts is elastic; either way it is (D₁₁₁₁ − D₁₁₂₂)/2.
    Uniform          uniform(13);
    std::set<Branch> met;
    for (unsigned int i = 0; i < 3000; ++i)
      {
        const Cutoff cutoff = static_cast<Cutoff>(i % 4);
        const auto   law    = soil(i % 2 == 0 ? 0.2 : 0.499, 30, flows[i % 3], cutoff);
        const double a = 5 * cohesion * uniform(), b = 5 * cohesion * uniform();
        for (const double gap : {0., 1e-16, -1e-15, 1e-12})
          {
            const auto   r    = law.evaluate({}, diagonal(a, a * (1 + gap), b));
            const auto  &D    = r.tangent;
            const double size = rounding_of_stress(law, {}, diagonal(a, a, b));
            met.insert(r.branch);
            EXPECT_NEAR(r.stress[0][0],
                        r.stress[1][1],
                        10 * size + std::abs(2 * law.shear_modulus * a * gap));
            if (gap == 0)
              {
                EXPECT_EQ(r.stress[0][0], r.stress[1][1]);
              }
            const double spin = 2 * D[0][1][0][1];
            EXPECT_TRUE(spin == 0 || std::abs(spin - 2 * law.shear_modulus) < 1e-15) << spin;
            EXPECT_NEAR(D[0][0][0][0] - D[0][0][1][1], spin, 1e-14 * stiffness(law));
          }
      }
    EXPECT_EQ(met,
              (std::set<Branch>{Branch::elastic,
                                Branch::compression_edge,
                                Branch::extension_edge,
                                Branch::apex,
                                Branch::cutoff,
                                Branch::cutoff_edge,
                                Branch::cutoff_apex,
                                Branch::compression_corner,
                                Branch::extension_corner}));
  }

  TEST(MohrCoulombPoint, ShearAcrossEqualPrincipalStrains)
  {
    // Central differences in each shear with two principal strains exactly equal.
    for (const Cutoff cutoff : {Cutoff::none, Cutoff::low})
      for (const Flow flow : flows)
        for (const auto &[x, y, z] : {std::array<double, 3>{1, 1, -4},
                                      {-1, -1, 4},
                                      {4, -1, -1},
                                      {-4, 1, 1},
                                      {1, -4, 1},
                                      {0.5, 0.5, 0.1},
                                      {3, 2.9, 2.9}})
          {
            const MohrCoulomb law    = soil(0.2, 30, flow, cutoff);
            const auto        strain = cohesion * diagonal(x, y, z);
            const auto        r      = law.evaluate({}, strain);
            for (unsigned int i = 3; i < 6; ++i)
              {
                const double h = 1e-5 * cohesion;
                StressTensor e;
                e.access_raw_entry(i) = 1;
                const auto plus       = law.evaluate({}, strain + h * e);
                const auto minus      = law.evaluate({}, strain - h * e);
                ASSERT_EQ(plus.branch, r.branch);
                ASSERT_EQ(minus.branch, r.branch);
                // truncation (h/gap)² < 1e-8 and rounding 1e-15/1e-5
                EXPECT_LE(((plus.stress - minus.stress) / (2 * h) - r.tangent * e).norm(), 1e-8);
              }
          }
  }

  TEST(MohrCoulombPoint, AgreesWithTheNearestOfManyAdmissibleStresses)
  {
    // Associated: the energy distance to the trial stress is smallest at the returned one. The
    // admissible stresses have their own directions, mostly not those of the trial stress.
    Uniform uniform(14);
    for (const Cutoff cutoff : {Cutoff::none, Cutoff::low, Cutoff::zero, Cutoff::near_apex})
      for (const double phi : {0., 20., 50.})
        {
          const MohrCoulomb law    = soil(0.3, phi, Flow::associated, cutoff);
          const auto        energy = [&law](const StressTensor &stress) {
            const auto   s = dealii::deviator(stress);
            const double p = dealii::trace(stress) / 3;
            return s * s / (4 * law.shear_modulus) + p * p / (2 * law.bulk_modulus);
          };
          for (unsigned int i = 0; i < 50; ++i)
            {
              const auto   strain = random_strain(uniform, 8 * cohesion);
              const auto   trial  = hooke(law, strain);
              const auto   r      = law.evaluate({}, strain);
              const double least  = energy(trial - r.stress);
              for (unsigned int k = 0; k < 50; ++k)
                {
                  const auto tau =
                    r.stress + uniform.tensor(cohesion * log_uniform(uniform, -5, 1));
                  if (law.yield_function(tau, 0) <= 0)
                    {
                      EXPECT_GE(energy(trial - tau), least * (1 - 1e-13));
                    }
                }
            }
        }
  }

  TEST(MohrCoulombPoint, KeepsItsDigitsFarBeyondYield)
  {
    // A thousand times the yield strain, steep and nearly incompressible: on the surface up to
    // the rounding of the stress, not of the trial stress.
    Uniform uniform(15);
    for (const double phi : {0., 30., 70.})
      for (const Flow flow : flows)
        for (const Cutoff cutoff : {Cutoff::none, Cutoff::low, Cutoff::near_apex})
          {
            const MohrCoulomb law = soil(0.499, phi, flow, cutoff);
            for (unsigned int i = 0; i < 300; ++i)
              {
                const auto strain = random_strain(uniform, 1e3 * cohesion);
                const auto r      = law.evaluate({}, strain);
                if (r.branch != Branch::elastic)
                  {
                    EXPECT_NEAR(
                      law.yield_function(r.stress, 0), 0, 3e-15 * (r.stress.norm() + cohesion));
                  }
                EXPECT_TRUE(std::isfinite(r.tangent.norm()));
              }
          }
  }

  TEST(MohrCoulombPoint, IsPerfectlyPlastic)
  {
    const MohrCoulomb law = soil(0.2, 30, Flow::associated, Cutoff::low);
    State             state;
    state.hardening_variable = 0.7;
    EXPECT_EQ(law.evaluate(state, diagonal(3, 0, -3) * cohesion).state.hardening_variable, 0.7);
    EXPECT_EQ(law.yield_function({}, 0.7), law.yield_function({}, 0));
  }

  TEST(MohrCoulombPoint, ZeroStrainIsElastic)
  {
    for (const Cutoff cutoff : {Cutoff::none, Cutoff::low, Cutoff::zero})
      {
        const auto r = soil(0.2, 30, Flow::associated, cutoff).evaluate({}, {});
        EXPECT_EQ(r.branch, Branch::elastic);
        EXPECT_EQ(r.stress.norm(), 0);
      }
  }

  TEST(MohrCoulombParameters, StrengthAndCohesion)
  {
    for (const double phi_deg : {0., 20., 45., 80.})
      {
        const double phi = phi_deg * degree;
        EXPECT_NEAR(laws::mohr_coulomb_cohesion(phi, 15),
                    15 * (1 - std::sin(phi)) / (2 * std::cos(phi)),
                    15 * 1e-15);
        EXPECT_NEAR(
          laws::mohr_coulomb_compressive_strength(phi, laws::mohr_coulomb_cohesion(phi, 15)),
          15,
          15 * 1e-15);
      }
    // tan(δ/2) → δ/2 for φ = 90° − δ; δ is known to a rounding of φ
    const double delta = 1e-6;
    EXPECT_NEAR(laws::mohr_coulomb_cohesion(M_PI / 2 - delta, 1), delta / 4, 1e-16);
  }

  TEST(MohrCoulombParameters, Association)
  {
    EXPECT_TRUE(soil(0.2, 30, Flow::associated, Cutoff::none).associated());
    EXPECT_FALSE(soil(0.2, 30, Flow::half, Cutoff::none).associated());
    EXPECT_TRUE(soil(0.2, 0, Flow::isochoric, Cutoff::none).associated());
    EXPECT_NEAR(soil(0.2, 60, Flow::half, Cutoff::none).strength(), cohesion / 2, rounding);
  }
} // namespace
