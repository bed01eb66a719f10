#include "solver/laws/drucker_prager.h"
#include "solver/laws/strengths.h"
#include "solver/laws/von_mises.h"
#include "tests/support/floating_point_traps.h"
#include "tests/support/law_checks.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

// The smooth laws at random states, and what only the flow stress ratio, the dilation angle and the
// hardening bring; drucker_prager_test.cc holds the closed forms of the circular cone.
namespace
{
  using namespace dpcontact;
  using namespace dpcontact::tests;
  using laws::DruckerPrager;
  using laws::VonMises;

  const auto *const traps = FloatingPointTraps::install();

#ifdef DEBUG // deal.II's assertions are slow
  constexpr unsigned int points = 1000;
#else
  constexpr unsigned int points = 10000;
#endif

  constexpr double sigma_c = 2e-3; // in units of E
  constexpr double degree  = M_PI / 180;

  DruckerPrager cone(const double nu,
                     const double phi_deg,
                     const double ratio,
                     const double share_of_dilation,
                     const double hardening)
  {
    DruckerPrager law{1 / (2 * (1 + nu)),
                      1 / (3 * (1 - 2 * nu)),
                      laws::drucker_prager_alpha(phi_deg * degree),
                      laws::drucker_prager_strength(phi_deg * degree, sigma_c)};
    law.xi                = laws::drucker_prager_strength(phi_deg * degree, 1);
    law.hardening         = hardening;
    law.flow_stress_ratio = ratio;
    if (share_of_dilation < 1)
      law.flow_alpha = law.alpha * share_of_dilation;
    return law;
  }

  struct Family
  {
    std::string                         name;
    std::vector<LawCase<DruckerPrager>> cases;
    bool                                apex;

    friend void PrintTo(const Family &family, std::ostream *out) { *out << family.name; }
  };

  std::vector<Family> families()
  {
    std::vector<Family> result;
    const auto          add = [&](const char                *name,
                         const std::vector<double> &angles,
                         const double               ratio,
                         const double               share_of_dilation,
                         const double               hardening) {
      Family family{name, {}, angles.front() > 0};
      for (const double nu : {0.2, 0.35, 0.49})
        for (const double phi : angles)
          family.cases.push_back({"nu " + std::to_string(nu) + ", phi " + std::to_string(phi),
                                  cone(nu, phi, ratio, share_of_dilation, hardening),
                                  sigma_c});
      result.push_back(family);
    };
    const std::vector<double> angles{10, 30, 50};
    add("circular", angles, 1, 1, 0);
    add("circular_hardening", angles, 1, 1, 0.2);
    add("circular_half_dilation", angles, 1, 0.5, 0);
    add("circular_isochoric", angles, 1, 0, 0);
    add("circular_isochoric_hardening", angles, 1, 0, 0.2);
    add("rounded", angles, 0.778, 1, 0);
    add("rounded_slightly", angles, 0.98, 1, 0);
    add("rounded_hardening", angles, 0.778, 1, 0.2);
    add("rounded_half_dilation", angles, 0.778, 0.5, 0);
    add("rounded_isochoric", angles, 0.778, 0, 0);
    add("rounded_isochoric_hardening", angles, 0.778, 0, 0.2);
    add("rounded_frictionless", {0}, 0.778, 1, 0);
    return result;
  }

  class ConeFamily : public ::testing::TestWithParam<Family>
  {
  protected:
    static std::set<Branch> branches()
    {
      std::set<Branch> result{Branch::elastic, Branch::regular};
      if (GetParam().apex)
        result.insert(Branch::apex);
      return result;
    }
  };
  INSTANTIATE_TEST_SUITE_P(Cone,
                           ConeFamily,
                           ::testing::ValuesIn(families()),
                           [](const auto &param_info) { return param_info.param.name; });

  TEST_P(ConeFamily, ReturnsToTheYieldSurface)
  {
    expect_branches(check_returns(GetParam().cases, points, 1), branches(), points / 50);
  }

  TEST_P(ConeFamily, TangentIsTheDerivative)
  {
    const Tally tally = check_tangents(GetParam().cases, points, 2);
    expect_branches(tally, branches(), points / 50);
    EXPECT_LT(tally.unresolved, points / 50);
  }

  TEST_P(ConeFamily, StressIsContinuousAndDifferentiableUpToTheBoundaries)
  {
    const Tally tally = check_boundaries(GetParam().cases, points / 5, 3, points / 20);
    expect_boundaries(tally, {{Branch::elastic, Branch::regular}}, points / 100);
    if (GetParam().apex)
      {
        expect_boundaries(tally, {{Branch::regular, Branch::apex}}, points / 1000);
      }
    EXPECT_LT(tally.unresolved, points / 5 / 20);
  }

  TEST_P(ConeFamily, TurnsWithTheFrame)
  {
    const Tally tally = check_frame_invariance(GetParam().cases, points, 4);
    expect_branches(tally, branches(), points / 50);
    EXPECT_LT(tally.unresolved, points / 50);
  }

