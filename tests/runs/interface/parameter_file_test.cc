#include "meshing/errors.h"
#include "runs/interface/case_input.h"
#include "runs/interface/parameter_file.h"
#include "runs/interface/spelling.h"
#include "solver/closed_form/first_yield.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

namespace
{
  using namespace dpcontact;

  std::vector<Setting> all_settings()
  {
    std::vector<Setting> settings = scene_settings();
    for (const Setting &setting : solver_settings())
      settings.push_back(setting);
    return settings;
  }

  /// A parameter file that is removed with its test.
  class ParameterFile : public testing::Test
  {
  protected:
    void SetUp() override
    {
      const auto *const test = testing::UnitTest::GetInstance()->current_test_info();
      file = std::filesystem::path(testing::TempDir()) / (std::string(test->name()) + ".prm");
    }
    void TearDown() override { std::filesystem::remove(file); }

    SettingTexts read(const std::string &content) const
    {
      std::ofstream(file) << content;
      return read_parameter_file(file, all_settings());
    }

    std::string complaint(const std::string &content) const
    {
      try
        {
          read(content);
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "(accepted)";
    }

    std::string at_line(const int line) const
    {
      return file.string() + ":" + std::to_string(line) + ": ";
    }

    std::filesystem::path file;
  };

  const std::string material = "set E = 10GPa\nset nu = 0.2\nset phi = 30\nset sigma-c = 5MPa\n";

  TEST_F(ParameterFile, says_the_same_as_the_options)
  {
    const SettingTexts texts =
      read("# comment\n" + material + "set resolution = 12 # coarse\nset contact = penalty\n");
    EXPECT_EQ(texts.size(), 6U);
    EXPECT_EQ(texts.at("E"), "10GPa");
    const Case input = read_case(texts);
    EXPECT_EQ(input.material.youngs_modulus, 1e10);
    EXPECT_EQ(input.material.friction_angle.degrees(), 30.);
    EXPECT_EQ(input.material.friction_angle.radians(), M_PI / 6);
    EXPECT_EQ(input.scene.force_max, Scene().force_max);
    const SolverOptions options = read_solver_options(texts);
    EXPECT_EQ(options.resolution, 12U);
    EXPECT_EQ(options.contact, ContactMethod::penalty);
    EXPECT_EQ(options.step_tolerance, SolverOptions().step_tolerance);
  }

