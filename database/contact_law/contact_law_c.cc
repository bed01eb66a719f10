// Written so that it compiles where contact_law.h and contact_law_c.{h,cc} are copied to.
#include "contact_law_c.h"

#include "contact_law.h"

#include <algorithm>
#include <cstring>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>

struct dpcontact_law
{
  dpcontact::ContactLaw law;
};

namespace
{
  using namespace dpcontact;

  constexpr bool same(const int c, const ContactFlag flag) { return c == static_cast<int>(flag); }
  static_assert(same(DPCONTACT_PRESSED, contact_pressed) &&
                same(DPCONTACT_LOADING, contact_loading) &&
                same(DPCONTACT_YIELDED, contact_yielded) &&
                same(DPCONTACT_STRAIN_LARGE, contact_strain_large) &&
                same(DPCONTACT_EXTRAPOLATED, contact_extrapolated) &&
                same(DPCONTACT_INPUT_INVALID, contact_input_invalid));

  /// A new law of what `make` gives, or NULL and what was wrong: no exception may leave through C.
  template <typename Make>
  dpcontact_law *made(const Make &make, char *message, const std::size_t message_size)
  {
    const auto say = [&](const char *what) {
      if (message == nullptr || message_size == 0)
        return;
      const std::size_t length = std::min(std::strlen(what), message_size - 1);
      std::memcpy(message, what, length);
      message[length] = '\0';
    };
    try
      {
        return new dpcontact_law{make()};
      }
    catch (const std::exception &error)
      {
        say(error.what());
      }
    catch (...)
      {
        say("contact law: an exception of unknown type");
      }
    return nullptr;
  }
} // namespace

dpcontact_law *dpcontact_law_from_row(const double a,
                                      const double b,
                                      const double m,
                                      const double n,
                                      const double force_yield,
                                      const double approach_yield,
                                      const double effective_radius,
                                      char        *message,
                                      const size_t message_size)
{
  return made(
    [&] {
      return ContactLaw::from_row({a, b, m, n, force_yield, approach_yield, effective_radius});
    },
    message,
    message_size);
}

dpcontact_law *dpcontact_law_from_published_row(const double a,
                                                const double b,
                                                const double m,
                                                const double n,
                                                const double force_yield,
                                                const double approach_yield_of_one_sphere,
                                                const double effective_radius,
                                                char        *message,
                                                const size_t message_size)
{
  return made(
    [&] {
      return ContactLaw::from_row(ContactRow::published(
        a, b, m, n, force_yield, approach_yield_of_one_sphere, effective_radius));
    },
    message,
    message_size);
}

dpcontact_law *dpcontact_law_universal(const double youngs_modulus,
                                       const double poisson_ratio,
                                       const double friction_angle_deg,
                                       const double compressive_strength,
                                       const char  *table_file,
                                       char        *message,
                                       const size_t message_size)
{
  return made(
    [&] {
      std::ifstream file(table_file != nullptr ? table_file : "");
      if (!file)
        throw std::runtime_error(std::string("universal table: cannot read the file '") +
                                 (table_file != nullptr ? table_file : "") + "'");
      return ContactLaw::universal(
        {youngs_modulus, poisson_ratio, friction_angle_deg, compressive_strength},
        ContactTable::read(file));
    },
    message,
    message_size);
}

void dpcontact_law_free(dpcontact_law *law) { delete law; }

double dpcontact_effective_radius(const double radius_1, const double radius_2)
{
  return ContactLaw::effective_radius(radius_1, radius_2);
}

double dpcontact_force(const dpcontact_law *law,
                       const double         overlap,
                       const double         effective_radius,
                       double              *peak_overlap,
                       unsigned            *flags)
{
  ContactState          state{*peak_overlap};
  const ContactResponse response = law->law.evaluate(overlap, effective_radius, state);
  *peak_overlap                  = state.peak_overlap;
  if (flags != nullptr)
    *flags = response.flags;
  return response.force;
}

double dpcontact_residual_overlap(const dpcontact_law *law,
                                  const double         peak_overlap,
                                  const double         effective_radius)
{
  return law->law.coefficients(peak_overlap, effective_radius).residual;
}

double dpcontact_stiffness(const dpcontact_law *law,
                           const double         peak_overlap,
                           const double         effective_radius)
{
  return law->law.stiffness(peak_overlap, effective_radius);
}
