// How a contact law is built: first yield, rows, the universal table, radii, and what is refused.
#include "solver/closed_form/first_yield.h"
#include "solver/closed_form/hertz.h"
#include "tests/support/floating_point_traps.h"
#include "tests/support/small_table.h"

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <sstream>

namespace
{
  using namespace dpcontact;
  using tests::half_radius;
  using tests::rock_of;
  using tests::small_table;
  using tests::sphere_radius;

  const auto *const traps = tests::FloatingPointTraps::install();

  Material material_of(const ContactMaterial &rock)
  {
    return {rock.youngs_modulus,
            rock.poisson_ratio,
            Angle(rock.friction_angle_deg),
            rock.compressive_strength};
  }

  /// Force at the end of a history of overlaps.
  double force_after(const ContactLaw          &law,
                     const double               effective_radius,
                     const std::vector<double> &overlaps)
  {
    ContactState state;
    double       force = 0;
    for (const double overlap : overlaps)
      force = law.evaluate(overlap, effective_radius, state).force;
    return force;
  }

  TEST(ContactLaw, first_yield_is_the_solvers)
  {
    for (const double nu : {0., 0.1, 0.25, 0.4, 0.45, 0.499})
      for (const double phi : {0., 20., 35., 50., 80.})
        {
          const ContactMaterial rock{7e9, nu, phi, 13e6};
          const YieldScales     scales = yield_scales(rock);
          const FirstYield      solver = first_yield(material_of(rock), sphere_radius);
          EXPECT_NEAR(scales.pressure / solver.pressure, 1, 1e-12) << nu << ", " << phi;
          EXPECT_NEAR(scales.force * half_radius * half_radius / solver.force, 1, 1e-12);
          EXPECT_NEAR(scales.approach * half_radius / solver.approach, 1, 1e-12);
          EXPECT_NEAR(scales.onset_level * solver.force / solver.onset_force(), 1, 1e-12);
        }
    // Table 3 of the paper, all digits that it prints; δ_y there is that of one sphere.
    const YieldScales type_1 = yield_scales({10e9, 0.15, 25, 15e6});
    EXPECT_NEAR(type_1.force * half_radius * half_radius, 9.056, 5e-4);
    EXPECT_NEAR(type_1.approach * half_radius / 2, 1.64e-6, 5e-9);
    const YieldScales type_2 = yield_scales({10e9, 0.25, 35, 25e6});
    EXPECT_NEAR(type_2.force * half_radius * half_radius, 84.450, 5e-4);
    EXPECT_NEAR(type_2.approach * half_radius / 2, 7.06e-6, 5e-9);
  }

  TEST(ContactLaw, powers_of_a_row_are_the_librarys)
  {
    // Against long double. 2⁻⁵⁰ is the header's bound: three roundings and the tables'. Outside the
    // tables x^y comes from its logarithm, whose rounding the exponent multiplies.
    std::mt19937_64                        random(11);
    std::uniform_real_distribution<double> uniform;
    for (const double y : {0.2, 0.7, 0.95, 1., 1.2408, 1.4643, 1.5, 2.6, 3., 7.5})
      {
        const contact_law_detail::FixedPower power(y);
        const auto                           expect_close = [&](const double x) {
          const bool        in_table = y <= 3 && x >= 0x1p-64 && x < 0x1p64;
          const double      log2     = std::abs(y * std::log2(x));
          const long double exact =
            std::pow(static_cast<long double>(x), static_cast<long double>(y));
          EXPECT_LE(std::abs(static_cast<double>((power(x) - exact) / exact)),
                    in_table ? 0x1p-50 : 0x1p-52 * (2 + log2))
            << x << "^" << y;
        };
        for (int k = 0; k < 100000; ++k)
          expect_close(std::exp2(160 * uniform(random) - 80));
        for (double x = 0.5; x < 4; x += 1. / 64) // the table's nodes, and where it changes node
          for (const double at : {std::nextafter(x, 0.), x, std::nextafter(x, 5.)})
            expect_close(at);
        EXPECT_EQ(power(1), 1);
      }
  }

