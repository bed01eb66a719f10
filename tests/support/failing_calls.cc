// A library for LD_PRELOAD that makes calls of a whole program fail, as the environment variable
// DPCONTACT_TEST_FAULT says: "write 3 28" is errno 28 from the third write on, "rename 2 0" the end
// of the process instead of the second renaming. Processes that are forked count for themselves.

#include "tests/support/faults.h"

#include <cstdlib>
#include <sstream>

namespace
{
  /// Runs when the library is loaded.
  const bool ready = [] {
    const char *const  given = std::getenv("DPCONTACT_TEST_FAULT");
    std::istringstream text(given == nullptr ? "" : given);
    std::string        call;
    int                when = 0, error = 0;
    if (text >> call >> when >> error)
      dpcontact::testing_faults::arm(call, when, error);
    return true;
  }();
} // namespace
