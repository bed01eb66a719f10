#include "runs/interface/documents.h"
#include "solver/problem/option_list.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace
{
  using namespace dpcontact;

  std::set<std::string> keys(const Json &object)
  {
    std::set<std::string> names;
    for (const auto &[name, value] : object.items())
      names.insert(name);
    return names;
  }

  using Keys = std::set<std::string>;

  Material rock(const Criterion criterion)
  {
    Material material{10e9, 0.15, Angle(criterion == Criterion::von_mises ? 0 : 25), 15e6};
    material.criterion = criterion;
    return material;
  }

  TEST(Documents, MaterialHasWhatItsCriterionHas)
  {
    const Keys common{"criterion", "E", "nu", "phi_deg", "sigma_c"};
    const auto with = [&](Keys more) {
      more.insert(common.begin(), common.end());
      return more;
    };
    const auto of = [](const Criterion criterion) { return material_json({rock(criterion), {}}); };
    EXPECT_EQ(keys(of(Criterion::drucker_prager)),
              with({"flow_stress_ratio", "dilation_deg", "hardening"}));
    EXPECT_EQ(keys(of(Criterion::von_mises)), with({"hardening"}));
    EXPECT_EQ(keys(of(Criterion::mohr_coulomb)),
              with({"dilation_deg", "cohesion", "tension_cutoff"}));
    EXPECT_EQ(of(Criterion::drucker_prager)["phi_deg"], 25.);
    EXPECT_EQ(of(Criterion::drucker_prager)["dilation_deg"], 25.); // associated
    EXPECT_TRUE(of(Criterion::mohr_coulomb)["tension_cutoff"].is_null());
  }

  TEST(Documents, SceneNamesTheSecondBody)
  {
    Case input{rock(Criterion::drucker_prager), {}};
    EXPECT_EQ(keys(scene_json(input)), (Keys{"radius", "force_max"}));
    input.scene.second = SecondBody{};
    EXPECT_EQ(scene_json(input)["second"], (Json{{"radius", "flat"}, {"rigid", true}}));
    input.scene.second = SecondBody{0.2, rock(Criterion::drucker_prager)};
    EXPECT_EQ(keys(scene_json(input)["second"]),
              (Keys{"radius",
                    "rigid",
                    "E",
                    "nu",
                    "phi_deg",
                    "sigma_c",
                    "flow_stress_ratio",
                    "dilation_deg",
                    "hardening"}));
  }

  TEST(Documents, OptionsAreThoseThatCount)
  {
    const Keys plain = keys(options_json(SolverOptions()));
    EXPECT_EQ(plain.count("geometry") + plain.count("sector-angle") + plain.count("outer-radius"),
              0U);
    EXPECT_EQ(plain.size(), 19U);
    const Keys space = keys(options_json(SolverOptions::of(Geometry::sector)));
    EXPECT_EQ(space.count("geometry"), 1U);
    EXPECT_EQ(space.size(), 22U);
    EXPECT_EQ(keys(options_json(SolverOptions::of(Geometry::published))).size(), 23U);
    EXPECT_EQ(solver_options().size(), 23U);
  }

  TEST(Documents, ErrorsHaveEverySourceAndTheTotal)
  {
    Record row;
    row.error[1] = {{1, 2, 3, 4, 5, 6}, 21};
    EXPECT_EQ(error_json(row)["b"],
              (Json{{"mesh", 1.},
                    {"step", 2.},
                    {"contact", 3.},
                    {"far_field", 4.},
                    {"finite_radius", 5.},
                    {"fit", 6.},
                    {"total", 21.}}));
  }
} // namespace