  TEST(ContactLaw, row_is_eqs_16_to_18)
  {
    const double     a = 1.34, b = 1.3692, m = 8.3479, n = 1.2408, F_y = 0.0283, delta_y = 2e-7;
    const ContactLaw law   = ContactLaw::from_row({a, b, m, n, F_y, delta_y, half_radius});
    const double     peak  = 40 * delta_y;
    const double     F_p   = F_y * a * std::pow(40, b);
    const double     width = delta_y * std::pow(F_p / (m * F_y), 1 / n);
    EXPECT_NEAR(force_after(law, half_radius, {peak}), F_p, 1e-13 * F_p);
    for (const double share : {0.1, 0.5, 0.9})
      EXPECT_NEAR(force_after(law, half_radius, {peak, peak - (1 - share) * width}),
                  F_y * m * std::pow(share * width / delta_y, n),
                  1e-11 * F_p);
    const ContactCoefficients at = law.coefficients(peak, half_radius);
    EXPECT_NEAR(at.m, m, 1e-12 * m);
    EXPECT_EQ(at.n, n);
    EXPECT_NEAR(at.residual, peak - width, 1e-12 * peak);
    EXPECT_NEAR(law.force_yield(half_radius), F_y, 1e-15);
  }

  TEST(ContactLaw, published_convention_is_the_same_law)
  {
    const double a = 1.0148, b = 1.4729, m = 1.1829, n = 1.4643, F_y = 9.056, delta_y = 3.2792e-6;
    const ContactLaw consistent = ContactLaw::from_row({a, b, m, n, F_y, delta_y, half_radius});
    const ContactLaw published  = ContactLaw::from_row(ContactRow::published(
      a * std::pow(2, -b), b, m * std::pow(2, -n), n, F_y, delta_y / 2, half_radius));
    for (const double peak : {0.5, 2., 5., 70.})
      for (const double back : {1., 0.95, 0.7})
        {
          const double force =
            force_after(consistent, half_radius, {peak * delta_y, back * peak * delta_y});
          EXPECT_NEAR(force_after(published, half_radius, {peak * delta_y, back * peak * delta_y}),
                      force,
                      1e-13 * force);
        }
    // As eq (16) is printed: δ mutual over δ_y of one sphere.
    EXPECT_NEAR(force_after(published, half_radius, {5 * delta_y}),
                F_y * a * std::pow(2, -b) * std::pow(5 * delta_y / (delta_y / 2), b),
                1e-12);
  }

  TEST(ContactLaw, elastic_limit_is_hertz)
  {
    const ContactMaterial strong{10e9, 0.2, 30, 1e9};
    const ContactLaw      law = ContactLaw::universal(strong, small_table());
    for (const double overlap : {1e-9, 1e-6, 1e-4})
      {
        const double hertz = hertz::force(material_of(strong), sphere_radius, overlap);
        EXPECT_NEAR(force_after(law, half_radius, {overlap}), hertz, 1e-13 * hertz);
        EXPECT_NEAR(force_after(law, half_radius, {2 * overlap, overlap}), hertz, 1e-13 * hertz);
      }
  }

  TEST(ContactLaw, only_reduced_quantities_matter)
  {
    // Equal ν and φ: F/F_y over δ/δ_y is one curve for every E, σc and radius. 1e-12: rounding.
    const ContactLaw one   = ContactLaw::universal({10e9, 0.23, 33, 5e6}, small_table());
    const ContactLaw other = ContactLaw::universal({70e9, 0.23, 33, 40e6}, small_table());
    for (const double x : {0.5, 3., 40., 300.})
      for (const double back : {1., 0.9, 0.6})
        {
          const double r = 3e-4;
          const double d = one.approach_yield(half_radius), e = other.approach_yield(r);
          EXPECT_NEAR(force_after(one, half_radius, {x * d, back * x * d}) /
                        one.force_yield(half_radius),
                      force_after(other, r, {x * e, back * x * e}) / other.force_yield(r),
                      1e-11 * std::pow(x, 1.5));
        }
  }

