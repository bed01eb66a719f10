#include "solver/closed_form/yield_surface.h"
#include "solver/laws/law.h"
#include "solver/laws/strengths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
  using namespace dpcontact;

  constexpr double phi = 30 * M_PI / 180, sigma_c = 10e6;

  Material material(const Criterion criterion)
  {
    Material result{1e9, 0.25, Angle(criterion == Criterion::von_mises ? 0 : 30), sigma_c};
    result.criterion = criterion;
    return result;
  }

  TEST(YieldSurface, circular_cone)
  {
    const auto law = law_of(material(Criterion::drucker_prager));
    for (const double pressure : {-4e6, 0., 3e6, 50e6})
      for (const double angle : {0., 0.4, 2.2, 5.})
        {
          const auto point = surface_point(law, pressure, angle, sigma_c);
          ASSERT_TRUE(point.has_value());
          const double expected = laws::drucker_prager_strength(phi, sigma_c) +
                                  3 * laws::drucker_prager_alpha(phi) * pressure;
          EXPECT_NEAR(point->sqrt_j2, expected, 1e-9 * sigma_c);
          EXPECT_NEAR(
            std::hypot(point->pi_x(), point->pi_y()), std::sqrt(2.) * expected, 1e-8 * sigma_c);
        }
    // Apex p/σc = 0.5 for φ = 30°.
    EXPECT_NEAR(tensile_pressure(law, sigma_c).value(), -0.5 * sigma_c, 1e-9 * sigma_c);
    EXPECT_FALSE(surface_point(law, -0.51 * sigma_c, 0, sigma_c).has_value());
  }

  TEST(YieldSurface, pyramid_in_triaxial_stress)
  {
    // Tension positive: σ₁ (1 + sinφ) − σ₃ (1 − sinφ) = 2 C cosφ, and N_φ = 3.
    const auto   law = law_of(material(Criterion::mohr_coulomb));
    const double C   = laws::mohr_coulomb_cohesion(phi, sigma_c);
    for (const double angle : {0., M_PI / 3})
      {
        const auto point = surface_point(law, 8e6, angle, sigma_c);
        ASSERT_TRUE(point.has_value());
        const double most  = *std::max_element(point->principal.begin(), point->principal.end());
        const double least = *std::min_element(point->principal.begin(), point->principal.end());
        EXPECT_NEAR(most * (1 + std::sin(phi)) - least * (1 - std::sin(phi)),
                    2 * C * std::cos(phi),
                    1e-8 * sigma_c);
        EXPECT_NEAR(-least, sigma_c - 3 * most, 1e-7 * sigma_c);
      }
  }

  TEST(YieldSurface, cut_off_is_the_largest_principal_stress)
  {
    Material cut       = material(Criterion::mohr_coulomb);
    cut.tension_cutoff = 1e6;
    const auto law     = law_of(cut);
    EXPECT_NEAR(tensile_pressure(law, sigma_c).value(), -1e6, 1e-3);
    const auto point = surface_point(law, 0, 0, sigma_c);
    ASSERT_TRUE(point.has_value());
    EXPECT_NEAR(point->principal[0], 1e6, 1e-3);
  }

  TEST(YieldSurface, cylinder_never_closes)
  {
    const auto law = law_of(material(Criterion::von_mises));
    EXPECT_FALSE(tensile_pressure(law, sigma_c).has_value());
    EXPECT_NEAR(
      surface_point(law, -1e9, 1, sigma_c)->sqrt_j2, sigma_c / std::sqrt(3.), 1e-6 * sigma_c);
  }
} // namespace
