// The universal table's lookup on tables of known functions.

#include "database/contact_law/contact_law.h"
#include "database/files/digest.h"
#include "database/tables/universal_lookup.h"
#include "meshing/errors.h"
#include "meshing/number_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <unistd.h>

namespace dpcontact
{
  namespace
  {
    // The axes of runs/universal.prm.
    const std::vector<double> nus{0, 0.03014, 0.1125, 0.225, 0.3375, 0.4199, 0.45};
    const std::vector<double>
      phis{0, 2.48, 5.9, 9.41, 14.4, 19.44, 25, 30.56, 35.5, 40.59, 44, 47.52, 50};

    std::vector<double> load_levels()
    {
      std::vector<double> levels;
      for (int k = -5; k <= 16; ++k)
        levels.push_back(std::pow(10, k / 4.));
      return levels;
    }

    /// Shaped like what the finite elements give: n has a trough along φ that moves with ν and Λ.
    UniversalNode truth(const double nu, const double phi, const double level)
    {
      const double  plastic = std::log1p(level), off = (phi - 8 - 1.5 * plastic + 20 * nu) / 8;
      UniversalNode node;
      node.nu         = nu;
      node.phi_deg    = phi;
      node.load_level = level;
      node.approach   = std::pow(level, 2. / 3) * std::exp(0.03 * plastic * (1 + nu - phi / 100));
      const double recovered = node.approach / (1 + 0.1 * plastic * (1.2 - phi / 50));
      node.residual_approach = node.approach - recovered;
      node.b                 = 1.5 - 0.02 * plastic * (1 - phi / 60) * (1 + nu * nu);
      node.n                 = 1.5 - plastic * (0.01 - phi / 8000 + 0.01 * std::exp(-off * off));
      node.a =
        level * std::exp(0.002 * plastic * std::cos(phi / 20)) / std::pow(node.approach, node.b);
      node.m = level * std::exp(0.004 * plastic * std::cos(3 * nu)) / std::pow(recovered, node.n);
      node.m_law = node.m;
      node.n_law = node.n;
      for (const UniversalColumn &column : universal_columns())
        if (std::isnan(node.*column.member))
          node.*column.member = 0;
      return node;
    }

    std::array<double, 4> coefficients(const UniversalNode &node)
    {
      return {node.a, node.b, node.m, node.n};
    }

    /// The table of truth(), its n moved at every node by a normal deviate of this size. Rows of
    /// finite elements state some four times what they scatter by.
    UniversalTable table_of(const double scatter)
    {
      std::mt19937               random(20181127);
      std::normal_distribution<> normal;
      std::string                text = "# dpcontact: universal table of elastic-plastic contact\n";
      for (const UniversalColumn &column : universal_columns())
        text += std::string("#   ") + column.name + ", " + column.unit + ", made up\n";
      std::string separator;
      for (const UniversalColumn &column : universal_columns())
        {
          text += separator + column.name;
          separator = ",";
        }
      for (const double nu : nus)
        for (const double phi : phis)
          for (const double level : load_levels())
            {
              UniversalNode node  = truth(nu, phi, level);
              const double  moved = scatter * normal(random);
              const double  ln_w  = std::log(node.approach - node.residual_approach);
              node.n += moved;
              node.m *= std::exp(-moved * ln_w); // the force at the peak stays
              node.n_error = 4 * scatter;
              node.m_error = node.n_error * node.m * std::abs(ln_w);
              separator    = "\n";
              for (const UniversalColumn &column : universal_columns())
                {
                  text += separator + number_text(node.*column.member);
                  separator = ",";
                }
            }
      const std::filesystem::path file =
        std::filesystem::temp_directory_path() /
        ("dpcontact_universal_lookup_" + std::to_string(::getpid()) + ".csv");
      write_with_digest(file, text + "\n");
      UniversalTable table = UniversalTable::read(file);
      std::filesystem::remove(file);
      std::filesystem::remove(file.string() + ".sha256");
      return table;
    }

    /// How the stated uncertainty of a, b, m, n compares with the error, over 300 random points.
    struct Score
    {
      std::array<double, 4> covered{}, median_ratio{}, median_error{}, median_stated{};
    };