  TEST(ContactLaw, unequal_radii_mix_by_the_effective_radius)
  {
    EXPECT_DOUBLE_EQ(ContactLaw::effective_radius(0.1, 0.1), 0.05);
    EXPECT_DOUBLE_EQ(ContactLaw::effective_radius(0.3, 0.1), 0.075);
    EXPECT_NEAR(ContactLaw::effective_radius(1e9, 0.1), 0.1, 1e-10);
    const ContactLaw row =
      ContactLaw::from_row({1.34, 1.3692, 8.3479, 1.2408, 0.0283, 2e-7, half_radius});
    EXPECT_NEAR(row.force_yield(3 * half_radius), 9 * 0.0283, 1e-14);
    EXPECT_NEAR(row.approach_yield(3 * half_radius), 3 * 2e-7, 1e-20);
    for (const auto &[name, law] : tests::laws())
      {
        const double r = ContactLaw::effective_radius(0.02, 0.07), ratio = r / half_radius;
        for (const double back : {1., 0.93, 0.8})
          {
            const double force = force_after(law, half_radius, {3e-5, back * 3e-5});
            EXPECT_NEAR(force_after(law, r, {3e-5 * ratio, back * 3e-5 * ratio}),
                        ratio * ratio * force,
                        1e-10 * force)
              << name;
            ContactState state;
            law.pair(r).evaluate(3e-5 * ratio, state);
            EXPECT_NEAR(law.pair(r).evaluate(back * 3e-5 * ratio, state).force,
                        ratio * ratio * force,
                        1e-10 * force)
              << name;
          }
      }
  }

  TEST(ContactLaw, universal_law_passes_through_its_table)
  {
    const ContactTable &table = small_table();
    for (std::size_t i = 0; i < table.nu.size(); ++i)
      for (std::size_t k = 0; k < table.phi.size(); ++k)
        {
          const ContactMaterial rock  = rock_of(table.nu[i], table.phi[k]);
          const ContactLaw      law   = ContactLaw::universal(rock, table);
          const double          onset = yield_scales(rock).onset_level;
          for (std::size_t l = 0; l < table.load_level.size(); ++l)
            {
              const std::size_t at    = table.index(i, k, l);
              const double      level = table.load_level[l];
              const double      delta = table.approach[at] * law.approach_yield(half_radius);
              const double      force =
                force_after(law, half_radius, {delta}) / law.force_yield(half_radius);
              // The bins' cubics keep 1e-7. Next to the onset the table is elastic to 1e-4.
              EXPECT_NEAR(force / level, 1, level < 2 * onset ? 2e-4 : 1e-6) << "Lambda " << level;
              if (level < 2 * onset)
                continue;
              const ContactCoefficients c = law.coefficients(delta, half_radius);
              EXPECT_NEAR(c.n / table.n[at], 1, 1e-3) << "Lambda " << level;
              EXPECT_NEAR(c.m / table.m[at], 1, 3e-3) << "Lambda " << level;
              // Eq (18)'s residual against the finite elements', over the peak.
              EXPECT_NEAR(c.residual / delta, table.residual[at] / table.approach[at], 4e-3)
                << "Lambda " << level;
            }
        }
  }

  TEST(ContactLaw, interpolates_between_materials)
  {
    // `dpcontact solve --E 10GPa --nu 0.15 --phi 25 --sigma-c 15MPa | 5MPa`, and 0.25, 35, 5MPa, at 100 N:
    // materials that the table has not, and forces (N) of their unloading curves where a quarter, a
    // half and three quarters of the recovered approach are left. A power law and what three nodes
    // an axis leave are below 0.3 %.
    struct Case
    {
      ContactMaterial       rock;
      double                approach_peak, residual; // m
      std::array<double, 3> force;
    };
    for (const Case &c :
         {Case{{10e9, 0.15, 25, 15e6}, 1.659865e-05, 1.501958e-06, {13.0498, 36.3478, 65.8387}},
          Case{{10e9, 0.15, 25, 5e6}, 1.808459e-05, 5.750302e-06, {14.967, 38.7933, 67.5932}},
          Case{{10e9, 0.25, 35, 5e6}, 1.62901e-05, 2.040301e-06, {13.2849, 36.5578, 65.9467}}})
      {
        const ContactLaw law = ContactLaw::universal(c.rock, small_table());
        EXPECT_NEAR(force_after(law, half_radius, {c.approach_peak}) / 100, 1, 3e-3);
        for (std::size_t i = 0; i < 3; ++i)
          {
            const double x =
              c.residual + 0.25 * static_cast<double>(i + 1) * (c.approach_peak - c.residual);
            EXPECT_NEAR(
              force_after(law, half_radius, {c.approach_peak, x}) / 100, c.force[i] / 100, 3e-3);
          }
        const ContactCoefficients at = law.coefficients(c.approach_peak, half_radius);
        EXPECT_NEAR((at.residual - c.residual) / c.approach_peak, 0, 2e-3);
      }
  }

