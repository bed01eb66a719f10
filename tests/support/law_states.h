#ifndef DPCONTACT_TESTS_SUPPORT_LAW_STATES_H
#define DPCONTACT_TESTS_SUPPORT_LAW_STATES_H

#include "solver/laws/drucker_prager.h"
#include "solver/laws/strengths.h"

#include <cmath>
#include <cstdint>
#include <random>

namespace dpcontact::tests
{
  using laws::DruckerPrager;
  using laws::StressTensor;

  /// Uniform numbers in [−1, 1], the same on every platform.
  class Uniform
  {
  public:
    explicit Uniform(const std::uint32_t seed)
      : engine(seed)
    {}
    double operator()() { return 2 * (static_cast<double>(engine()) / 4294967295.) - 1; }

    StressTensor tensor(const double scale)
    {
      StressTensor t;
      for (unsigned int i = 0; i < 6; ++i)
        t.access_raw_entry(i) = scale * (*this)();
      return t;
    }

  private:
    std::mt19937 engine;
  };

  /// A law of unit Young's modulus from ν, φ in degrees and σc in units of E.
  inline DruckerPrager
  rock(const double nu, const double phi_deg, const double sigma_c, const double hardening = 0)
  {
    const double phi = phi_deg * (M_PI / 180);
    return {1 / (2 * (1 + nu)),
            1 / (3 * (1 - 2 * nu)),
            laws::drucker_prager_alpha(phi),
            laws::drucker_prager_strength(phi, sigma_c),
            1.3, // ξ: any value but 1, so that a missing factor shows
            hardening};
  }

  inline StressTensor diagonal(const double xx, const double yy, const double zz)
  {
    StressTensor t;
    t[0][0] = xx;
    t[1][1] = yy;
    t[2][2] = zz;
    return t;
  }

  inline StressTensor elastic_strain(const DruckerPrager &law, const StressTensor &stress)
  {
    return dealii::deviator(stress) / (2 * law.shear_modulus) +
           dealii::trace(stress) / (9 * law.bulk_modulus) * dealii::unit_symmetric_tensor<3>();
  }
} // namespace dpcontact::tests

#endif
