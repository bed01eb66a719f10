#include "database/contact_law/collision.h"
#include "meshing/errors.h"
#include "tests/support/floating_point_traps.h"
#include "tests/support/small_table.h"

#include <cmath>

namespace
{
  using namespace dpcontact;

  const auto *const traps = tests::FloatingPointTraps::install();

  TEST(Collision, of_a_row_gives_back_what_its_closed_form_says)
  {
    // ½mv² = ∫L = F_y δ_y a x^(b+1)/(b+1) at the peak x, and ½mv'² = F_p w/(n+1): exact. What the
    // integration leaves is its end, where the force vanishes like a power: 1e-6.
    const double     a = 1.1, b = 1.435, m = 2.41, n = 1.3686, F_y = 0.3354, delta_y = 3.6436e-7;
    const ContactLaw law = ContactLaw::from_row({a, b, m, n, F_y, delta_y, 0.05});
    for (const double speed : {0.01, 0.3, 2.})
      {
        const CollidingSpheres spheres{0.1, 0.1, 2600, speed};
        const Collision        hit    = collide(law, spheres);
        const double           energy = spheres.effective_mass() * speed * speed / 2;
        const double           x   = std::pow(energy * (b + 1) / (F_y * delta_y * a), 1 / (b + 1));
        const double           F_p = F_y * a * std::pow(x, b);
        const double           w   = delta_y * std::pow(F_p / (m * F_y), 1 / n);
        EXPECT_NEAR(hit.peak_overlap / (x * delta_y), 1, 1e-6);
        EXPECT_NEAR(hit.peak_force / F_p, 1, 1e-6);
        EXPECT_NEAR(hit.restitution, std::sqrt(F_p * w / (n + 1) / energy), 1e-6);
        EXPECT_NEAR(hit.rebound_velocity, hit.restitution * speed, 1e-15);
        EXPECT_NEAR(hit.residual_overlap, x * delta_y - w, 1e-6 * x * delta_y);
      }
  }

  TEST(Collision, elastic_is_hertz)
  {
    // Johnson, Contact Mechanics, eq (11.24): the collision lasts 2.9432 δ_max/v. Nothing is lost.
    const ContactLaw       law = ContactLaw::universal({10e9, 0.2, 30, 1e9}, tests::small_table());
    const CollidingSpheres spheres{0.1, 0.03, 2600, 0.05};
    const Collision        hit  = collide(law, spheres);
    const double           r    = ContactLaw::effective_radius(0.1, 0.03);
    const double           k    = 4. / 3. * 10e9 / (2 * (1 - 0.04)) * std::sqrt(r);
    const double           peak = std::pow(1.25 * spheres.effective_mass() * 0.05 * 0.05 / k, 0.4);
    EXPECT_NEAR(hit.peak_overlap / peak, 1, 1e-6);
    EXPECT_NEAR(hit.restitution, 1, 1e-8);
    EXPECT_NEAR(hit.duration * 0.05 / peak, 2.9432, 3e-4);
    EXPECT_EQ(hit.residual_overlap, 0);
    EXPECT_FALSE(hit.flags & contact_yielded);
  }

  TEST(Collision, gives_back_less_the_faster_it_is)
  {
    const ContactLaw law  = ContactLaw::universal({10e9, 0.2, 25, 10e6}, tests::small_table());
    double           last = 1;
    for (double speed = 1e-4; speed < 1; speed *= 2)
      {
        const Collision hit = collide(law, {0.05, 0.05, 2600, speed});
        EXPECT_LE(hit.restitution, last + 1e-8) << speed; // rounding where nothing yields
        last = hit.restitution;
      }
    EXPECT_LT(last, 0.9);
    // Steps: of fourth order but at the peak, where the stiffness jumps.
    const double fine = collide(law, {0.05, 0.05, 2600, 0.5}, 40000).rebound_velocity;
    EXPECT_NEAR(collide(law, {0.05, 0.05, 2600, 0.5}, 5000).rebound_velocity / fine, 1, 1e-6);
  }

  TEST(Collision, refuses_what_is_no_collision)
  {
    const ContactLaw law = ContactLaw::from_row({1, 1.5, 1, 1.5, 1, 1e-6, 0.05});
    EXPECT_THROW(collide(law, {0, 0.1, 2600, 1}), InputError);
    EXPECT_THROW(collide(law, {0.1, -0.1, 2600, 1}), InputError);
    EXPECT_THROW(collide(law, {0.1, 0.1, std::nan(""), 1}), InputError);
    EXPECT_THROW(collide(law, {0.1, 0.1, 2600, -1}), InputError);
    EXPECT_THROW(collide(law, {0.1, 0.1, 2600, 1}, 10), InputError);
  }
} // namespace