  TEST(ContactLaw, says_where_small_strain_is_left)
  {
    for (const auto &[name, law] : tests::laws())
      {
        // a/R from the stiffness, Hertz's below yield: a² = R*δ and R = 2R*.
        const double small = 0.1 * law.approach_yield(half_radius);
        if (name.find("nu") == 0)
          {
            EXPECT_NEAR(law.strain_measure(small, half_radius),
                        std::sqrt(half_radius * small) / sphere_radius,
                        1e-12);
          }
        double low = 1e-9, high = 1;
        for (int k = 0; k < 100; ++k)
          (law.strain_measure((low + high) / 2, half_radius) > 0.1 ? high : low) = (low + high) / 2;
        ContactState state;
        EXPECT_FALSE(law.evaluate(low * 0.999, half_radius, state).flags & contact_strain_large)
          << name;
        EXPECT_TRUE(law.evaluate(high * 1.001, half_radius, state).flags & contact_strain_large)
          << name;
        EXPECT_TRUE(law.evaluate(low * 0.5, half_radius, state).flags & contact_strain_large)
          << name << ": the peak stays";
      }
  }

  TEST(ContactLaw, goes_on_beyond_the_table_and_says_so)
  {
    const ContactLaw    law   = ContactLaw::universal(rock_of(0.2, 30), small_table());
    const ContactTable &table = small_table();
    const double        end   = table.approach[table.index(1, 1, table.load_level.size() - 1)] *
                       law.approach_yield(half_radius);
    ContactState state;
    EXPECT_FALSE(law.evaluate(0.9999 * end, half_radius, state).flags & contact_extrapolated);
    double last = 0;
    for (double overlap = 1.0001 * end; overlap < 100 * end; overlap *= 1.01)
      {
        const ContactResponse response = law.evaluate(overlap, half_radius, state);
        EXPECT_TRUE(response.flags & contact_extrapolated);
        EXPECT_GT(response.force, last);
        last = response.force;
        // Steeper than a straight line, softer than Hertz.
        const double later = force_after(law, half_radius, {1.01 * overlap}) / response.force;
        EXPECT_GT(later, 1.01);
        EXPECT_LT(later, std::pow(1.01, 1.5));
      }
  }

  void expect_refused(const std::function<void()> &act, const std::string &part)
  {
    try
      {
        act();
        ADD_FAILURE() << "not refused: " << part;
      }
    catch (const std::runtime_error &error)
      {
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
      }
  }

  TEST(ContactLaw, refuses_what_is_out_of_range)
  {
    const auto universal = [](const ContactMaterial &rock) {
      return [rock] { ContactLaw::universal(rock, small_table()); };
    };
    expect_refused(universal({0, 0.2, 30, 1e6}), "Young's modulus is 0");
    expect_refused(universal({1e9, 0.2, 30, -1}), "compressive strength is -1");
    expect_refused(universal({1e9, 0.5, 30, 1e6}), "Poisson's ratio is 0.5");
    expect_refused(universal({1e9, 0.2, 90, 1e6}), "friction angle is 90");
    expect_refused(
      universal({1e9, 0.05, 30, 1e6}),
      "Poisson's ratio is 0.05; it must be within the universal table, from 0.1 to 0.3");
    expect_refused(universal({1e9, 0.2, 45, 1e6}),
                   "friction angle is 45; it must be within the universal table, from 20 to 40");
    const ContactRow good{1, 1.5, 1, 1.5, 1, 1e-6, 0.05};
    for (double ContactRow::*const value : {&ContactRow::a,
                                            &ContactRow::b,
                                            &ContactRow::m,
                                            &ContactRow::n,
                                            &ContactRow::force_yield,
                                            &ContactRow::approach_yield,
                                            &ContactRow::effective_radius})
      for (const double wrong : {0.,
                                 -1.,
                                 std::numeric_limits<double>::quiet_NaN(),
                                 std::numeric_limits<double>::infinity()})
        {
          ContactRow row = good;
          row.*value     = wrong;
          expect_refused([&] { ContactLaw::from_row(row); }, "finite and positive");
        }
    expect_refused([&] { ContactLaw::from_row(good).pair(0); }, "R*");
  }

