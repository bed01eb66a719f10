#include "runs/second_body.h"

#include "meshing/errors.h"
#include "solver/laws/von_mises.h"

#include <limits>

namespace dpcontact
{
  std::vector<Setting> second_body_settings()
  {
    using Kind = Setting::Kind;
    return {
      Setting{"radius-2", Kind::text, "radius of the second body, or flat [radius]"},
      Setting{"E-2", Kind::text, "Young's modulus of the second body, or rigid [E]"},
      Setting{"nu-2", Kind::quantity, "Poisson's ratio of the second body [nu]"},
      Setting{"phi-2",
              Kind::quantity,
              "friction angle of the second body in degrees [phi]",
              Dimension::angle},
      Setting{"sigma-c-2",
              Kind::quantity,
              "uniaxial strength of the second body: compressive, of von-mises the yield stress "
              "[that of the first]",
              Dimension::pressure}};
  }

  void read_second_body(const SettingTexts &texts, Case &input)
  {
    const auto text = [&](const char *name) {
      const auto found = texts.find(name);
      return found == texts.end() ? std::string() : found->second;
    };
    bool any = false;
    for (const Setting &setting : second_body_settings())
      if (const std::string given = text(setting.name.c_str()); !given.empty())
        {
          any = true;
          setting.check(given);
        }
    if (!any)
      return;

    SecondBody        second;
    const std::string radius = text("radius-2"), modulus = text("E-2");
    if (radius.empty())
      second.radius = input.scene.radius;
    else if (radius != "flat")
      second.radius = parse_quantity("radius-2", radius, Dimension::length);
    if (modulus == "rigid")
      {
        for (const char *const name : {"nu-2", "phi-2", "sigma-c-2"})
          if (!text(name).empty())
            throw InputError(std::string(name) +
                             " is set, but the second body is rigid: leave it out");
      }
    else
      {
        Material material = input.material;
        if (!modulus.empty())
          material.youngs_modulus = parse_quantity("E-2", modulus, Dimension::pressure);
        if (!text("nu-2").empty())
          material.poisson_ratio = parse_quantity("nu-2", text("nu-2"), Dimension::number);
        if (!text("sigma-c-2").empty())
          material.compressive_strength =
            parse_quantity("sigma-c-2", text("sigma-c-2"), Dimension::pressure);
        if (!text("phi-2").empty())
          {
            if (material.criterion == Criterion::von_mises)
              throw InputError("phi-2 is set, but von-mises has no friction angle: leave it out");
            material.friction_angle =
              radians(parse_quantity("phi-2", text("phi-2"), Dimension::angle));
          }
        second.material = material;
      }
    input.scene.second = second;
    input.scene.check();
  }
} // namespace dpcontact