  TEST_P(ConeFamily, DissipatesAndMostWhereAssociated)
  {
    expect_branches(check_dissipation(GetParam().cases, points, 5), branches(), points / 50);
  }

  TEST_P(ConeFamily, TangentIsSymmetricIfAssociated)
  {
    check_major_symmetry(GetParam().cases, points, 6);
  }

  std::vector<LawCase<VonMises>> metals()
  {
    std::vector<LawCase<VonMises>> cases;
    for (const double nu : {0.2, 0.35, 0.499})
      for (const double hardening : {0., 0.2})
        cases.push_back({"nu " + std::to_string(nu) + ", H " + std::to_string(hardening),
                         VonMises{1 / (2 * (1 + nu)), 1 / (3 * (1 - 2 * nu)), sigma_c, hardening},
                         sigma_c});
    return cases;
  }

  TEST(VonMisesPoint, PassesEveryCheckOfALaw)
  {
    const std::set<Branch> branches{Branch::elastic, Branch::regular};
    expect_branches(check_returns(metals(), points, 1), branches, points / 50);
    const Tally tangents = check_tangents(metals(), points, 2);
    expect_branches(tangents, branches, points / 50);
    EXPECT_LT(tangents.unresolved, points / 50);
    const Tally boundaries = check_boundaries(metals(), points / 5, 3, points / 20);
    expect_boundaries(boundaries, {{Branch::elastic, Branch::regular}}, points / 100);
    expect_branches(check_frame_invariance(metals(), points, 4), branches, points / 50);
    expect_branches(check_dissipation(metals(), points, 5), branches, points / 50);
    check_major_symmetry(metals(), points, 6);
  }

  /// End of a uniaxial stress path along z, the lateral strain found by Newton's method; E = 1.
  template <typename Law>
  Response uniaxial(const Law &law, const double axial_strain, const unsigned int steps = 20)
  {
    State    state;
    Response response;
    double   lateral = 0;
    for (unsigned int step = 1; step <= steps; ++step)
      {
        const double axial      = axial_strain * step / steps;
        unsigned int iterations = 0;
        for (;; ++iterations)
          {
            response              = law.evaluate(state, diagonal(lateral, lateral, axial));
            const double residual = response.stress[0][0];
            if (std::abs(residual) < 1e-12 * sigma_c || iterations == 30)
              break;
            lateral -= residual / (response.tangent[0][0][0][0] + response.tangent[0][0][1][1]);
          }
        EXPECT_LT(iterations, 30u);
        state = response.state;
      }
    return response;
  }

  // Twenty steps, each left by Newton's method at 1e-12 σc.
  constexpr double path_tolerance = 1e-10 * sigma_c;

  TEST(VonMisesPoint, UniaxialStressHardensAlongItsModulus)
  {
    for (const double H : {0., 0.1, 1.})
      for (const double sign : {-1., 1.})
        {
          const VonMises law{1 / 2.6, 1 / 1.2, sigma_c, H};
          const double   strain   = 10 * sigma_c;
          const auto     response = uniaxial(law, sign * strain);
          // σ = σ_Y + H ε̄ᵖ and ε = σ/E + ε̄ᵖ
          const double stress = (sigma_c + H * strain) / (1 + H);
          EXPECT_NEAR(response.stress[2][2], sign * stress, path_tolerance);
          EXPECT_NEAR(response.state.hardening_variable, strain - stress, path_tolerance);
        }
  }

  TEST(Cone, UniaxialCompressionHardensAlongItsModulus)
  {
    // ε̄ᵖ is the axial plastic strain of associated flow (its work conjugate is σc).
    for (const double ratio : {1., 0.778})
      for (const double H : {0., 0.1, 1.})
        {
          const DruckerPrager law      = cone(0.3, 30, ratio, 1, H);
          const double        strain   = 10 * sigma_c;
          const auto          response = uniaxial(law, -strain);
          const double        stress   = (sigma_c + H * strain) / (1 + H);
          EXPECT_NEAR(response.stress[2][2], -stress, path_tolerance);
          EXPECT_NEAR(response.state.hardening_variable, strain - stress, path_tolerance);
        }
  }

  TEST(Cone, UniaxialTensionYieldsAtTheFlowStressRatio)
  {
    // t = q/K in tension: q/K + (q/3) tanβ = d.
    for (const double ratio : {1., 0.9, 0.778})
      for (const double phi : {10., 30., 45.})
        {
          const DruckerPrager law      = cone(0.2, phi, ratio, 1, 0);
          const double        tan_beta = 3 * std::sqrt(3.) * law.alpha;
          const double        d        = std::sqrt(3.) * law.strength;
          const double        q        = d / (1 / ratio + tan_beta / 3);
          EXPECT_NEAR(law.yield_function(diagonal(0, 0, q), 0), 0, 1e-15);
          EXPECT_NEAR(uniaxial(law, 5 * sigma_c).stress[2][2], q, path_tolerance);
        }
  }

