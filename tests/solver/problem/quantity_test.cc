#include "meshing/errors.h"
#include "solver/problem/quantity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{
  using namespace dpcontact;

  double pressure(const std::string &text)
  {
    return parse_quantity("E", text, Dimension::pressure);
  }
  double length(const std::string &text) { return parse_quantity("R", text, Dimension::length); }
  double force(const std::string &text) { return parse_quantity("F", text, Dimension::force); }

  // Multiples of ten are exact or correctly rounded, so equality is asked for.
  TEST(Quantity, suffixes_give_the_same_double_as_si)
  {
    EXPECT_EQ(pressure("10GPa"), 1e10);
    EXPECT_EQ(pressure("15 MPa"), 15e6);
    EXPECT_EQ(pressure("2.5kPa"), 2500.);
    EXPECT_EQ(pressure(" 1e7\tPa "), 1e7);
    EXPECT_EQ(pressure("+1e7"), 1e7);
    EXPECT_EQ(length("100mm"), 0.1);
    EXPECT_EQ(length("5um"), 5e-6);
    EXPECT_EQ(length("5µm"), 5e-6);
    EXPECT_EQ(length("5μm"), 5e-6);
    EXPECT_EQ(length("7nm"), 7e-9);
    EXPECT_EQ(length("3cm"), 0.03);
    EXPECT_EQ(length("1km"), 1000.);
    EXPECT_EQ(force("3mN"), 3e-3);
    EXPECT_EQ(force("2MN"), 2e6);
    EXPECT_EQ(force("0.1kN"), 100.);
    EXPECT_EQ(parse_quantity("phi", "30deg", Dimension::angle), 30.);
    EXPECT_EQ(parse_quantity("phi", "30°", Dimension::angle), 30.);
    EXPECT_EQ(parse_quantity("nu", "-.25", Dimension::number), -0.25);
  }

  class BadQuantity : public testing::TestWithParam<const char *>
  {};

  TEST_P(BadQuantity, is_refused_with_option_and_text)
  {
    try
      {
        pressure(GetParam());
        FAIL() << "accepted";
      }
    catch (const InputError &error)
      {
        const std::string message = error.what();
        EXPECT_EQ(message.rfind("E: '" + std::string(GetParam()) + "' is not ", 0), 0U) << message;
      }
  }

  INSTANTIATE_TEST_SUITE_P(Texts,
                           BadQuantity,
                           testing::Values("",
                                           " ",
                                           "GPa",
                                           "ten GPa",
                                           "1O GPa",
                                           "10 gpa",
                                           "10 N",
                                           "10 mm",
                                           "10,5 MPa",
                                           "10 MPa MPa",
                                           "0x10",
                                           "nan",
                                           "inf",
                                           "-inf Pa",
                                           "1e999",
                                           "1e308 GPa",
                                           "1 2",
                                           "--5"));

  TEST(Quantity, message_says_what_would_be_right)
  {
    try
      {
        force("3 kg");
        FAIL();
      }
    catch (const InputError &error)
      {
        EXPECT_STREQ(error.what(), "F: '3 kg' is not a force in mN, N, kN or MN");
      }
  }

  TEST(Count, takes_non_negative_integers_only)
  {
    EXPECT_EQ(parse_count("resolution", " 24 "), 24U);
    EXPECT_EQ(parse_count("level", "0"), 0U);
    for (const char *text : {"", "-1", "2.0", "1e3", "99999999999", "4x", "+3"})
      EXPECT_THROW(parse_count("resolution", text), InputError) << text;
  }

  TEST(Format, chooses_a_fitting_unit)
  {
    EXPECT_EQ(format_quantity(3.27922e-6, Dimension::length), "3.2792 um");
    EXPECT_EQ(format_quantity(0.1, Dimension::length), "100 mm");
    EXPECT_EQ(format_quantity(1e10, Dimension::pressure), "10 GPa");
    EXPECT_EQ(format_quantity(-5e6, Dimension::pressure), "-5 MPa");
    EXPECT_EQ(format_quantity(0, Dimension::force), "0 N");
    EXPECT_EQ(format_quantity(1e-13, Dimension::length), "0.0001 nm");
    EXPECT_EQ(format_quantity(25, Dimension::angle), "25°");
    EXPECT_EQ(format_quantity(std::nan(""), Dimension::number), "nan");
  }
} // namespace
