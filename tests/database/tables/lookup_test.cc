#include "database/tables/estimators.h"
#include "meshing/errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{
  using namespace dpcontact;

  const Case type_1{{10e9, 0.15, Angle(25), 15e6}, {}};

  const LookupTable &universal()
  {
    static const LookupTable table(LookupMethod::similarity, DPCONTACT_UNIVERSAL_TABLE);
    return table;
  }

  std::string refusal(const LookupTable &table, const Case &input)
  {
    try
      {
        table.at(input);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "(answered)";
  }

  TEST(Lookup, GivesBothConventionsWithTheirUncertainties)
  {
    const LookupResult found = universal().at(type_1);
    EXPECT_NEAR(found.load_level, 11.0, 0.05); // table 3: F_y = 9.056 N
    EXPECT_NEAR(found.published.a, found.coefficients.a * std::exp2(-found.coefficients.b), 1e-14);
    EXPECT_EQ(found.published.b, found.coefficients.b);
    for (std::size_t c = 0; c < coefficient_names.size(); ++c)
      {
        EXPECT_GT(found.uncertainty[c], 0) << coefficient_names[c];
        EXPECT_NEAR(found.uncertainty[c],
                    found.parts.interpolation[c] + found.parts.numerical[c] +
                      found.parts.finite_radius[c],
                    1e-15);
      }
    EXPECT_EQ(found.loading.size(), 201U);
    EXPECT_NEAR(found.loading.back().force, 100, 1e-9);
    EXPECT_NEAR(found.loading.back().approach, found.peak_approach.value, 1e-18);
    EXPECT_LT(found.residual_approach.value, found.peak_approach.value);
  }

  TEST(Lookup, RefusesMaterialsThatTheTablesDoNotHold)
  {
    std::size_t judged = 0;
    for (const auto change : {+[](Material &m) { m.flow_stress_ratio = 0.8; },
                              +[](Material &m) { m.dilation_angle = Angle(10); },
                              +[](Material &m) { m.hardening = 1e6; },
                              +[](Material &m) { m.criterion = Criterion::mohr_coulomb; }})
      {
        Case input = type_1;
        change(input.material);
        EXPECT_NE(refusal(universal(), input).find(tabulated_kind), std::string::npos);
        ++judged;
      }
    EXPECT_EQ(judged, 4U);
  }

  TEST(Lookup, OutsideItsDataRefusesOrStatesNoUncertainty)
  {
    Case outside                    = type_1;
    outside.material.friction_angle = Angle(55);
    EXPECT_NE(refusal(universal(), outside).find("phi"), std::string::npos);
    const LookupResult found = universal().at(outside, Outside::extrapolate);
    EXPECT_TRUE(std::isfinite(found.coefficients.a));
    for (std::size_t c = 0; c < coefficient_names.size(); ++c)
      EXPECT_TRUE(std::isnan(found.uncertainty[c])) << coefficient_names[c];
    EXPECT_TRUE(std::isnan(found.peak_approach.uncertainty));
  }

  TEST(Lookup, OverThePapersRowsAsksForItsRadiusAndForce)
  {
    const LookupTable  table(LookupMethod::regression, DPCONTACT_PAPERS_ROWS, make_estimator);
    const LookupResult found = table.at(type_1);
    EXPECT_NEAR(found.coefficients.a, found.published.a * std::exp2(found.published.b), 1e-14);
    Case larger         = type_1;
    larger.scene.radius = 0.2;
    EXPECT_NE(refusal(table, larger).find("radius"), std::string::npos);
  }
} // namespace
