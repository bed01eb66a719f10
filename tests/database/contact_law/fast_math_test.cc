// Compiled as DEM codes are, with -Ofast or -ffinite-math-only, where NaN and infinity are taken
// not to exist: what is none is refused all the same. Ends with 0 where everything holds.
#include "contact_law.h"

#include <cstdio>
#include <fstream>
#include <sstream>

namespace
{
  using namespace dpcontact;

  int failures = 0;

  void expect(const bool holds, const char *what)
  {
    if (!holds)
      std::printf("FAILED: %s\n", what);
    failures += !holds;
  }

  /// Of bits that no compiler sees through.
  double of_bits(const volatile std::uint64_t &bits) { return contact_law_detail::from_bits(bits); }

  const volatile std::uint64_t nan_bits = 0x7FF8000000000000u, infinity_bits = 0x7FF0000000000000u;

  void expect_refusals(const ContactLaw &law)
  {
    const double nan = of_bits(nan_bits), infinity = of_bits(infinity_bits);
    for (const double none : {nan, -nan, infinity, -infinity})
      {
        ContactState state;
        const auto   first = law.evaluate(1e-6, 0.05, state);
        expect(first.flags != contact_input_invalid && first.force > 0, "a sound overlap presses");

        const auto of_overlap = law.evaluate(none, 0.05, state);
        expect(of_overlap.flags == contact_input_invalid, "an overlap that is none is flagged");
        expect(contact_law_detail::bits_of(of_overlap.force) == 0, "and has no force");
        expect(contact_law_detail::bits_of(state.peak_overlap) == contact_law_detail::bits_of(1e-6),
               "and changes no peak");

        const auto of_radius = law.evaluate(1e-6, none, state);
        expect(of_radius.flags == contact_input_invalid, "an R* that is none is flagged");

        ContactState broken{none};
        const auto   of_peak = law.evaluate(1e-6, 0.05, broken);
        expect(contact_law_detail::bits_of(of_peak.force) ==
                 contact_law_detail::bits_of(first.force),
               "a peak that is none counts as no peak");
        expect(contact_law_detail::bits_of(broken.peak_overlap) ==
                 contact_law_detail::bits_of(1e-6),
               "and is replaced");
        expect(contact_law_detail::is_finite(law.coefficients(none, 0.05).force),
               "coefficients of such a peak are numbers");
        expect(contact_law_detail::is_finite(law.stiffness(none, 0.05)), "so is the stiffness");

        bool refused = false;
        try
          {
            law.pair(none);
          }
        catch (const std::runtime_error &)
          {
            refused = true;
          }
        expect(refused, "no pair has such an R*");
      }
    ContactState state;
    for (const double radius : {0., -1., 1e-300, 1e300})
      expect(law.evaluate(1e-6, radius, state).flags == contact_input_invalid,
             "an R* that no contact has is flagged");
  }

  void expect_no_law(const ContactRow &row, const char *what)
  {
    bool refused = false;
    try
      {
        ContactLaw::from_row(row);
      }
    catch (const std::runtime_error &)
      {
        refused = true;
      }
    expect(refused, what);
  }
} // namespace

int main(const int argc, const char *const *const argv)
{
  const double nan = of_bits(nan_bits);
  expect_refusals(ContactLaw::from_row({1, 1.45, 1.2, 1.46, 9, 3e-6, 0.05}));
  expect_no_law({nan, 1.45, 1.2, 1.46, 9, 3e-6, 0.05}, "a is NaN");
  expect_no_law({1, 1.45, 1.2, 1.46, 9, 3e-6, nan}, "R* is NaN");
  expect_no_law({1, 1.45, 1.2, 1.46, 9, 3e-6, 1e-300}, "R* is 1e-300");
  expect_no_law({1, 1.45, 1.2, 1.46, 9, 1e308, 1e-5}, "delta_y over R* overflows");

  if (argc != 2)
    return 2;
  std::ifstream      file(argv[1]);
  std::ostringstream text;
  text << file.rdbuf();
  std::istringstream sound(text.str());
  const ContactTable table = ContactTable::read(sound);
  expect_refusals(ContactLaw::universal({1e10, 0.15, 25, 15e6}, table));
  bool refused = false;
  try
    {
      ContactLaw::universal({1e10, 0.15, 25, 1e308}, table);
    }
  catch (const std::runtime_error &)
    {
      refused = true;
    }
  expect(refused, "sigma_c is 1e308");
  return failures == 0 ? 0 : 1;
}
