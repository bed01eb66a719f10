#ifndef DPCONTACT_DATABASE_CONTACT_LAW_LAW_OF_CASE_H
#define DPCONTACT_DATABASE_CONTACT_LAW_LAW_OF_CASE_H

#include "database/contact_law/contact_law.h"
#include "solver/problem/case.h"

#include <string>
#include <vector>

namespace dpcontact
{
  struct FirstYield;

  /// A universal table, or an excerpt that has the law's columns alone.
  /// @throws FileError where it cannot be read, CorruptData saying what is wrong with it.
  ContactTable read_universal_table(const std::string &file);

  /// Whether the table's materials are of this one's kind (is_tabulated_kind()) and its ν and φ are
  /// within.
  bool covers(const ContactTable &table, const Case &input);

  /// The universal law of a material. @throws InputError unless the table covers it.
  ContactLaw contact_law(const Case &input, const ContactTable &table);

  /// The law of a row a, b, m, n of the consistent convention, for spheres of the scene's radius.
  /// @throws InputError where one is not positive.
  ContactLaw
  contact_law(const Case &input, const std::vector<double> &row, const FirstYield &yield);
} // namespace dpcontact

#endif