    Score score(const UniversalTable &table)
    {
      std::mt19937                       random(1);
      std::uniform_real_distribution<>   uniform(0, 1);
      std::array<std::vector<double>, 4> ratios, errors, stateds;
      Score                              result;
      constexpr unsigned int             count = 300;
      for (unsigned int i = 0; i < count; ++i)
        {
          const double         nu = 0.45 * uniform(random), phi = 50 * uniform(random);
          const double         level  = 3 * std::pow(3000, uniform(random));
          const UniversalValue value  = UniversalFamily(table, nu, phi).at(level);
          const auto           expect = coefficients(truth(nu, phi, level));
          for (std::size_t c = 0; c < 4; ++c)
            {
              const double error  = std::abs(value.coefficients[c] - expect[c]);
              const double stated = value.interpolation[c] + value.numerical[c];
              errors[c].push_back(error / expect[c]);
              ratios[c].push_back(stated / error);
              stateds[c].push_back(stated);
              result.covered[c] += (error <= stated) / double(count);
            }
        }
      const auto median = [](std::vector<double> list) {
        std::nth_element(list.begin(), list.begin() + count / 2, list.end());
        return list[count / 2];
      };
      for (std::size_t c = 0; c < 4; ++c)
        {
          result.median_ratio[c]  = median(ratios[c]);
          result.median_error[c]  = median(errors[c]);
          result.median_stated[c] = median(stateds[c]);
        }
      return result;
    }
  } // namespace

  TEST(UniversalLookup, gives_every_node_back)
  {
    const UniversalTable table = table_of(1e-3);
    for (std::size_t i = 0; i < table.all().size(); i += 7)
      {
        const UniversalNode  &node = table.all()[i];
        const UniversalFamily family(table, node.nu, node.phi_deg);
        if (node.load_level <= family.onset())
          continue; // Hertz in closed form
        const UniversalValue value  = family.at(node.load_level);
        const auto           expect = coefficients(node);
        for (std::size_t c = 0; c < 4; ++c)
          EXPECT_NEAR(value.coefficients[c] / expect[c], 1, 1e-11);
        EXPECT_NEAR(value.approach / node.approach, 1, 1e-11);
        EXPECT_NEAR(value.residual_approach, node.residual_approach, 1e-11 * node.approach);
      }
  }

  TEST(UniversalLookup, interpolates_over_nu_and_phi_as_the_contact_law_does)
  {
    using contact_law_detail::weights;
    const auto apply = [](const std::vector<double> &axis, const double at, const auto &f) {
      const std::vector<double> w   = weights(axis, at);
      double                    sum = 0;
      for (std::size_t i = 0; i < axis.size(); ++i)
        sum += w[i] * f(axis[i]);
      return sum;
    };
    // A spline whose end slopes are exact for quartics reproduces cubics, the polynomial of ν all
    // that seven nodes determine.
    const auto cubic = [](const double x) { return 1 + x * (0.3 - x * (0.02 - x * 0.0004)); };
    const auto sixth = [](const double x) { return std::pow(x, 6) - 3 * std::pow(x, 5) + x; };
    for (double t = 0; t <= 1; t += 1. / 64)
      {
        EXPECT_NEAR(apply(phis, 50 * t, cubic), cubic(50 * t), 1e-12 * 50);
        EXPECT_NEAR(apply(nus, 0.45 * t, sixth), sixth(0.45 * t), 1e-14);
      }
    // C² over the nodes of φ, where f is no polynomial.
    const auto   wave = [](const double x) { return std::sin(x / 5); };
    const double h    = 1e-3;
    for (std::size_t i = 1; i + 1 < phis.size(); ++i)
      {
        const auto value = [&](const double x) { return apply(phis, phis[i] + x * h, wave); };
        EXPECT_NEAR(value(0), wave(phis[i]), 1e-14);
        const double before = value(0) - 2 * value(-1) + value(-2),
                     behind = value(2) - 2 * value(1) + value(0);
        EXPECT_NEAR(before / (h * h), behind / (h * h), 1e-3) << phis[i];
      }
  }

