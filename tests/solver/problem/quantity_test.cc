#include "meshing/errors.h"
#include "solver/problem/quantity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

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

  std::string refusal(const std::string &text, const Dimension dimension)
  {
    try
      {
        parse_quantities("x", text, dimension);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "(read)";
  }

  TEST(QuantityList, every_item_has_a_unit_or_none_has_or_it_stands_behind_a_bracket)
  {
    using List = std::vector<double>;
    EXPECT_EQ(parse_quantities("E", "10GPa, 20 GPa", Dimension::pressure), (List{1e10, 2e10}));
    EXPECT_EQ(parse_quantities("E", "1e10,2e10", Dimension::pressure), (List{1e10, 2e10}));
    EXPECT_EQ(parse_quantities("E", "(10, 20,30) GPa", Dimension::pressure),
              (List{1e10, 2e10, 3e10}));
    EXPECT_EQ(parse_quantities("R", "[0.25,0.5]mm", Dimension::length), (List{.25e-3, .5e-3}));
    EXPECT_EQ(parse_quantities("phi", "35, 5", Dimension::angle), (List{35, 5}));
    EXPECT_EQ(parse_quantities("K", "1", Dimension::number), (List{1}));
  }

  TEST(QuantityList, what_may_mean_two_things_is_refused_with_both)
  {
    struct Row
    {
      const char *text;
      Dimension   dimension;
      const char *one, *other;
    };
    for (const Row &row :
         {Row{"10,20,30GPa", Dimension::pressure, "10 Pa, 20 Pa, 30 GPa", "10 GPa, 20 GPa, 30 GPa"},
          Row{"10,5GPa", Dimension::pressure, "10 Pa, 5 GPa", "10 GPa, 5 GPa"},
          Row{"0.25,0.5,1mm", Dimension::length, "250 mm, 500 mm, 1 mm", "250 um, 500 um, 1 mm"},
          Row{"10GPa,20", Dimension::pressure, "10 GPa, 20 Pa", "10 GPa, 20 GPa"},
          Row{"35,5", Dimension::angle, "'35, 5'", "'35.5'"},
          Row{"0,2", Dimension::number, "'0, 2'", "'0.2'"}})
      {
        const std::string message = refusal(row.text, row.dimension);
        EXPECT_NE(message.find(row.one), std::string::npos) << message;
        EXPECT_NE(message.find(row.other), std::string::npos) << message;
      }
    EXPECT_NE(refusal("(10,20GPa", Dimension::pressure).find("bracket"), std::string::npos);
    EXPECT_NE(refusal("(10GPa,20)MPa", Dimension::pressure).find("behind"), std::string::npos);
    EXPECT_NE(refusal("10GPa,10000MPa", Dimension::pressure).find("twice"), std::string::npos);
    EXPECT_NE(refusal("1,,2", Dimension::number).find("not a number"), std::string::npos);
  }

  TEST(Format, values_have_the_digits_that_their_uncertainty_leaves)
  {
    const auto number = [](const double value, const double uncertainty) {
      return format_uncertain(value, uncertainty, Dimension::number);
    };
    EXPECT_EQ(number(1.0145557, .0049385), "1.015 ± 0.005");
    EXPECT_EQ(number(1.4731, .0102), "1.473 ± 0.011"); // never less than it is
    EXPECT_EQ(number(1.4731, .35), "1.5 ± 0.4");
    EXPECT_EQ(number(1234.5, 56), "1234 ± 56");
    EXPECT_EQ(number(1.5, 0), "1.5 ± 0");
    EXPECT_EQ(number(1.25, std::nan("")), "1.25");
    EXPECT_EQ(format_uncertain(16.586e-6, .1e-6, Dimension::length), "(16.59 ± 0.10) um");
    EXPECT_EQ(format_uncertain(0, 3e-9, Dimension::length), "(0 ± 3) nm");
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