  TEST(Cone, PureShearYieldsBetweenCompressionAndTension)
  {
    for (const double ratio : {1., 0.9, 0.778})
      {
        const DruckerPrager law = cone(0.2, 30, ratio, 1, 0);
        const double        tau = law.strength * 2 / (1 + 1 / ratio);
        EXPECT_NEAR(law.yield_function(diagonal(tau, 0, -tau), 0), 0, 1e-15);
      }
  }

  TEST(Cone, FlowStressRatioOfOneIsTheCircularCone)
  {
    // The rounded return at K → 1 against the closed form at K = 1.
    Uniform uniform(21);
    for (const double share : {1., 0.5, 0.})
      for (unsigned int i = 0; i < points / 10; ++i)
        {
          const DruckerPrager circular = cone(0.2, 30, 1, share, i % 2 == 0 ? 0 : 0.1);
          DruckerPrager       rounded  = circular;
          rounded.flow_stress_ratio    = 1 - 1e-13;
          const StressTensor strain = random_strain(uniform, sigma_c * log_uniform(uniform, 0, 2));
          // The surfaces are 1e-13 of the stress apart.
          EXPECT_LE(
            (circular.evaluate({}, strain).stress - rounded.evaluate({}, strain).stress).norm(),
            1e-12 * strain.norm());
        }
  }

  TEST(Cone, WithoutFrictionIsVonMises)
  {
    Uniform uniform(22);
    for (unsigned int i = 0; i < points; ++i)
      {
        const double        H   = i % 2 == 0 ? 0 : 0.3;
        const DruckerPrager law = cone(0.3, 0, 1, 1, H);
        const VonMises      metal{law.shear_modulus, law.bulk_modulus, sigma_c, H};
        State               old;
        old.plastic_strain        = dealii::deviator(uniform.tensor(sigma_c));
        old.hardening_variable    = sigma_c * (1 + uniform());
        const StressTensor strain = random_strain(uniform, sigma_c * log_uniform(uniform, 0, 2));
        const auto         a = law.evaluate(old, strain), b = metal.evaluate(old, strain);
        const double       rounding = 10 * rounding_of_stress(law, old, strain);
        ASSERT_EQ(a.branch, b.branch);
        EXPECT_LE((a.stress - b.stress).norm(), rounding);
        EXPECT_NEAR(a.state.hardening_variable, b.state.hardening_variable, rounding);
        EXPECT_LE((a.tangent - b.tangent).norm(), 1e-12);
      }
  }

  TEST(Cone, FullDilationIsAssociatedFlow)
  {
    Uniform uniform(23);
    for (const double ratio : {1., 0.778})
      for (unsigned int i = 0; i < points / 10; ++i)
        {
          const DruckerPrager associated = cone(0.2, 40, ratio, 1, 0);
          DruckerPrager       almost     = associated;
          almost.flow_alpha              = associated.alpha * (1 - 1e-12);
          ASSERT_FALSE(almost.associated());
          const StressTensor strain = random_strain(uniform, sigma_c * log_uniform(uniform, 0, 2));
          EXPECT_LE(
            (associated.evaluate({}, strain).stress - almost.evaluate({}, strain).stress).norm(),
            1e-10 * strain.norm());
        }
  }

  TEST(Cone, IsochoricFlowKeepsItsVolumeButAtTheApex)
  {
    Uniform      uniform(24);
    unsigned int apex = 0, regular = 0;
    for (unsigned int i = 0; i < points; ++i)
      {
        const DruckerPrager law      = cone(0.2, 40, i % 2 == 0 ? 1 : 0.778, 0, 0);
        const StressTensor  strain   = random_strain(uniform, 20 * sigma_c);
        const auto          response = law.evaluate({}, strain);
        const double        volume   = dealii::trace(response.state.plastic_strain);
        if (response.branch == Branch::regular)
          {
            ++regular;
            EXPECT_NEAR(volume, 0, 1e-14 * strain.norm());
          }
        if (response.branch == Branch::apex)
          {
            ++apex;
            EXPECT_GE(volume, 0);
            EXPECT_NEAR(dealii::trace(response.stress), law.strength / law.alpha, 1e-14);
          }
      }
    EXPECT_GT(apex, points / 50);
    EXPECT_GT(regular, points / 50);
  }

  TEST(Cone, IsochoricHardeningPullsTheApexToThePressure)
  {
    // Δεᵖ_v = 0: the strength grows until the apex stands at the trial pressure.
    const DruckerPrager law    = cone(0.2, 30, 1, 0, 0.1);
    const double        volume = 10 * sigma_c;
    const auto response        = law.evaluate({}, volume / 3 * dealii::unit_symmetric_tensor<3>());
    EXPECT_EQ(response.branch, Branch::apex);
    EXPECT_NEAR(dealii::trace(response.stress) / 3, law.bulk_modulus * volume, 1e-15);
    EXPECT_NEAR(law.yield_function(response.stress, response.state.hardening_variable), 0, 1e-15);
  }
} // namespace
