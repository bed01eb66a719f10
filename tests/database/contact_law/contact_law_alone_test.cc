// The header is taken away alone: it must need no flag, no other file and no include before it. Its
// C interface is taken away with it: contact_law_c.cc is compiled from the same folder.
#include "contact_law.h"
#include "contact_law_c.h"

int main()
{
  using namespace dpcontact;
  ContactState state;
  const auto   law   = ContactLaw::from_row({1, 1.5, 1, 1.5, 9, 3e-6, 0.05});
  const double force = law.evaluate(3e-6, 0.05, state).force;

  dpcontact_law *const in_c   = dpcontact_law_from_row(1, 1.5, 1, 1.5, 9, 3e-6, 0.05, nullptr, 0);
  double               peak   = 0;
  const double         from_c = dpcontact_force(in_c, 3e-6, 0.05, &peak, nullptr);
  dpcontact_law_free(in_c);
  return force > 8.9 && from_c == force && peak == state.peak_overlap ? 0 : 1;
}