  TEST(UniversalLookup, states_the_error_that_interpolation_makes)
  {
    const Score smooth = score(table_of(0));
    for (std::size_t c = 0; c < 4; ++c)
      {
        EXPECT_LT(smooth.median_error[c], 3e-3) << c;
        EXPECT_GE(smooth.covered[c], 0.9) << c;
      }
  }

  TEST(UniversalLookup, states_how_the_nodes_scatter)
  {
    const Score scattered = score(table_of(1e-3));
    const Score little    = score(table_of(1e-4));
    // m is as wrong as n, times ln of the approach. Normal deviates, all alike, are covered as by
    // 1.3 standard deviations at least, and at most by three, which are 4.45 times the median. Of
    // the little scatter most of what is stated is the floor.
    for (const std::size_t c : {2u, 3u})
      {
        EXPECT_GE(scattered.covered[c], 0.8) << c;
        EXPECT_LT(scattered.median_ratio[c], 4.45) << c;
        EXPECT_GT(scattered.median_stated[c], 2 * little.median_stated[c]) << c;
      }
  }

  TEST(UniversalLookup, gives_the_contact_laws_branches)
  {
    const std::filesystem::path      file  = DPCONTACT_UNIVERSAL_TABLE;
    const UniversalTable             table = UniversalTable::read(file);
    std::ifstream                    stream(file);
    const ContactTable               of_law = ContactTable::read(stream);
    std::mt19937                     random(2);
    std::uniform_real_distribution<> uniform(0, 1);
    constexpr double                 radius = 0.05; // R*
    for (unsigned int i = 0; i < 40; ++i)
      {
        const double          nu = 0.45 * uniform(random), phi = 50 * uniform(random);
        const UniversalFamily family(table, nu, phi);
        const ContactLaw      law = ContactLaw::universal({1e10, nu, phi, 1e7}, of_law);
        for (const double level : {3., 17., 90., 700., 3000.})
          {
            const UniversalValue      value = family.at(level);
            const double              peak  = value.approach * law.approach_yield(radius);
            const ContactCoefficients at    = law.coefficients(peak, radius);
            EXPECT_NEAR(at.force / law.force_yield(radius) / level, 1, 1e-3)
              << nu << ' ' << phi << ' ' << level;
            EXPECT_NEAR(at.residual / peak, value.residual_of_law / value.approach, 2e-3)
              << nu << ' ' << phi << ' ' << level;
            EXPECT_NEAR(at.n, value.law_exponent, 3e-3) << nu << ' ' << phi << ' ' << level;
            // The law is fitted to forces as well (fit_through_peak()).
            EXPECT_NEAR(at.residual / peak, value.residual_approach / value.approach, 1e-2)
              << nu << ' ' << phi << ' ' << level;
          }
      }
    for (std::size_t i = 0; i < table.all().size(); i += 13)
      {
        const UniversalNode &node = table.all()[i];
        const ContactLaw law  = ContactLaw::universal({1e10, node.nu, node.phi_deg, 1e7}, of_law);
        const double     peak = node.approach * law.approach_yield(radius);
        const ContactCoefficients at = law.coefficients(peak, radius);
        if (node.load_level < 1.5) // little is left of the approach, of which the bins hold lines
          continue;
        EXPECT_NEAR(at.n, node.n_law, 3e-3) << i;
        EXPECT_NEAR(at.residual / peak,
                    1 - std::pow(node.load_level / node.m_law, 1 / node.n_law) / node.approach,
                    2e-3)
          << i;
      }
  }

  TEST(UniversalLookup, leaves_the_table_only_when_told_to)
  {
    const UniversalTable table = table_of(0);
    EXPECT_THROW(UniversalFamily(table, 0.46, 30), InputError);
    EXPECT_THROW(UniversalFamily(table, 0.2, 50.1), InputError);
    const UniversalFamily family(table, 0.2, 50.1, Outside::extrapolate);
    EXPECT_NEAR(family.at(100).coefficients[1],
                UniversalFamily(table, 0.2, 50).at(100).coefficients[1],
                1e-2);
    EXPECT_THROW(family.at(2e4), InputError);
  }
} // namespace dpcontact
