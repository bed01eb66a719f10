#include "meshing/errors.h"
#include "solver/closed_form/first_yield.h"
#include "solver/closed_form/hertz.h"
#include "solver/laws/law.h"
#include "solver/laws/strengths.h"
#include "tests/support/floating_point_traps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
  using namespace dpcontact;

  const auto *const traps = tests::FloatingPointTraps::install();

  Material material(const double E, const double nu, const double phi_deg, const double sigma_c)
  {
    Material m;
    m.youngs_modulus       = E;
    m.poisson_ratio        = nu;
    m.friction_angle       = Angle(phi_deg);
    m.compressive_strength = sigma_c;
    return m;
  }

  // Tolerances below of half a unit in the last digit are those of a number rounded for print.

  TEST(FirstYield, TableThreeOfWang2018)
  {
    // F_y and δ_y as `python3 tests/verification/first_yield.py` evaluates them from the stress on
    // the axis; the paper prints 9.06 and 84.45 N. Its δ_y, 0.00164 and 0.00706 mm, is per sphere:
    // half of the mutual approach.
    const FirstYield type_1 = first_yield(material(10e9, 0.15, 25, 15e6), 0.1);
    EXPECT_NEAR(type_1.force, 9.056, 0.0005);
    EXPECT_NEAR(type_1.approach, 3.2792e-6, 0.00005e-6);
    EXPECT_NEAR(type_1.approach / 2, 0.00164e-3, 0.000005e-3);

    const FirstYield type_2 = first_yield(material(10e9, 0.25, 35, 25e6), 0.1);
    EXPECT_NEAR(type_2.force, 84.450, 0.0005);
    EXPECT_NEAR(type_2.approach, 14.129e-6, 0.0005e-6);
    EXPECT_NEAR(type_2.approach / 2, 0.00706e-3, 0.000005e-3);
  }

  TEST(FirstYield, PressureAndDepthOverPoissonRatioAndFrictionAngle)
  {
    struct Row
    {
      double nu, phi, pressure, depth;
    };
    for (const Row &row : {Row{0.1, 20, 1.59073, 0.605},
                           Row{0.2, 20, 1.80354, 0.659},
                           Row{0.3, 20, 2.05673, 0.715},
                           Row{0.1, 30, 1.67784, 0.719},
                           Row{0.2, 30, 1.97972, 0.790},
                           Row{0.3, 30, 2.36221, 0.865},
                           Row{0.1, 40, 1.71883, 0.848},
                           Row{0.2, 40, 2.13820, 0.942},
                           Row{0.3, 40, 2.71747, 1.047}})
      {
        const FirstYield yield = first_yield(material(10e9, row.nu, row.phi, 1e6), 0.1);
        EXPECT_NEAR(yield.pressure / 1e6, row.pressure, 0.5e-5) << row.nu << ' ' << row.phi;
        EXPECT_NEAR(yield.depth_over_contact_radius, row.depth, 0.5e-3) << row.nu << ' ' << row.phi;
      }
  }

  TEST(FirstYield, VonMisesInception)
  {
    struct Row
    {
      double nu, pressure, depth;
    };
    for (const Row &row : {Row{0.1, 1.39448, 0.415},
                           Row{0.2, 1.49859, 0.448},
                           Row{0.3, 1.61280, 0.481},
                           Row{0.4, 1.73848, 0.514}})
      {
        const FirstYield yield = first_yield(material(200e9, row.nu, 0, 300e6), 0.01);
        EXPECT_NEAR(yield.pressure / 300e6, row.pressure, 0.5e-5) << row.nu;
        EXPECT_NEAR(yield.depth_over_contact_radius, row.depth, 0.5e-3) << row.nu;
      }
  }

  TEST(FirstYield, RingYieldsBeforeTheAxisWhereFrictionIsHigh)
  {
    struct Row
    {
      double nu, phi, ratio;
    };
    for (const Row &row : {Row{0.1, 30, 0.464},
                           Row{0.2, 30, 0.670},
                           Row{0.1, 40, 0.188},
                           Row{0.2, 40, 0.231},
                           Row{0.3, 40, 0.380}})
      {
        const FirstYield yield = first_yield(material(10e9, row.nu, row.phi, 20e6), 0.1);
        EXPECT_NEAR(yield.ring_force / yield.force, row.ratio, 0.5e-3) << row.nu << ' ' << row.phi;
        EXPECT_EQ(yield.onset_force(), yield.ring_force);
      }
    const FirstYield axis_first = first_yield(material(10e9, 0.3, 20, 20e6), 0.1);
    EXPECT_EQ(axis_first.onset_force(), axis_first.force);
  }

  /// Stresses of Hertz's contact below the surface (Huber 1904; Johnson 1985, ch. 3), a = p₀ = 1.
  laws::StressTensor hertz_stress(const double nu, const double r, const double z)
  {
    const double       difference = r * r + z * z - 1;
    const double       u     = (difference + std::sqrt(difference * difference + 4 * z * z)) / 2;
    const double       ratio = z / std::sqrt(u), cube = ratio * ratio * ratio * u / (u * u + z * z);
    const double       arc   = (1 + nu) * std::sqrt(u) * std::atan(1 / std::sqrt(u));
    const double       shell = (1 - 2 * nu) / (3 * r * r) * (1 - ratio * ratio * ratio);
    laws::StressTensor sigma;
    sigma[0][0] = shell + cube + ratio * (u * (1 - nu) / (1 + u) + arc - 2);
    sigma[1][1] = -cube;
    sigma[2][2] = -shell - ratio * (2 * nu + (1 - nu) * u / (1 + u) - arc);
    sigma[0][1] = -r * z * z / (u * u + z * z) * std::sqrt(u) / (1 + u);
    return sigma;
  }

  // Nothing yields up to the elastic force: by the yield functions, at 40,000 places of the field.
  TEST(FirstYield, NothingYieldsUpToTheElasticForce)
  {
    std::size_t judged = 0;
    for (const auto change : {+[](Material &) {},
                              +[](Material &m) { m.flow_stress_ratio = 0.8; },
                              +[](Material &m) { m.criterion = Criterion::mohr_coulomb; },
                              +[](Material &m) {
                                m.criterion      = Criterion::mohr_coulomb;
                                m.tension_cutoff = 1e6;
                              },
                              +[](Material &m) {
                                m.criterion      = Criterion::von_mises;
                                m.friction_angle = Angle(0);
                              }})
      for (const double nu : {0., 0.15, 0.3, 0.45})
        for (const double phi : {5., 25., 50.})
          {
            Material m = material(10e9, nu, phi, 15e6);
            change(m);
            const FirstYield yield   = first_yield(m, 0.1);
            const laws::Law  law     = law_of(m);
            double           largest = -std::numeric_limits<double>::max();
            for (int i = 1; i <= 200; ++i)
              for (int j = 1; j <= 200; ++j)
                largest = std::max(
                  largest,
                  laws::yield_excess(
                    law, yield.elastic_pressure * hertz_stress(nu, 0.015 * i, 0.015 * j), 0));
            EXPECT_LE(largest, 1e-9) << nu << ' ' << phi;
            EXPECT_LE(yield.elastic_force, yield.onset_force() * (1 + 1e-12));
            EXPECT_GT(yield.elastic_force, 0);
            ++judged;
          }
    EXPECT_EQ(judged, 60U);
  }

  TEST(FirstYield, OfTheCircularConeTheElasticForceIsThatOfTheOnset)
  {
    for (const double phi : {0., 20., 40.})
      {
        const FirstYield yield = first_yield(material(10e9, 0.2, phi, 20e6), 0.1);
        EXPECT_NEAR(yield.elastic_force / yield.onset_force(), 1, 1e-14);
      }
  }

  TEST(FirstYield, LoadLevelsOfTheGridOf162Materials)
  {
    int    scale_above_peak = 0, yields_nowhere = 0, strongly_plastic = 0, rows = 0;
    double smallest = std::numeric_limits<double>::max(), largest = 0;
    for (const double E : {10e9, 20e9, 30e9})
      for (const double nu : {0.1, 0.2, 0.3})
        for (const double phi : {20., 30., 40.})
          for (const double sigma_c : {5e6, 10e6, 20e6, 30e6, 40e6, 50e6})
            {
              const FirstYield yield = first_yield(material(E, nu, phi, sigma_c), 0.1);
              const double     level = 100 / yield.force;
              ++rows;
              scale_above_peak += yield.force >= 100;
              yields_nowhere += yield.onset_force() >= 100;
              strongly_plastic += level > 100;
              smallest = std::min(smallest, level);
              largest  = std::max(largest, level);
            }
    EXPECT_EQ(rows, 162);
    EXPECT_EQ(scale_above_peak, 29);
    EXPECT_EQ(yields_nowhere, 19);
    EXPECT_EQ(strongly_plastic, 41);
    EXPECT_NEAR(smallest, 0.093, 0.0005);
    EXPECT_NEAR(largest, 3532, 0.5);
  }

  TEST(FirstYield, ScalesObeyHertz)
  {
    const Material   m     = material(10e9, 0.15, 25, 15e6);
    const FirstYield yield = first_yield(m, 0.1);
    // Two closed forms of one solution: they differ by rounding only.
    EXPECT_NEAR(hertz::force(m, 0.1, yield.approach) / yield.force, 1, 1e-13);
    EXPECT_NEAR(hertz::contact_radius(0.1, yield.approach) / yield.contact_radius, 1, 1e-13);
    EXPECT_NEAR(hertz::peak_pressure(yield.force, yield.contact_radius) / yield.pressure, 1, 1e-13);
  }

  /// √J₂ + α I₁ over P₀ on the axis from the principal stresses of Hertz's solution (Johnson,
  /// Contact Mechanics, 1985, eqs 3.45), in long double, found by scanning log u.
  long double largest_ratio_by_scan(const double nu, const double phi)
  {
    const long double sine  = std::sin(static_cast<long double>(phi));
    const long double alpha = 2 * sine / (std::sqrt(3.L) * (3 - sine));
    long double       best  = -1;
    for (int i = 0; i <= 20000; ++i)
      {
        const long double u = std::pow(10.L, -2 + i * 2e-4L);
        const long double sigma_r =
          -(1 + static_cast<long double>(nu)) * (1 - u * std::atan(1 / u)) + 0.5L / (1 + u * u);
        const long double sigma_z = -1 / (1 + u * u);
        best                      = std::max(
          best, std::abs(sigma_r - sigma_z) / std::sqrt(3.L) + alpha * (2 * sigma_r + sigma_z));
      }
    return best;
  }

  TEST(FirstYield, MaximumIsTheGlobalOneForEveryAllowedMaterial)
  {
    for (const double nu : {0., 0.1, 0.25, 0.4, 0.49, 0.4999})
      for (const double phi_deg : {0., 1e-9, 5., 30., 45., 60., 80., 89.})
        {
          const Material   m     = material(10e9, nu, phi_deg, 1e6);
          const FirstYield yield = first_yield(m, 0.1);
          const double     k =
            laws::drucker_prager_strength(m.friction_angle.radians(), m.compressive_strength);
          // The scan misses the maximum by its curvature over half a step, 2.3e-4 in ln u: a
          // relative 1e-7; its own cancellation at depth costs about 1e-10 (long double).
          const auto scanned =
            static_cast<double>(largest_ratio_by_scan(nu, m.friction_angle.radians()));
          EXPECT_NEAR(k / yield.pressure / scanned, 1, 2e-7) << nu << ' ' << phi_deg;
          EXPECT_GT(yield.depth_over_contact_radius, 0.38);
        }
  }

  TEST(FirstYield, LastAllowedMaterialsYieldDeepAndAtAFinitePressure)
  {
    // With w = 3(½−ν) + 2κ(1+ν) → 0, κ = √3 k/σc: (√J₂ + αI₁)/P₀ → (w/(3u²) − 3/(5u⁴))/√3, whose
    // maximum w²/(21.6 √3) lies at u² = 3.6/w, up to terms of relative order 1/u².
    for (const double phi : {std::nextafter(90., 0.), 89.999})
      {
        Material m             = material(10e9, std::nextafter(0.5, 0.), 0, 1e6);
        m.friction_angle       = Angle(phi);
        const FirstYield yield = first_yield(m, 0.1);
        const double     kappa =
          std::sqrt(3.) * laws::drucker_prager_strength(m.friction_angle.radians(), 1);
        const double w = 3 * (0.5 - m.poisson_ratio) + 2 * kappa * (1 + m.poisson_ratio);
        EXPECT_NEAR(yield.pressure / (1e6 * kappa * 21.6 / (w * w)), 1, 1e-8);
        EXPECT_NEAR(yield.depth_over_contact_radius / std::sqrt(3.6 / w), 1, 1e-6);
        EXPECT_TRUE(std::isfinite(yield.force));
      }
  }

  /// √J₂ + α I₁ over P₀ in a half space under the Hertz pressure, lengths in a (Huber 1904, as in
  /// Fischer-Cripps, Introduction to Contact Mechanics, 2007, sec. 5.4; frictionless).
  double ratio_in_half_space(const double r, const double z, const double nu, const double alpha)
  {
    const double s       = r * r + z * z - 1;
    const double u       = (s + std::sqrt(s * s + 4 * z * z)) / 2;
    const double root    = std::sqrt(u);
    const double A       = z / root;
    const double B       = u * A * A * A / (u * u + z * z);
    const double edge    = (1 - 2 * nu) / (3 * r * r) * (1 - A * A * A);
    const double twist   = (1 + nu) * root * std::atan(1 / root);
    const double press   = u * (1 - nu) / (1 + u);
    const double sigma_r = edge + B + A * (press + twist - 2);
    const double sigma_t = -edge - A * (2 * nu + press - twist);
    const double sigma_z = -B;
    const double tau     = r * z * z / (u * u + z * z) * root / (1 + u);
    const double I1      = sigma_r + sigma_t + sigma_z;
    const double J2 =
      (sigma_r * sigma_r + sigma_t * sigma_t + sigma_z * sigma_z - I1 * I1 / 3) / 2 + tau * tau;
    return std::sqrt(J2) + alpha * I1;
  }

  TEST(FirstYield, NowhereYieldsBeforeAxisAndRing)
  {
    for (const double nu : {0.05, 0.1, 0.2, 0.3, 0.38, 0.45})
      for (const double phi_deg : {0., 20., 30., 40., 60.})
        {
          const Material   m     = material(10e9, nu, phi_deg, 1e6);
          const FirstYield yield = first_yield(m, 0.1);
          const double     alpha = laws::drucker_prager_alpha(m.friction_angle.radians());
          const double     k =
            laws::drucker_prager_strength(m.friction_angle.radians(), m.compressive_strength);
          double largest = 0, on_axis = 0;
          for (int i = 0; i < 300; ++i)
            for (int j = 0; j < 300; ++j)
              {
                const double r     = 1e-3 + 0.01 * i; // to 3a
                const double z     = 1e-3 + 0.01 * j;
                const double ratio = ratio_in_half_space(r, z, nu, alpha);
                largest            = std::max(largest, ratio);
                if (i == 0)
                  on_axis = std::max(on_axis, ratio);
              }
          const double onset = std::max(k / yield.pressure, k / yield.ring_pressure);
          // At r = a/1000 the field differs from the axis by O(r²) = 1e-6, both ways.
          EXPECT_LE(largest, onset * (1 + 2e-6)) << nu << ' ' << phi_deg;
          // The check of the field itself: steps of 0.01 miss the axis maximum by about 1e-4.
          EXPECT_NEAR(on_axis / (k / yield.pressure), 1, 1e-3) << nu << ' ' << phi_deg;
        }
  }

  TEST(FirstYield, RefusesBadInput)
  {
    EXPECT_THROW(first_yield(material(10e9, 0.5, 25, 15e6), 0.1), InputError);
    EXPECT_THROW(first_yield(material(10e9, 0.15, 25, 15e6), 0), InputError);
    EXPECT_THROW(
      first_yield(material(10e9, 0.15, 25, 15e6), std::numeric_limits<double>::quiet_NaN()),
      InputError);
  }
} // namespace
