#include "solver/laws/drucker_prager.h"
#include "solver/laws/strengths.h"
#include "tests/support/floating_point_traps.h"
#include "tests/support/law_states.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <utility>

namespace
{
  using namespace dpcontact;
  using namespace dpcontact::tests;
  using Branch = laws::Branch;

  const auto *const traps = FloatingPointTraps::install();

  // Stresses and strains here are of order one, so 1e-13 is a few hundred roundings.
  constexpr double rounding = 1e-13;

  void expect_equal(const StressTensor &a, const StressTensor &b, const double tolerance)
  {
    EXPECT_LE((a - b).norm(), tolerance) << a << "\nagainst\n" << b;
  }

  TEST(DruckerPragerPoint, Values4C)
  {
    // 4C's unit test of its law: η = ξ = c = H = 1, E = 1, ν = 0.25, tensor shears of 1.1.
    const DruckerPrager law{0.4, 2. / 3, 1. / 3, 1, 1, 1};
    StressTensor        strain;
    strain[0][1] = strain[0][2] = strain[1][2] = 1.1;
    const auto sheared                         = law.evaluate({}, strain);
    EXPECT_EQ(sheared.branch, Branch::regular);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        // half a unit of the tenth printed digit
        EXPECT_NEAR(sheared.stress[i][j], i == j ? -0.1690982938 : 0.8214226327, 0.5e-10);

    const auto pulled = law.evaluate({}, dealii::unit_symmetric_tensor<3>());
    EXPECT_EQ(pulled.branch, Branch::apex);
    expect_equal(pulled.stress, 1.6 * dealii::unit_symmetric_tensor<3>(), rounding);
  }

  TEST(DruckerPragerPoint, UniaxialCompressionYieldsAtItsStrength)
  {
    for (const double phi : {0., 20., 30., 40., 60.})
      {
        const double        sigma_c = 0.01;
        const DruckerPrager law     = rock(0.2, phi, sigma_c);
        const StressTensor  strain  = elastic_strain(law, diagonal(0, 0, -sigma_c));
        EXPECT_NEAR(law.yield_function(diagonal(0, 0, -sigma_c), 0), 0, rounding * sigma_c);
        EXPECT_EQ(law.evaluate({}, (1 - 1e-9) * strain).branch, Branch::elastic);
        EXPECT_EQ(law.evaluate({}, (1 + 1e-9) * strain).branch, Branch::regular);
      }
  }

  TEST(DruckerPragerPoint, ConfinedCompressionFlowsAtTheConfinedStrength)
  {
    for (const auto &[phi, N_phi] :
         {std::pair(20., 2.039607), std::pair(30., 3.), std::pair(40., 4.598910)})
      {
        const double        sigma_c = 0.01, confinement = 0.004;
        const DruckerPrager law = rock(0.2, phi, sigma_c);

        // Triaxial test: axial strain driven far beyond yield, lateral stress held by Newton.
        laws::State state;
        double      lateral =
          elastic_strain(law, diagonal(-confinement, -confinement, -confinement))[0][0];
        double axial = 0;
        for (unsigned int step = 1; step <= 20; ++step)
          {
            const double   axial_strain = lateral - 0.005 * step;
            double         radial       = state.plastic_strain[0][0] + lateral;
            laws::Response response;
            unsigned int   iterations = 0;
            do
              {
                response              = law.evaluate(state, diagonal(radial, radial, axial_strain));
                const double residual = response.stress[0][0] + confinement;
                if (std::abs(residual) < 1e-16)
                  break;
                radial -= residual / (response.tangent[0][0][0][0] + response.tangent[0][0][1][1]);
              }
            while (++iterations < 30);
            ASSERT_LT(iterations, 30u) << phi << ' ' << step;
            state = response.state;
            axial = -response.stress[2][2];
          }
        // N_φ is printed to six decimals.
        EXPECT_NEAR(axial, sigma_c + N_phi * confinement, 0.5e-6 * confinement) << phi;
        // Associated flow dilates: tr Δεᵖ = η Δγ = η Δε̄ᵖ/ξ.
        EXPECT_NEAR(dealii::trace(state.plastic_strain),
                    3 * law.alpha * state.hardening_variable / law.xi,
                    rounding);
      }
  }

