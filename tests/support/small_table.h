#ifndef DPCONTACT_TESTS_SUPPORT_SMALL_TABLE_H
#define DPCONTACT_TESTS_SUPPORT_SMALL_TABLE_H

#include "database/contact_law/contact_law.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

namespace dpcontact::tests
{
  /// ν 0.1, 0.2, 0.3, φ 20, 30, 40°, Λ 1/8 to 4096: `dpcontact sweep --mode families` of these.
  inline const ContactTable &small_table()
  {
    static const ContactTable table = [] {
      std::ifstream file(DPCONTACT_SMALL_TABLE);
      EXPECT_TRUE(file) << DPCONTACT_SMALL_TABLE;
      return ContactTable::read(file);
    }();
    return table;
  }

  inline ContactMaterial rock_of(const double nu, const double phi_deg)
  {
    return {10e9, nu, phi_deg, 10e6};
  }

  constexpr double sphere_radius = 0.1, half_radius = sphere_radius / 2; // R and R*

  struct NamedLaw
  {
    std::string name;
    ContactLaw  law;
  };

  /// Both kinds of law: rows from hardly to strongly plastic, rows that rounding has left slightly
  /// wrong, and universal laws on nodes of the table and between them.
  inline std::vector<NamedLaw> laws()
  {
    std::vector<NamedLaw> result;
    const auto            row =
      [&](const char *name, const double a, const double b, const double m, const double n) {
        result.push_back({name, ContactLaw::from_row({a, b, m, n, 9.056, 3.2792e-6, half_radius})});
      };
    row("type 1", 1.0148, 1.4729, 1.1829, 1.4643);
    row("most plastic", 1.3400, 1.3692, 8.3479, 1.2408);
    row("elastic", 1, 1.5, 1, 1.5);
    row("elastic, n < b by rounding", 1.0001, 1.5002, 0.9999, 1.4998);
    row("elastic, n > b by rounding", 0.9999, 1.4998, 1.0001, 1.5002);
    row("m < a", 1.2, 1.4, 0.8, 1.3);
    for (const double nu : {0.1, 0.17, 0.23, 0.3})
      for (const double phi : {20., 26., 33., 40.})
        result.push_back({"nu " + std::to_string(nu) + ", phi " + std::to_string(phi),
                          ContactLaw::universal(rock_of(nu, phi), small_table())});
    return result;
  }
} // namespace dpcontact::tests

#endif
