#include "database/rows/exports.h"
#include "database/tables/estimators.h"
#include "database/tables/material_table.h"
#include "meshing/errors.h"
#include "solver/closed_form/plausibility.h"

#include <gtest/gtest.h>

#include <algorithm>
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

  TEST(Lookup, AWideContactIsWarnedOfAndItsRadiusEntersEveryUncertainty)
  {
    Case wide                          = type_1;
    wide.material.compressive_strength = 100e6;
    wide.scene.radius                  = 0.3e-3;
    wide.scene.force_max               = 4.8;
    const LookupResult found = universal().at(wide), narrow = universal().at(type_1);
    EXPECT_NE(joined(found.warnings).find("small strain"), std::string::npos);
    EXPECT_TRUE(narrow.warnings.empty()) << joined(narrow.warnings);
    // a and b move the approach as they move themselves
    EXPECT_GT(found.peak_approach.uncertainty / found.peak_approach.value,
              found.parts.finite_radius.a / found.coefficients.a / found.coefficients.b);
    EXPECT_GT(found.residual_approach.uncertainty, found.peak_approach.uncertainty);
    EXPECT_LT(narrow.peak_approach.uncertainty / narrow.peak_approach.value, 0.01);
  }

  TEST(Lookup, WhatARowDoesNotKnowNoMethodKnows)
  {
    const Database rows   = read_database(DPCONTACT_PAPERS_ROWS);
    std::size_t    inside = 0, judged = 0;
    for (const LookupMethod method : {LookupMethod::kriging, LookupMethod::natural_neighbour})
      {
        const LookupTable table(method, DPCONTACT_PAPERS_ROWS, make_estimator);
        for (std::size_t i = 0; i < rows.records.size(); i += 9)
          {
            const Record      &row   = rows.records[i];
            const LookupResult found = table.at(row.input);
            for (std::size_t c = 0; c < coefficient_names.size(); ++c)
              EXPECT_GE(found.published_uncertainty[c] * (1 + 1e-9),
                        c % 2 == 1 ? row.error[c].total : 0);
            inside += std::abs(found.peak_approach.value - row.state.approach_peak) <=
                      found.peak_approach.uncertainty;
            ++judged;
          }
      }
    EXPECT_EQ(judged, 36U);
    EXPECT_EQ(inside, judged);
  }

  TEST(Lookup, KrigingDoesNotDependOnTheOrderOfRows)
  {
    const LookupTable table(LookupMethod::kriging, DPCONTACT_PAPERS_ROWS, make_estimator);
    Database          rows = read_database(DPCONTACT_PAPERS_ROWS);
    std::reverse(rows.records.begin(), rows.records.end());
    const auto     reversed = MaterialTable::from_rows(rows);
    const auto     method   = make_estimator(LookupMethod::kriging, reversed);
    const Material material{10e9, 0.15, Angle(25), 15e6};
    const auto     estimate = method->at(MaterialPoint::of(material));
    // to the last digits of OpenTURNS, which sums over threads
    EXPECT_NEAR(estimate.value[0] / table.at(type_1).published.a, 1, 1e-10);
  }

  TEST(Lookup, ImpossibleLawsAreRefused)
  {
    const LookupTable table(LookupMethod::table_2, DPCONTACT_PAPERS_ROWS);
    std::size_t       refused = 0;
    for (const Record &row : read_database(DPCONTACT_PAPERS_ROWS).records)
      {
        const std::string message = refusal(table, row.input);
        if (message != "(answered)")
          {
            EXPECT_NE(message.find("no possible law"), std::string::npos) << message;
            ++refused;
            continue;
          }
        const LookupResult found = table.at(row.input);
        EXPECT_GE(found.residual_approach.value, 0);
        EXPECT_LT(found.residual_approach.value, found.peak_approach.value);
        EXPECT_GE(found.coefficients.n, 1);
      }
    EXPECT_GT(refused, 0U);
    Case far                          = type_1;
    far.material.compressive_strength = 5e9;
    try
      {
        LookupTable(LookupMethod::regression, DPCONTACT_PAPERS_ROWS, make_estimator)
          .at(far, Outside::extrapolate);
        ADD_FAILURE();
      }
    catch (const InputError &error)
      {
        EXPECT_NE(std::string(error.what()).find("no possible law"), std::string::npos)
          << error.what();
      }
  }

  TEST(Lookup, MoreLoadLeavesNoSmallerResidual)
  {
    std::size_t judged = 0;
    for (const double nu : {0., 0.1, 0.2, 0.3})
      for (const double phi : {25., 30., 35., 40., 45.})
        {
          Case         input            = type_1;
          double       last             = 0;
          const double ratio            = 1.06;
          input.material.poisson_ratio  = nu;
          input.material.friction_angle = Angle(phi);
          const double yield            = first_yield(input.material, input.scene).force;
          for (double level = 0.1; level < 20; level *= ratio)
            {
              input.scene.force_max = level * yield;
              const double residual = universal().at(input).residual_approach.value;
              EXPECT_GE(residual, last * (1 - 1e-12)) << nu << ' ' << phi << ' ' << level;
              last = residual;
              ++judged;
            }
          EXPECT_GT(last, 0);
        }
    EXPECT_GT(judged, 1000U);
  }

  TEST(Lookup, SaysWhereNothingYields)
  {
    Case light            = type_1;
    light.scene.force_max = 5;
    EXPECT_TRUE(universal().at(light).elastic());
    EXPECT_EQ(universal().at(light).residual_approach.uncertainty, 0);
    EXPECT_FALSE(universal().at(type_1).elastic());
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
