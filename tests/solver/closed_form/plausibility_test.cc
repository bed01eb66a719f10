#include "meshing/errors.h"
#include "solver/closed_form/first_yield.h"
#include "solver/closed_form/plausibility.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{
  using namespace dpcontact;

  Case rock()
  {
    Case input;
    input.material.youngs_modulus       = 10e9;
    input.material.poisson_ratio        = 0.15;
    input.material.friction_angle       = Angle(25);
    input.material.compressive_strength = 15e6;
    return input;
  }

  std::string doubt(const Case &input) { return joined(doubts_about(input)); }

  TEST(Plausibility, RockAndSteelAreNotDoubted)
  {
    EXPECT_EQ(doubt(rock()), "");
    Case steel;
    steel.material.criterion            = Criterion::von_mises;
    steel.material.youngs_modulus       = 193e9;
    steel.material.poisson_ratio        = 0.3;
    steel.material.friction_angle       = Angle(0);
    steel.material.compressive_strength = 255e6;
    steel.scene.radius                  = 4.765e-3;
    EXPECT_EQ(doubt(steel), "");
    EXPECT_NO_THROW(check_possible(steel));
  }

  struct Mistake
  {
    const char *what;
    void (*change)(Case &);
    const char *found;
  };

  const Mistake mistakes[] = {
    {"MPa for GPa",
     [](Case &c) { c.material.youngs_modulus = 0.5e6; },
     "Young's modulus E is 500 kPa"},
    {"GPa twice", [](Case &c) { c.material.youngs_modulus = 1e13; }, "above 2000 GPa"},
    {"E and sigma_c swapped",
     [](Case &c) { std::swap(c.material.youngs_modulus, c.material.compressive_strength); },
     "swapped"},
    {"sigma_c in kPa",
     [](Case &c) { c.material.compressive_strength = 15e3; },
     "sigma_c/E is 1.5e-06, below 1e-05"},
    {"radians",
     [](Case &c) { c.material.friction_angle = Angle(0.61); },
     "in degrees, not in radians"},
    {"dilation in radians",
     [](Case &c) { c.material.dilation_angle = Angle(0.2); },
     "dilation angle psi is 0.2"},
    {"mm for m", [](Case &c) { c.scene.radius = 5; }, "sphere radius R is 5 m"},
    {"mN for kN", [](Case &c) { c.scene.force_max = 1e-4; }, "below 0.001: far from yield"},
    {"a force far above the table",
     [](Case &c) { c.scene.force_max = 1e6; },
     "above 10000: beyond the universal table"},
    {"a wide contact",
     [](Case &c) { c.scene.radius = 1e-3; },
     "contact radius over sphere radius is at least 0.19"},
    {"hardening above E", [](Case &c) { c.material.hardening = 1e12; }, "hardening modulus H"},
    {"a cut-off beyond the apex",
     [](Case &c) {
       c.material.criterion      = Criterion::mohr_coulomb;
       c.material.tension_cutoff = 50e6;
     },
     "cuts nothing off"},
    {"a doubtful second body",
     [](Case &c) {
       c.scene.second                           = SecondBody{0.1, c.material};
       c.scene.second->material->friction_angle = Angle(0.5);
     },
     "friction angle phi is 0.5"},
  };

  TEST(Plausibility, MistakesAreDoubted)
  {
    for (const Mistake &mistake : mistakes)
      {
        Case input = rock();
        mistake.change(input);
        EXPECT_NE(doubt(input).find(mistake.found), std::string::npos)
          << mistake.what << ": " << doubt(input);
      }
  }

  TEST(Plausibility, WhatIsNoContactIsRefused)
  {
    const auto refused = [](const Case &input) -> std::string {
      try
        {
          check_possible(input);
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "";
    };
    EXPECT_EQ(refused(rock()), "");
    Case input         = rock();
    input.scene.radius = 1e-6;
    EXPECT_NE(refused(input).find("more than the sphere's R = 1 um"), std::string::npos);
    input                               = rock();
    input.material.compressive_strength = 15;
    EXPECT_NE(refused(input).find("is the unit of F_max, R or sigma_c wrong?"), std::string::npos);
    input = rock();
    input.scene.force_max =
      0.99 * largest_load_level * first_yield(input.material, input.scene).force;
    input.material.youngs_modulus = 1e16; // so that the contact stays narrow
    input.scene.force_max =
      0.99 * largest_load_level * first_yield(input.material, input.scene).force;
    EXPECT_EQ(refused(input), "");
    input.scene.force_max *= 1.02;
    EXPECT_NE(refused(input), "");
  }

  TEST(Plausibility, AVanishingTensionCutOffIsRefusedWithWhatIsEnough)
  {
    Case input                    = rock();
    input.material.criterion      = Criterion::mohr_coulomb;
    input.material.tension_cutoff = 0;
    std::string message;
    try
      {
        check_possible(input);
      }
    catch (const InputError &error)
      {
        message = error.what();
      }
    EXPECT_NE(message.find("T0 = 0 Pa is too small"), std::string::npos) << message;
    EXPECT_NE(message.find("give at least 18.992 kPa"), std::string::npos) << message;
    input.material.tension_cutoff = 20e3;
    EXPECT_NO_THROW(check_possible(input));
  }

  TEST(Plausibility, TheOrderOfTheBodiesDoesNotMatter)
  {
    Case input                                   = rock();
    input.scene.radius                           = 1e-3;
    input.scene.second                           = SecondBody{0.1, input.material};
    input.scene.second->material->youngs_modulus = 1e5;
    Case swapped                                 = input;
    swapped.material                             = *input.scene.second->material;
    swapped.scene.radius                         = 0.1;
    swapped.scene.second                         = SecondBody{1e-3, input.material};
    EXPECT_EQ(doubts_about(input), doubts_about(swapped));
    EXPECT_GE(doubts_about(input).size(), 3U);
  }
} // namespace