  TEST_F(ParameterFile, unknown_entry_names_file_and_line)
  {
    const std::string message = complaint("\nset E = 10GPa\nset sigmac = 5MPa\n");
    EXPECT_EQ(message.rfind(at_line(3), 0), 0U) << message;
    EXPECT_NE(message.find("sigmac"), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }

  TEST_F(ParameterFile, ill_typed_entry_names_file_and_line)
  {
    EXPECT_EQ(complaint("# first\nset E = 10GPa, 3m\n"),
              at_line(2) + "E: ' 3m' is not a pressure in Pa, kPa, MPa or GPa");
    EXPECT_EQ(complaint("set resolution = 2.5\n"),
              at_line(1) + "resolution: '2.5' is not a non-negative integer");
    EXPECT_EQ(complaint("\n\nset contact = glued\n"),
              at_line(3) + "contact: 'glued' is not one of augmented or penalty");
    EXPECT_EQ(complaint("set nu = nan"), at_line(1) + "nu: 'nan' is not a finite number");
    EXPECT_EQ(complaint("set nu =\n"), at_line(1) + "nu: '' is not a number without unit");
    EXPECT_EQ(complaint("set phi = 20, ,30\n").rfind(at_line(1), 0), 0U);
    EXPECT_EQ(complaint("set level = 1, 2\n").rfind(at_line(1), 0), 0U);
  }

  TEST_F(ParameterFile, line_that_is_no_entry_names_file_and_line)
  {
    const std::string message = complaint("set nu = 0.2\nnu = 0.3\n");
    EXPECT_EQ(message.rfind(at_line(2), 0), 0U) << message;
  }

  TEST_F(ParameterFile, missing_file_or_directory_is_a_file_error)
  {
    EXPECT_THROW(read_parameter_file(file, all_settings()), FileError);
    EXPECT_THROW(read_parameter_file(testing::TempDir(), all_settings()), FileError);
  }

  TEST_F(ParameterFile, lists_span_a_grid_in_a_fixed_order)
  {
    const std::vector<Case> cases = read_grid(
      read("set E = 10GPa, 20GPa\nset nu = 0.1,0.2\nset phi = 20\nset sigma-c = 5MPa, 10MPa\n"
           "set force-max = 50N\n"));
    ASSERT_EQ(cases.size(), 8U);
    EXPECT_EQ(cases[1].material.compressive_strength, 10e6);
    EXPECT_EQ(cases[2].material.poisson_ratio, 0.2);
    EXPECT_EQ(cases[3].material.youngs_modulus, 10e9);
    EXPECT_EQ(cases[4].material.youngs_modulus, 20e9);
    EXPECT_EQ(cases[7].scene.force_max, 50.);
  }

  TEST_F(ParameterFile, grid_refuses_repeated_values_and_single_case_refuses_lists)
  {
    EXPECT_THROW(read_grid(read(material + "set radius = 0.1m, 100mm\n")), InputError);
    EXPECT_THROW(read_case(read(material + "set radius = 0.1m, 0.2m\n")), InputError);
  }

  TEST_F(ParameterFile, missing_material_is_named)
  {
    try
      {
        read_case(read("set E = 10GPa\nset nu = 0.2\nset phi = 30\n"));
        FAIL();
      }
    catch (const InputError &error)
      {
        EXPECT_EQ(std::string(error.what()).rfind("sigma-c is missing", 0), 0U) << error.what();
      }
  }

  TEST_F(ParameterFile, load_level_is_a_force_over_that_of_first_yield)
  {
    for (const std::string radius : {"0.1m", "3mm"})
      {
        const auto cases = read_grid(
          read("set E = 10GPa\nset nu = 0.2, 0.3\nset phi = 30\nset sigma-c = 5MPa\nset radius = " +
               radius + "\nset load-level = 0.5, 20, 1e3\n"));
        ASSERT_EQ(cases.size(), 6U);
        const double levels[] = {.5, 20, 1e3};
        for (std::size_t i = 0; i < cases.size(); ++i)
          {
            EXPECT_EQ(cases[i].material.poisson_ratio, i < 3 ? .2 : .3)
              << "the last varies fastest";
            // F_y of that row's own material and radius.
            const double force = first_yield(cases[i].material, cases[i].scene.radius).force;
            EXPECT_NEAR(cases[i].scene.force_max / force, levels[i % 3], 1e-12 * levels[i % 3]);
          }
      }
    // Whatever the strength is given by.
    const Case metal = read_case(read("set criterion = von-mises\nset E = 193GPa\nset nu = 0.25\n"
                                      "set yield-stress = 255MPa\nset load-level = 7\n"));
    EXPECT_NEAR(metal.scene.force_max,
                7 * first_yield(metal.material, metal.scene.radius).force,
                1e-9 * metal.scene.force_max);
  }

  TEST_F(ParameterFile, what_people_mistype_is_said)
  {
    EXPECT_EQ(complaint("set E = 1GPa\nset nu = 0.2\nset E = 2GPa\n"),
              at_line(3) + "E is set twice, first in line 1: leave one of them out");
    EXPECT_EQ(complaint("set sigma_c = 1MPa\n"),
              at_line(1) + "there is no entry sigma_c (did you mean sigma-c?)");
    EXPECT_EQ(complaint("\nE = 1GPa\n"),
              at_line(2) + "'E = 1GPa' is no entry: write 'set E = 1GPa'");
    EXPECT_EQ(read("\xEF\xBB\xBFset E = 1GPa\n").at("E"), "1GPa"); // a byte-order mark
  }

  SettingTexts with(SettingTexts texts, const SettingTexts &more)
  {
    texts.insert(more.begin(), more.end());
    return texts;
  }

  // What is said of the first holds for the second, not what followed from it.
  TEST_F(ParameterFile, second_body_is_as_said_of_the_first)
  {
    const SettingTexts coulomb{{"criterion", "mohr-coulomb"},
                               {"E", "10GPa"},
                               {"nu", "0.2"},
                               {"phi", "25"},
                               {"cohesion", "5MPa"}};
    const Case         input  = read_case(with(coulomb, {{"phi-2", "35"}}));
    const Material     second = input.scene.second->material.value();
    SettingTexts       alone  = coulomb;
    alone["phi"]              = "35";
    EXPECT_TRUE(second == read_case(alone).material);
    EXPECT_EQ(input.scene.second->radius, input.scene.radius);

    const Case stronger = read_case(with(coulomb, {{"sigma-c-2", "20MPa"}, {"dilation-2", "3"}}));
    EXPECT_EQ(stronger.scene.second->material->compressive_strength, 20e6);
    EXPECT_EQ(stronger.scene.second->material->flow_angle(), Angle(3));
    EXPECT_EQ(stronger.material.flow_angle(), Angle(25));

    const SettingTexts metal{
      {"criterion", "von-mises"}, {"E", "193GPa"}, {"nu", "0.3"}, {"yield-stress", "255MPa"}};
    EXPECT_EQ(read_case(with(metal, {{"yield-stress-2", "300MPa"}, {"hardening-2", "1GPa"}}))
                .scene.second->material->hardening,
              1e9);
    EXPECT_THROW(read_case(with(metal, {{"phi-2", "30"}})), InputError);
    EXPECT_THROW(read_case(with(coulomb, {{"phi-2", "35"}, {"E-2", "rigid"}})), InputError);
    EXPECT_FALSE(read_case(with(coulomb, {{"E-2", "rigid"}})).scene.second->material.has_value());
    EXPECT_TRUE(std::isinf(read_case(with(coulomb, {{"radius-2", "flat"}})).scene.second->radius));
  }

  TEST_F(ParameterFile, load_level_counts_in_the_yield_force_of_the_pair)
  {
    const SettingTexts texts{{"E", "10GPa"},
                             {"nu", "0.2"},
                             {"phi", "25"},
                             {"sigma-c", "15MPa"},
                             {"sigma-c-2", "5MPa"},
                             {"radius-2", "20mm"},
                             {"load-level", "7"}};
    const Case         input = read_case(texts);
    EXPECT_NEAR(input.scene.force_max / first_yield(input.material, input.scene).force, 7, 1e-12);
  }

  TEST(Spelling, near_words_are_found_and_far_ones_are_not)
  {
    const std::vector<std::string> words{"solve", "sweep", "sigma-c", "hard-cases"};
    EXPECT_EQ(nearest("solv", words), "solve");
    EXPECT_EQ(nearest("Solve", words), "solve");
    EXPECT_EQ(nearest("sigma_c", words), "sigma-c");
    EXPECT_EQ(nearest("hardcases", words), "hard-cases");
    EXPECT_EQ(nearest("frobnicate", words), "");
    EXPECT_EQ(nearest(std::string(100000, 'x'), words), "");
    EXPECT_EQ(suggestion("swep", words), " (did you mean sweep?)");
    EXPECT_EQ(suggestion("xyz", words), "");
  }

  TEST_F(ParameterFile, load_level_takes_the_place_of_a_force)
  {
    const auto refused = [&](const std::string &more, const std::string &part) {
      try
        {
          read_grid(read(material + more));
          ADD_FAILURE() << more;
        }
      catch (const InputError &error)
        {
          EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
        }
    };
    refused("set load-level = 3\nset force-max = 50N\n", "load-level and force-max");
    refused("set load-level = 0\n", "force");
    refused("set load-level = -3\n", "force");
    refused("set load-level = 3, 3\n", "load-level");
    EXPECT_THROW(read_case(read(material + "set load-level = 3, 4\n")), InputError);
    EXPECT_EQ(complaint("set load-level = 3N\n"),
              at_line(1) + "load-level: '3N' is not a number without unit");
  }
} // namespace
