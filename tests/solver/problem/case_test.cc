#include "meshing/errors.h"
#include "solver/laws/criterion.h"
#include "solver/problem/case.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace
{
  using namespace dpcontact;

  const Case type_1{{10e9, 0.15, Angle(25), 15e6}, {}};

  TEST(CaseParameters, HaveNamesOptionsKeysAndColumnsOfOneSpelling)
  {
    const CaseParameter &strength = case_parameter("sigma_c");
    EXPECT_EQ(strength.option(), "sigma-c");
    EXPECT_EQ(strength.key(), "sigma_c");
    EXPECT_EQ(strength.column(), "sigma_c_Pa");
    EXPECT_EQ(case_parameter("phi").key(), "phi_deg");
    EXPECT_EQ(case_parameter("nu").column(), "nu");
    EXPECT_EQ(case_parameter("radius").column(), "radius_m");
    EXPECT_EQ(case_parameter("force_max").column(), "force_max_N");
    std::set<std::string> names;
    for (const CaseParameter &parameter : case_parameters())
      {
        EXPECT_TRUE(names.insert(parameter.name).second) << parameter.name;
        EXPECT_FALSE(parameter.help.empty()) << parameter.name;
        EXPECT_TRUE(parameter.set) << parameter.name;
        if (parameter.instead_of.empty())
          {
            EXPECT_TRUE(parameter.get) << parameter.name;
            EXPECT_FALSE(parameter.description.empty()) << parameter.name;
          }
        else
          EXPECT_NO_THROW(case_parameter(parameter.instead_of)) << parameter.name;
      }
  }

  TEST(CaseParameters, GiveBackWhatIsSet)
  {
    std::size_t judged = 0;
    for (const CaseParameter &parameter : stored_parameters())
      {
        Case input = type_1;
        parameter.set(input, 0.8);
        EXPECT_EQ(parameter.get(input), 0.8) << parameter.name;
        ++judged;
      }
    EXPECT_EQ(judged, 10U);
  }

  TEST(CaseParameters, AreRefusedWhereTheCriterionHasNone)
  {
    for (const CriterionDefinition &definition : criteria())
      for (const MaterialParameter &parameter : material_parameters())
        if (!parameter.belongs_to(definition.criterion) && parameter.instead_of.empty())
          {
            Material material  = type_1.material;
            material.criterion = definition.criterion;
            if (!definition.has_friction_angle)
              material.friction_angle = Angle(0);
            EXPECT_NO_THROW(material.check()) << parameter.name;
            parameter.set(material, parameter.dimension == Dimension::pressure ? 1e5 : 0.9);
            EXPECT_THROW(material.check(), InputError)
              << to_string(definition.criterion) << ' ' << parameter.name;
          }
  }

  TEST(Case, IsLabelledByWhatIsNotUsual)
  {
    EXPECT_EQ(label(type_1),
              "E = 10 GPa, nu = 0.15, phi = 25°, sigma_c = 15 MPa, R = 100 mm, F_max = 100 N");
    Case rounded                       = type_1;
    rounded.material.flow_stress_ratio = 0.8;
    rounded.material.dilation_angle    = Angle(10);
    EXPECT_EQ(label(rounded),
              "E = 10 GPa, nu = 0.15, phi = 25°, sigma_c = 15 MPa, K = 0.8, psi = 10°, R = 100 mm, "
              "F_max = 100 N");
    Case metal{{200e9, 0.3, Angle(0), 300e6}, {}};
    metal.material.criterion = Criterion::von_mises;
    metal.scene.second       = SecondBody{};
    EXPECT_EQ(label(metal),
              "von-mises, E = 200 GPa, nu = 0.3, yield stress = 300 MPa, R = 100 mm, F_max = 100 "
              "N; against a flat, rigid");
  }

  TEST(Case, IsOfTheTabulatedKindWithoutWhatTheTablesDoNotHold)
  {
    EXPECT_TRUE(is_tabulated_kind(type_1.material));
    std::size_t judged = 0;
    for (const MaterialParameter &parameter : definition_of(Criterion::drucker_prager).parameters)
      {
        Material material = type_1.material;
        parameter.set(material, 0.9);
        EXPECT_FALSE(is_tabulated_kind(material)) << parameter.name;
        ++judged;
      }
    EXPECT_EQ(judged, 3U);
    Material pyramid  = type_1.material;
    pyramid.criterion = Criterion::mohr_coulomb;
    EXPECT_FALSE(is_tabulated_kind(pyramid));
    Material associated       = type_1.material;
    associated.dilation_angle = Angle(25);
    EXPECT_TRUE(is_tabulated_kind(associated));
  }
} // namespace