  TEST(DruckerPragerPoint, HydrostaticTensionStopsAtTheApex)
  {
    for (const auto &[phi, apex] :
         {std::pair(20., 0.961902), std::pair(30., 0.5), std::pair(40., 0.277862)})
      {
        const double        sigma_c = 0.01;
        const DruckerPrager law     = rock(0.2, phi, sigma_c);
        for (const double strain : {0.01, 1., 1e3})
          {
            const auto response = law.evaluate({}, strain * dealii::unit_symmetric_tensor<3>());
            EXPECT_EQ(response.branch, Branch::apex);
            // the closed form is printed to six decimals
            expect_equal(
              response.stress, apex * sigma_c * dealii::unit_symmetric_tensor<3>(), 1e-6 * sigma_c);
          }
      }
  }

  TEST(DruckerPragerPoint, UniaxialStrainStaysElasticWhereTheConeIsWide)
  {
    std::set<std::pair<double, double>> elastic;
    for (const double nu : {0.1, 0.2, 0.3})
      for (const double phi : {20., 30., 40.})
        {
          const DruckerPrager law      = rock(nu, phi, 1e-3);
          const auto          response = law.evaluate({}, diagonal(0, 0, -1));
          const double        tan_beta = 3 * std::sqrt(3.) * law.alpha;
          EXPECT_EQ(response.branch == Branch::elastic, 3 * (1 - 2 * nu) / (1 + nu) < tan_beta);
          if (response.branch == Branch::elastic)
            elastic.insert({nu, phi});
        }
    const std::set<std::pair<double, double>> expected{{0.2, 40.}, {0.3, 30.}, {0.3, 40.}};
    EXPECT_EQ(elastic, expected);
  }

  TEST(DruckerPragerPoint, PlasticWorkIsStrengthTimesFlow)
  {
    // σ:Δεᵖ = Δγ (√J₂ + ηp) = k Δε̄ᵖ/ξ ≥ 0 on the smooth cone and at its apex alike.
    Uniform                        uniform(20180601);
    std::map<Branch, unsigned int> seen{
      {Branch::elastic, 0}, {Branch::regular, 0}, {Branch::apex, 0}};
    for (unsigned int trial = 0; trial < 3000; ++trial)
      {
        const DruckerPrager law = rock(0.25 + 0.24 * uniform(),
                                       trial % 5 == 0 ? 0. : 35 + 25 * uniform(),
                                       0.2 + 0.1 * uniform(),
                                       trial % 2 == 0 ? 0. : 0.4 + 0.3 * uniform());
        laws::State         old;
        old.plastic_strain     = uniform.tensor(0.1);
        old.hardening_variable = 0.2 + 0.2 * uniform();
        const StressTensor strain =
          uniform.tensor(0.3) + 0.4 * uniform() * dealii::unit_symmetric_tensor<3>();
        const auto r = law.evaluate(old, strain);
        ++seen[r.branch];
        const double work = r.stress * (r.state.plastic_strain - old.plastic_strain);
        const double flow = r.state.hardening_variable - old.hardening_variable;
        const double k    = law.strength + law.xi * law.hardening * r.state.hardening_variable;
        EXPECT_GE(flow, 0);
        EXPECT_GE(work, 0);
        // bulk moduli reach 17, so trial stresses reach about 30
        EXPECT_NEAR(work, k * flow / law.xi, 30 * rounding);
      }
    for (const auto &[branch, count] : seen)
      EXPECT_GT(count, 200u) << "branch " << static_cast<int>(branch);
  }

  TEST(DruckerPragerPoint, StressIsContinuousAcrossTheBranches)
  {
    // Where √J₂ (Kη² + ξ²H) = G (ηp − k) both returns meet at the apex.
    for (const double H : {0., 0.5})
      {
        const DruckerPrager law = rock(0.2, 30, 0.1, H);
        const double        G = law.shear_modulus, eta = 3 * law.alpha, p = 1;
        const double        root_J2 =
          G * (eta * p - law.strength) / (law.bulk_modulus * eta * eta + law.xi * law.xi * H);
        StressTensor shear;
        shear[0][1]               = root_J2;
        const StressTensor volume = p * dealii::unit_symmetric_tensor<3>();
        const auto apex    = law.evaluate({}, elastic_strain(law, (1 - 1e-9) * shear + volume));
        const auto regular = law.evaluate({}, elastic_strain(law, (1 + 1e-9) * shear + volume));
        EXPECT_EQ(apex.branch, Branch::apex);
        EXPECT_EQ(regular.branch, Branch::regular);
        // trial states 2e-9 √J₂ apart, and a projection does not part them further
        expect_equal(apex.stress, regular.stress, 4e-9 * root_J2);
        EXPECT_NEAR(apex.state.hardening_variable, regular.state.hardening_variable, 1e-8);
      }
  }

