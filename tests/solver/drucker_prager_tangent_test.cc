#include "solver/laws/drucker_prager.h"
#include "tests/solver/law_states.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
  using namespace dpcontact;
  using namespace dpcontact::tests;
  using Branch = laws::Branch;

  /// Largest entry of D:e − (σ(ε + h e) − σ(ε − h e))/(2h) over the six unit directions e, or −1
  /// where the difference straddles two branches.
  double finite_difference_error(const DruckerPrager        &law,
                                 const laws::State &old_state,
                                 const StressTensor         &strain,
                                 const double                h)
  {
    const auto response = law.evaluate(old_state, strain);
    double     error    = 0;
    for (unsigned int i = 0; i < 6; ++i)
      {
        StressTensor e;
        e.access_raw_entry(i) = 1;
        const auto plus       = law.evaluate(old_state, strain + h * e);
        const auto minus      = law.evaluate(old_state, strain - h * e);
        if (plus.branch != response.branch || minus.branch != response.branch)
          return -1;
        const StressTensor difference = (plus.stress - minus.stress) / (2 * h);
        error                         = std::max(error, (response.tangent * e - difference).norm());
      }
    return error;
  }

  void check_branch(const Branch branch, const double phi_deg, const double hardening)
  {
    Uniform      uniform(1968);
    unsigned int compared = 0;
    for (unsigned int trial = 0; trial < 4000 && compared < 100; ++trial)
      {
        const DruckerPrager  law = rock(.2 + .15 * uniform(), phi_deg, .2, hardening);
        laws::State old_state;
        old_state.plastic_strain     = uniform.tensor(.1);
        old_state.hardening_variable = .2 + .2 * uniform();
        const StressTensor strain =
          uniform.tensor(.4) + .6 * uniform() * dealii::unit_symmetric_tensor<3>();
        // The regular tangent varies over a strain of the size of the trial deviator.
        if (law.evaluate(old_state, strain).branch != branch ||
            (branch == Branch::regular &&
             dealii::deviator(strain - old_state.plastic_strain).norm() < .2))
          continue;
        const double error = finite_difference_error(law, old_state, strain, 1e-5);
        if (error < 0)
          continue;
        ++compared;
        // Truncation h²/6 σ''' with σ''' below 10/0.2² and rounding 1e-15/h each leave less than
        // 1e-8; a wrong coefficient shows at 1e-2.
        EXPECT_LT(error, 1e-7) << "nu " << law.bulk_modulus << " strain " << strain;
      }
    EXPECT_EQ(compared, 100u) << "too few states on this branch";
  }

  TEST(DruckerPragerTangent, ElasticIsTheDerivative) { check_branch(Branch::elastic, 30, 0); }
  TEST(DruckerPragerTangent, RegularIsTheDerivative) { check_branch(Branch::regular, 30, 0); }
  TEST(DruckerPragerTangent, RegularSteepIsTheDerivative) { check_branch(Branch::regular, 50, 0); }
  TEST(DruckerPragerTangent, RegularHardeningIsTheDerivative)
  {
    check_branch(Branch::regular, 30, .5);
  }
  TEST(DruckerPragerTangent, VonMisesIsTheDerivative) { check_branch(Branch::regular, 0, 0); }
  TEST(DruckerPragerTangent, VonMisesHardeningIsTheDerivative)
  {
    check_branch(Branch::regular, 0, .5);
  }
  TEST(DruckerPragerTangent, ApexIsTheDerivative) { check_branch(Branch::apex, 40, 0); }
  TEST(DruckerPragerTangent, ApexHardeningIsTheDerivative) { check_branch(Branch::apex, 40, .1); }

  TEST(DruckerPragerTangent, ApexWithoutHardeningIsZero)
  {
    const auto response = rock(.2, 30, .01).evaluate({}, dealii::unit_symmetric_tensor<3>());
    EXPECT_EQ(response.branch, Branch::apex);
    EXPECT_EQ(response.tangent.norm(), 0);
  }

  TEST(DruckerPragerTangent, ElasticIsHookesLaw)
  {
    const DruckerPrager law = rock(.2, 30, 1);
    const auto          expected =
      2 * law.shear_modulus * dealii::deviator_tensor<3>() +
      law.bulk_modulus * dealii::outer_product(dealii::unit_symmetric_tensor<3>(),
                                               dealii::unit_symmetric_tensor<3>());
    EXPECT_LT((law.evaluate({}, {}).tangent - expected).norm(), 1e-15); // a few roundings of 1
  }

  TEST(DruckerPragerTangent, HasMajorSymmetryToTheLastBit)
  {
    Uniform uniform(5);
    for (unsigned int trial = 0; trial < 1000; ++trial)
      {
        const DruckerPrager law = rock(.2, 30, .1, trial % 2 == 0 ? 0 : .3);
        const auto          D   = law.evaluate({}, uniform.tensor(.5)).tangent;
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            for (unsigned int k = 0; k < 3; ++k)
              for (unsigned int l = 0; l < 3; ++l)
                EXPECT_EQ(D[i][j][k][l], D[k][l][i][j]);
      }
  }
} // namespace
