#include "solver/laws/mohr_coulomb.h"
#include "tests/support/floating_point_traps.h"
#include "tests/support/law_checks.h"
#include "tests/support/soil.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <ostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace
{
  using namespace dpcontact;
  using namespace dpcontact::tests;

  const auto *const traps = FloatingPointTraps::install();

  std::vector<LawCase<MohrCoulomb>> family(const std::vector<double> &friction_angles,
                                           const std::vector<Flow>   &flows,
                                           const std::vector<Cutoff> &cutoffs)
  {
    std::vector<LawCase<MohrCoulomb>> cases;
    for (const double nu : {0.2, 0.35, 0.499})
      for (const double phi : friction_angles)
        for (const Flow flow : flows)
          for (const Cutoff cutoff : cutoffs)
            cases.push_back({"nu " + std::to_string(nu) + ", phi " + std::to_string(phi) +
                               ", flow " + std::to_string(static_cast<int>(flow)) + ", cut-off " +
                               std::to_string(static_cast<int>(cutoff)),
                             soil(nu, phi, flow, cutoff),
                             cohesion});
    return cases;
  }

  const std::vector<double> frictions{10, 30, 45, 60};
  const std::vector<Cutoff> with_cutoff{Cutoff::low, Cutoff::zero, Cutoff::near_apex};

  struct Family
  {
    std::string                       name;
    std::vector<LawCase<MohrCoulomb>> cases;
    bool                              cut, apex;

    friend void PrintTo(const Family &family, std::ostream *out) { *out << family.name; }
  };

  std::vector<Family> families()
  {
    std::vector<Family> result;
    for (const auto &[name, flow] : {std::pair("associated", Flow::associated),
                                     std::pair("half", Flow::half),
                                     std::pair("isochoric", Flow::isochoric)})
      {
        result.push_back({name, family(frictions, {flow}, {Cutoff::none}), false, true});
        result.push_back(
          {std::string(name) + "_cut", family(frictions, {flow}, with_cutoff), true, false});
      }
    result.push_back({"tresca", family({0}, {Flow::associated}, {Cutoff::none}), false, false});
    result.push_back({"tresca_cut", family({0}, {Flow::associated}, with_cutoff), true, false});
    return result;
  }

  std::set<Branch> branches(const Family &a_family)
  {
    std::set<Branch> result{
      Branch::elastic, Branch::regular, Branch::compression_edge, Branch::extension_edge};
    if (a_family.apex)
      result.insert(Branch::apex);
    if (a_family.cut)
      result.insert({Branch::cutoff,
                     Branch::cutoff_edge,
                     Branch::cutoff_apex,
                     Branch::corner,
                     Branch::compression_corner,
                     Branch::extension_corner});
    return result;
  }

  /// Regions of trial states meet where one part of the surface bounds the other.
  std::set<std::pair<Branch, Branch>> boundaries(const Family &a_family)
  {
    std::set<std::pair<Branch, Branch>> result{{Branch::elastic, Branch::regular},
                                               {Branch::regular, Branch::compression_edge},
                                               {Branch::regular, Branch::extension_edge}};
    if (a_family.apex)
      result.insert(
        {{Branch::compression_edge, Branch::apex}, {Branch::extension_edge, Branch::apex}});
    if (a_family.cut)
      result.insert({{Branch::elastic, Branch::cutoff},
                     {Branch::cutoff, Branch::cutoff_edge},
                     {Branch::cutoff_edge, Branch::cutoff_apex},
                     {Branch::regular, Branch::corner},
                     {Branch::cutoff, Branch::corner},
                     {Branch::compression_edge, Branch::compression_corner},
                     {Branch::corner, Branch::compression_corner},
                     {Branch::cutoff_edge, Branch::compression_corner},
                     {Branch::extension_edge, Branch::extension_corner},
                     {Branch::corner, Branch::extension_corner}});
    return result;
  }

  class MohrCoulombFamily : public ::testing::TestWithParam<Family>
  {};
  INSTANTIATE_TEST_SUITE_P(MohrCoulomb,
                           MohrCoulombFamily,
                           ::testing::ValuesIn(families()),
                           [](const auto &param_info) { return param_info.param.name; });

#ifdef DEBUG // deal.II's assertions are slow
  constexpr unsigned int points = 2000;
#else
  constexpr unsigned int points = 10000;
#endif
  constexpr unsigned int visits    = points / 500;  // of every branch
  constexpr unsigned int crossings = points / 2000; // of every boundary, among points/5 pairs

  TEST_P(MohrCoulombFamily, ReturnsToTheYieldSurface)
  {
    expect_branches(check_returns(GetParam().cases, points, 1), branches(GetParam()), visits);
  }

  TEST_P(MohrCoulombFamily, TangentIsTheDerivative)
  {
    const Tally tally = check_tangents(GetParam().cases, points, 2);
    expect_branches(tally, branches(GetParam()), visits);
    EXPECT_LT(tally.unresolved, points / 100);
  }

  TEST_P(MohrCoulombFamily, StressIsContinuousAndDifferentiableUpToTheBoundaries)
  {
    const Tally tally = check_boundaries(GetParam().cases, points / 5, 3, points / 50);
    expect_boundaries(tally, boundaries(GetParam()), crossings);
    EXPECT_LT(tally.unresolved, points / 5 / 20);
  }

  TEST_P(MohrCoulombFamily, TurnsWithTheFrame)
  {
    const Tally tally = check_frame_invariance(GetParam().cases, points, 4);
    expect_branches(tally, branches(GetParam()), visits);
    EXPECT_LT(tally.unresolved, points / 100);
  }

  TEST_P(MohrCoulombFamily, DissipatesAndMostWhereAssociated)
  {
    expect_branches(check_dissipation(GetParam().cases, points, 5), branches(GetParam()), visits);
  }

  TEST_P(MohrCoulombFamily, TangentIsSymmetricIfAssociated)
  {
    check_major_symmetry(GetParam().cases, points, 6);
  }
} // namespace
