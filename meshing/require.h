#ifndef DPCONTACT_MESHING_REQUIRE_H
#define DPCONTACT_MESHING_REQUIRE_H

#include "meshing/errors.h"
#include "meshing/number_text.h"

#include <string>

namespace dpcontact
{
  /// Refuses a quantity that is out of its range.
  /// @param holds whether it is within
  /// @param what the group that the quantity belongs to, for the message
  /// @param range what the quantity must be, for the message
  /// @throws InputError "<what>: <name> = <value> is out of range; it must be <range>" unless
  /// `holds`.
  inline void require(const bool        holds,
                      const char *const what,
                      const char *const name,
                      const double      value,
                      const char *const range)
  {
    if (!holds)
      throw InputError(std::string(what) + ": " + name + " = " + number_text(value) +
                       " is out of range; it must be " + range);
  }
} // namespace dpcontact

#endif
