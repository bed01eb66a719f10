// The header is taken away alone: it must need no flag, no other file and no include before it.
#include "contact_law.h"

int main()
{
  using namespace dpcontact;
  ContactState state;
  const auto   law = ContactLaw::from_row({1, 1.5, 1, 1.5, 9, 3e-6, .05});
  return law.evaluate(3e-6, .05, state).force > 8.9 ? 0 : 1;
}
