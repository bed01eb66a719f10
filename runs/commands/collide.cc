#include "database/contact_law/collision.h"
#include "database/contact_law/law_of_case.h"
#include "runs/commands/commands.h"
#include "runs/commands/options.h"
#include "runs/interface/case_input.h"
#include "runs/interface/documents.h"
#include "runs/interface/outputs.h"
#include "runs/interface/warnings.h"
#include "solver/closed_form/first_yield.h"
#include "solver/closed_form/plausibility.h"
#include "solver/problem/quantity.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>

namespace dpcontact::commands
{
  namespace
  {
    constexpr double least_exponent = 1, largest_exponent = 3; ///< of a law's powers

    struct CollideOptions
    {
      SettingTexts        texts;
      std::string         parameter_file, table, radius_2;
      std::vector<double> row;
      std::string         density, velocity;
      unsigned int        steps = 20000;
      bool                json  = false;
    };

    ExitCode run(const CollideOptions &options)
    {
      check_files({{options.table, options.parameter_file}, {}});
      const Case input = read_body(merged(options.parameter_file, body_settings(), options.texts));
      const double radius   = input.scene.radius;
      const double radius_2 = options.radius_2.empty()
                                ? radius
                                : parse_quantity("radius-2", options.radius_2, Dimension::length);
      for (const std::size_t exponent : {1u, 3u})
        if (const double value = options.row.empty() ? 1.5 : options.row[exponent];
            !(value >= least_exponent && value <= largest_exponent))
          throw InputError("collide: the exponent " + std::string(coefficient_names[exponent]) +
                           " of --row is " + format_quantity(value, Dimension::number) +
                           "; those of contacts are about 1.5, and it must be from 1 to 3");
      if (options.table.empty() == options.row.empty())
        throw InputError("collide: give --table for the universal law, or --row a,b,m,n");
      auto doubts = doubts_about(input.material, radius);
      if (radius_2 != radius)
        for (const std::string &doubt : doubts_about(input.material, radius_2))
          if (std::find(doubts.begin(), doubts.end(), doubt) == doubts.end())
            doubts.push_back(doubt);
      const FirstYield       yield = first_yield(input.material, radius);
      const ContactLaw       law   = options.table.empty()
                                       ? contact_law(input, options.row, yield)
                                       : contact_law(input, read_universal_table(options.table));
      const CollidingSpheres spheres{
        radius,
        radius_2,
        parse_quantity("density", options.density, Dimension::density),
        parse_quantity("velocity", options.velocity, Dimension::velocity)};
      const Collision hit  = collide(law, spheres, options.steps);
      const double    half = ContactLaw::effective_radius(radius, radius_2);
      if ((hit.flags & contact_extrapolated) != 0)
        doubts.emplace_back("the peak lies beyond the universal table");
      if ((hit.flags & contact_strain_large) != 0)
        doubts.emplace_back("small strain is left behind: a/R > 0.1 at the peak");
      print_warnings(doubts);
      if (options.json)
        print_document({{"material", material_json(input)},
                        {"radius", radius},
                        {"radius_2", radius_2},
                        {"density", spheres.density},
                        {"velocity", spheres.velocity},
                        {"effective_mass", spheres.effective_mass()},
                        {"peak_overlap", hit.peak_overlap},
                        {"peak_force", hit.peak_force},
                        {"load_level", hit.peak_force / law.force_yield(half)},
                        {"duration", hit.duration},
                        {"rebound_velocity", hit.rebound_velocity},
                        {"restitution", hit.restitution},
                        {"residual_overlap", hit.residual_overlap},
                        {"strain_large", (hit.flags & contact_strain_large) != 0},
                        {"extrapolated", (hit.flags & contact_extrapolated) != 0},
                        {"warnings", joined(doubts)}});
      else
        std::cout << "peak     force " << format_quantity(hit.peak_force, Dimension::force) << " ("
                  << format_quantity(hit.peak_force / law.force_yield(half), Dimension::number)
                  << " F_y), overlap " << format_quantity(hit.peak_overlap, Dimension::length)
                  << "\nrebound  " << format_quantity(hit.rebound_velocity, Dimension::number)
                  << " m/s, restitution " << format_quantity(hit.restitution, Dimension::number)
                  << ", after " << format_quantity(1e6 * hit.duration, Dimension::number)
                  << " us\nresidual overlap "
                  << format_quantity(hit.residual_overlap, Dimension::length) << '\n';
      return ExitCode::success;
    }
  } // namespace

  void add_collide(CLI::App &command, Action &action)
  {
    const auto options = std::make_shared<CollideOptions>();
    add_settings(command, body_settings(), options->texts, "Material and first sphere");
    command
      .add_option("--radius-2", options->radius_2, "radius of the second sphere [the first's]")
      ->type_name("");
    command.add_option("--density", options->density, "of both, as 2650kg/m3 [required]")
      ->required()
      ->type_name("");
    command.add_option("--velocity", options->velocity, "of approach, as 1m/s [required]")
      ->required()
      ->type_name("");
    command.add_option("--table", options->table, "universal table, for the universal law")
      ->type_name("FILE.csv");
    command
      .add_option(
        "--row", options->row, "a,b,m,n of the consistent convention, for the law of a row")
      ->delimiter(',')
      ->expected(4)
      ->type_name("");
    command.add_option("--steps", options->steps, "about so many over the collision [20000]")
      ->type_name("N");
    add_parameter_file(command, options->parameter_file);
    add_json_flag(command, options->json);
    command.callback([options, &action] { action = [options] { return run(*options); }; });
  }
} // namespace dpcontact::commands
