// Once for the program of all tests of meshing/.
#include "tests/support/floating_point_traps.h"

namespace
{
  [[maybe_unused]] const auto *const traps = dpcontact::tests::FloatingPointTraps::install();
}
