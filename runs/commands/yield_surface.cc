#include "solver/closed_form/yield_surface.h"

#include "database/files/csv.h"
#include "runs/commands/commands.h"
#include "runs/commands/options.h"
#include "runs/interface/case_input.h"
#include "runs/interface/documents.h"
#include "runs/interface/warnings.h"
#include "solver/closed_form/plausibility.h"
#include "solver/laws/law.h"
#include "solver/problem/quantity.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <sstream>

namespace dpcontact::commands
{
  namespace
  {
    struct YieldSurfaceOptions
    {
      SettingTexts texts;
      std::string  parameter_file;
      bool         json = false;
    };

    std::vector<Setting> plane_settings()
    {
      return {choice_setting("plane",
                             "meridional: meridians of triaxial extension, shear and compression; "
                             "deviatoric: the section at one pressure [meridional]",
                             {"meridional", "deviatoric"}),
              quantity_setting("pressure",
                               "meridional: largest pressure; deviatoric: the section's "
                               "(compression positive; above the apex') [sigma-c]",
                               Dimension::pressure),
              count_setting("points", "points of a meridian or of the section [121]")};
    }

    /// The material, with elastic constants of no consequence where none are given.
    Material material_of(SettingTexts texts)
    {
      for (const Setting &setting : plane_settings())
        texts.erase(setting.name);
      const bool has_modulus = find(texts, "E").has_value();
      texts.emplace("E", "1GPa");
      texts.emplace("nu", "0.25");
      Material material = read_body(texts).material, doubtful = material;
      if (!has_modulus)
        doubtful.youngs_modulus = std::numeric_limits<double>::quiet_NaN();
      print_warnings(doubts_about(doubtful, Scene{}.radius));
      return material;
    }

    std::vector<YieldSurfacePoint> meridians(const laws::Law   &law,
                                             const double       pressure_max,
                                             const double       scale,
                                             const unsigned int n)
    {
      const double                   start = tensile_pressure(law, scale).value_or(-pressure_max);
      std::vector<YieldSurfacePoint> points;
      for (const double angle : {0., M_PI / 6, M_PI / 3})
        for (unsigned int i = 0; i < n; ++i)
          {
            const double pressure = start + (pressure_max - start) * i / (n - 1);
            if (const auto point = surface_point(law, pressure, angle, scale))
              points.push_back(*point);
            else if (i == 0) // rounding has put the apex outside
              points.push_back({angle, start, 0, {-start, -start, -start}});
            else
              throw SolverError("the law does not yield on the ray from pressure " +
                                format_quantity(pressure, Dimension::pressure));
          }
      return points;
    }

    std::vector<YieldSurfacePoint>
    section(const laws::Law &law, const double pressure, const double scale, const unsigned int n)
    {
      std::vector<YieldSurfacePoint> points;
      for (unsigned int i = 0; i < n; ++i)
        {
          const auto point = surface_point(law, pressure, 2 * M_PI * i / (n - 1), scale);
          if (!point)
            {
              std::ostringstream message;
              message << "pressure: " << format_quantity(pressure, Dimension::pressure)
                      << " lies outside the yield surface";
              if (const auto apex = tensile_pressure(law, scale))
                message << "; it must be above " << format_quantity(*apex, Dimension::pressure);
              throw InputError(message.str());
            }
          points.push_back(*point);
        }
      return points;
    }

    const std::vector<std::string> &columns()
    {
      static const std::vector<std::string> names{"lode_angle_deg",
                                                  "pressure_Pa",
                                                  "i1_Pa",
                                                  "sqrt_j2_Pa",
                                                  "pi_x_Pa",
                                                  "pi_y_Pa",
                                                  "sigma_1_Pa",
                                                  "sigma_2_Pa",
                                                  "sigma_3_Pa"};
      return names;
    }

    std::vector<double> values(const YieldSurfacePoint &point)
    {
      return {point.lode_angle * 180 / M_PI,
              point.pressure,
              point.i1(),
              point.sqrt_j2,
              point.pi_x(),
              point.pi_y(),
              point.principal[0],
              point.principal[1],
              point.principal[2]};
    }

    void print_csv(const std::vector<YieldSurfacePoint> &points)
    {
      CsvFormat format;
      format.digits = 12;
      CsvWriter csv(format);
      csv.header(columns());
      for (const YieldSurfacePoint &point : points)
        {
          for (const double value : values(point))
            csv.add(value);
          csv.end_row();
        }
      std::cout << csv.text();
    }

    ExitCode run(const YieldSurfaceOptions &options)
    {
      const auto         settings = material_settings() + plane_settings();
      const SettingTexts texts    = merged(options.parameter_file, settings, options.texts);
      for (const Setting &setting : plane_settings())
        if (const auto text = texts.find(setting.name); text != texts.end())
          setting.check(text->second);
      const Case input{material_of(texts), {}};

      const auto         plane      = texts.find("plane");
      const bool         deviatoric = plane != texts.end() && plane->second == "deviatoric";
      const auto         given      = texts.find("pressure");
      const double       pressure   = given == texts.end()
                                        ? input.material.compressive_strength
                                        : parse_quantity("pressure", given->second, Dimension::pressure);
      const auto         asked      = texts.find("points");
      const unsigned int n = asked == texts.end() ? 121 : parse_count("points", asked->second);
      if (n < 2 || n > 1000000)
        throw InputError("points: '" + asked->second + "' must be from 2 to 1000000");
      if (!deviatoric && pressure <= 0)
        throw InputError("pressure: the largest of a meridian must be above 0, it is " +
                         format_quantity(pressure, Dimension::pressure));

      const laws::Law law   = law_of(input.material);
      const double    scale = input.material.compressive_strength;
      const auto      points =
        deviatoric ? section(law, pressure, scale, n) : meridians(law, pressure, scale, n);
      if (!options.json)
        {
          print_csv(points);
          return ExitCode::success;
        }
      Json material = material_json(input), rows = Json::array();
      for (const char *constant : {"E", "nu"}) // no part in it
        material.erase(constant);
      for (const YieldSurfacePoint &point : points)
        {
          Json        row;
          const auto  numbers = values(point);
          std::size_t i       = 0;
          for (const std::string &column : columns())
            row[column] = numbers[i++];
          rows.push_back(row);
        }
      print_document({{"material", material},
                      {"plane", deviatoric ? "deviatoric" : "meridional"},
                      {"pressure", pressure},
                      {"points", rows}});
      return ExitCode::success;
    }
  } // namespace

  void add_yield_surface(CLI::App &command, Action &action)
  {
    const auto options = std::make_shared<YieldSurfaceOptions>();
    add_settings(command, material_settings(), options->texts, "Material");
    add_settings(command, plane_settings(), options->texts, "Section");
    add_parameter_file(command, options->parameter_file);
    add_json_flag(command, options->json);
    command.callback([options, &action] { action = [options] { return run(*options); }; });
  }
} // namespace dpcontact::commands
