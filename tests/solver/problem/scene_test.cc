#include "meshing/errors.h"
#include "solver/problem/case.h"
#include "tests/support/floating_point_traps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace
{
  using namespace dpcontact;

  const auto *const traps = tests::FloatingPointTraps::install();

  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan      = std::numeric_limits<double>::quiet_NaN();

  Material sandstone()
  {
    Material m;
    m.youngs_modulus       = 10e9;
    m.poisson_ratio        = 0.38;
    m.friction_angle       = Angle(27.8);
    m.compressive_strength = 10.61e6;
    return m;
  }

  /// Expects an InputError whose message holds the quantity and the value.
  void expect_refusal(const std::function<void()> &check,
                      const std::string           &quantity,
                      const std::string           &value)
  {
    try
      {
        check();
        ADD_FAILURE() << quantity << " = " << value << " was accepted";
      }
    catch (const InputError &error)
      {
        const std::string message = error.what();
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        EXPECT_NE(message.find(quantity), std::string::npos) << message;
        EXPECT_NE(message.find(" is " + value), std::string::npos) << message;
      }
  }

  /// Of a material one of whose parameters, by its name, has this value.
  void expect_refusal(const std::string &parameter,
                      const double       value,
                      const std::string &quantity,
                      const std::string &printed)
  {
    Case input{sandstone(), {}};
    case_parameter(parameter).set(input, value);
    expect_refusal([&] { input.material.check(); }, quantity, printed);
  }

  TEST(MaterialCheck, AcceptsRockAndTheEndsOfTheRanges)
  {
    EXPECT_NO_THROW(sandstone().check());
    Material m       = sandstone();
    m.poisson_ratio  = 0;
    m.friction_angle = Angle(0);
    EXPECT_NO_THROW(m.check());
    m.poisson_ratio  = std::nextafter(0.5, 0.);
    m.friction_angle = Angle(std::nextafter(90., 0.));
    EXPECT_NO_THROW(m.check());
  }

  TEST(MaterialCheck, RefusesEachBadValueByName)
  {
    const std::string E = "Young's modulus E", nu = "Poisson's ratio nu",
                      phi = "friction angle phi", sigma_c = "uniaxial compressive strength sigma_c";

    expect_refusal("E", 0, E, "0 Pa");
    expect_refusal("E", -1e10, E, "-10000000000 Pa");
    expect_refusal("nu", 0.5, nu, "0.5;");
    expect_refusal("nu", -0.1, nu, "-0.1;");
    expect_refusal("phi", 90, phi, "90 degrees");
    expect_refusal("phi", -1, phi, "-1 degrees");
    expect_refusal("sigma_c", 0, sigma_c, "0 Pa");
    expect_refusal("sigma_c", -5e6, sigma_c, "-5000000 Pa");

    for (const auto &[member, name] : {std::pair("E", E),
                                       std::pair("nu", nu),
                                       std::pair("phi", phi),
                                       std::pair("sigma_c", sigma_c)})
      {
        expect_refusal(member, nan, name, "nan");
        expect_refusal(member, infinity, name, "inf");
        expect_refusal(member, -infinity, name, "-inf");
      }
  }

  TEST(MaterialCheck, RefusesAForgottenValue)
  {
    expect_refusal([] { Material().check(); }, "Young's modulus E", "nan");
  }

  TEST(SceneCheck, AcceptsTheDefaultAndRefusesBadValues)
  {
    EXPECT_NO_THROW(Scene().check());
    for (const auto &[value, printed] : {std::pair(0., "0"),
                                         std::pair(-1., "-1"),
                                         std::pair(nan, "nan"),
                                         std::pair(infinity, "inf")})
      {
        Scene radius, force;
        radius.radius   = value;
        force.force_max = value;
        expect_refusal([&] { radius.check(); }, "sphere radius R", printed);
        expect_refusal([&] { force.check(); }, "peak force F_max", printed);
      }
  }
} // namespace