  TEST(DruckerPragerPoint, VonMisesIsTheFrictionlessCone)
  {
    const DruckerPrager law = rock(0.3, 0, 0.01);
    EXPECT_EQ(law.alpha, 0);
    EXPECT_NEAR(law.strength, 0.01 / std::sqrt(3.), 1e-17);

    // Radial return: the pressure stays elastic, the deviator is scaled back to √J₂ = σc/√3.
    Uniform uniform(7);
    for (unsigned int trial = 0; trial < 100; ++trial)
      {
        const StressTensor strain   = uniform.tensor(1);
        const StressTensor deviator = dealii::deviator(strain);
        const auto         response = law.evaluate({}, strain);
        const StressTensor expected =
          law.strength * std::sqrt(2.) / deviator.norm() * deviator +
          law.bulk_modulus * dealii::trace(strain) * dealii::unit_symmetric_tensor<3>();
        EXPECT_EQ(response.branch, Branch::regular);
        expect_equal(response.stress, expected, rounding);
        EXPECT_NEAR(dealii::trace(response.state.plastic_strain), 0, rounding);
      }
  }

  TEST(DruckerPragerPoint, VonMisesNeverReachesAnApex)
  {
    const DruckerPrager law = rock(0.3, 0, 0.01);
    EXPECT_EQ(law.evaluate({}, diagonal(1e6, 1e6, 1e6)).branch, Branch::elastic);
    EXPECT_EQ(law.evaluate({}, {}).branch, Branch::elastic);
    for (const double shear : {0.02, 1., 1e20})
      {
        const auto response = law.evaluate({}, diagonal(1e6, 1e6 - shear, 1e6 + shear));
        // at 1e6 the strain itself loses shear smaller than 1e-10
        EXPECT_NE(response.branch, Branch::apex);
        EXPECT_TRUE(std::isfinite(response.stress.norm()));
        EXPECT_TRUE(std::isfinite(response.tangent.norm()));
      }
  }

  TEST(DruckerPragerPoint, SmallFrictionTendsToVonMises)
  {
    DruckerPrager law = rock(0.3, 0, 0.01);
    Uniform       uniform(11);
    for (const double alpha : {1e-12, 1e-170, 1e-310})
      for (unsigned int trial = 0; trial < 50; ++trial)
        {
          const StressTensor strain = uniform.tensor(1);
          law.alpha                 = 0;
          const auto von_mises      = law.evaluate({}, strain);
          law.alpha                 = alpha;
          const auto cone           = law.evaluate({}, strain);
          EXPECT_EQ(cone.branch, von_mises.branch);
          // differs by about K² tr ε α/G, below 1e-10 here
          expect_equal(cone.stress, von_mises.stress, 1e-10);
        }
  }

  TEST(DruckerPragerTangent, ApexWithoutHardeningIsZero)
  {
    const auto response = rock(0.2, 30, 0.01).evaluate({}, dealii::unit_symmetric_tensor<3>());
    EXPECT_EQ(response.branch, Branch::apex);
    EXPECT_EQ(response.tangent.norm(), 0);
  }

  TEST(DruckerPragerTangent, ElasticIsHookesLaw)
  {
    const DruckerPrager law = rock(0.2, 30, 1);
    const auto          expected =
      2 * law.shear_modulus * dealii::deviator_tensor<3>() +
      law.bulk_modulus * dealii::outer_product(dealii::unit_symmetric_tensor<3>(),
                                               dealii::unit_symmetric_tensor<3>());
    EXPECT_LT((law.evaluate({}, {}).tangent - expected).norm(), 1e-15); // a few roundings of 1
  }

  TEST(DruckerPragerParameters, FollowThePaper)
  {
    for (const double phi_deg : {0., 20., 30., 40., 89.})
      {
        const double phi      = phi_deg * (M_PI / 180);
        const double tan_beta = 6 * std::sin(phi) / (3 - std::sin(phi));
        const double d        = 15e6 * (1 - tan_beta / 3);
        EXPECT_NEAR(laws::drucker_prager_alpha(phi), tan_beta / (3 * std::sqrt(3.)), 1e-15);
        // the form with 1 − sinφ keeps digits that d loses towards 90°: absolute 1e-15 σc
        EXPECT_NEAR(laws::drucker_prager_strength(phi, 15e6), d / std::sqrt(3.), 15e6 * 1e-15);
      }
  }
} // namespace