  TEST(ContactLaw, reads_tables_and_says_what_is_wrong_with_them)
  {
    std::ostringstream text;
    text << "# comment\nphi_deg,nu,extra,load_level,m_law,approach,n_law,residual_approach\r\n";
    for (const double nu : {0.1, 0.2})
      for (const double level : {16., 0.01, 4., 2., 8.}) // in any order
        {
          const double hertz    = std::pow(level, 2. / 3),
                       approach = std::max(std::pow(level, 0.7), hertz);
          text << "30," << nu << ",hello," << level << ",1," << approach << ",1.5,"
               << approach - hertz << "\n";
        }
    const auto read = [](const std::string &csv) {
      std::istringstream stream(csv);
      return ContactTable::read(stream);
    };
    const std::string  good  = text.str();
    const ContactTable table = read(good);
    EXPECT_EQ(table.nu, (std::vector<double>{0.1, 0.2}));
    EXPECT_EQ(table.phi, std::vector<double>{30});
    EXPECT_EQ(table.load_level, (std::vector<double>{0.01, 2, 4, 8, 16}));
    EXPECT_NEAR(table.approach[table.index(1, 0, 3)], std::pow(8, 0.7), 1e-5); // six digits of text
    EXPECT_NO_THROW(ContactLaw::universal({1e9, 0.15, 30, 1e6}, table));

    const auto with = [&](const std::string &what, const std::string &instead) {
      std::string copy = good;
      return copy.replace(copy.find(what), what.size(), instead);
    };
    const auto refused = [&](const std::string &csv, const std::string &part) {
      expect_refused([&] { read(csv); }, part);
    };
    refused("", "fewer than 5");
    refused(with("load_level", "level"), "line 2: the header lacks the column 'load_level'");
    refused(with(",16,1,", ",16,many,"), "line 3: 'many' is no value of m_law");
    refused(with(",16,1,", ",16,nan,"), "line 3: 'nan' is no value of m_law");
    refused(with(",16,1,", ",16,1.5x,"), "line 3: '1.5x' is no value of m_law");
    refused(with(",16,1,", ",16,-1,"), "line 3: approach, m_law and n_law must be positive");
    refused(with(",1.5,0.6", ",1.5,9.6"), "line 3: approach, m_law and n_law");
    refused(with(",1.5,0.6", ",1.5,,0.6"), "line 3: '' is no value of residual_approach");
    refused(with("30,0.1", "95,0.1"), "line 3: nu, phi_deg or load_level is out of range");
    refused(good + good.substr(good.rfind("30,0.2")),
            "line 13: this nu, phi_deg and load_level stand there twice");
    refused(with("30,0.1,hello,16", "30,0.1,hello,16.1"),
            "there is no row for nu 0.1, phi_deg 30, load_level 16");
    refused(good.substr(0, good.rfind("30,0.2")), "there is no row for nu 0.2");
    refused(with(",2,1,1.6245,1.5,0.0371", ",2,1,5,1.5,3.41"),
            "the approach does not increase at nu 0.1");
    refused(with(",2,1,1.6245,1.5,0.0371", ",2,1,2.6,1.5,1.0126"),
            "the residual approach falls at nu 0.1");
    refused(with(",1.5,0.6", ",15,0.6"), "line 3: n_law must be from 0.9 to 1.7");
    refused(with(",1.5,0.6", ",1e308,0.6"), "line 3: n_law must be from 0.9 to 1.7");
    refused(with(",16,1,", ",16,10,"), "line 3: m_law and n_law do not lead");
    refused(with(",6.9644,", ",5,"), "line 3: approach is below Hertz's");
    refused(with(",0.01,1,", ",0.01,1.01,"), "nothing yields, but approach, m_law or n_law");
    refused("#   n_law, deg, exponent\n" + good, "line 1: n_law has another unit than 1");
    refused("#   phi_deg, rad, angle\n" + good, "line 1: phi_deg has another unit than deg");
  }
} // namespace
