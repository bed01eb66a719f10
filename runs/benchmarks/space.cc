// What one elastic and one plastic step cost in space, and what the linear solver does in them.
// Run, also under mpirun: dpcontact_space GEOMETRY ELEMENT RESOLUTION LEVEL DOMAIN-RADIUS SOLVER
// ANGLE (as `dpcontact solve` names them); prints JSON, and every finished step to standard error.
#include "solver/closed_form/first_yield.h"
#include "solver/closed_form/hertz.h"
#include "solver/parallel/environment.h"
#include "solver/path/pilot.h"
#include "solver/path/runs.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <iostream>
#include <string>

namespace
{
  using namespace dpcontact;

  double seconds()
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
  }

  /// Of the force at which the first point yields, and of first yield on the axis.
  constexpr double elastic_share = 0.9, plastic_level = 1.15;

  nlohmann::json measure(const SolverOptions &options, const Communicator &processes)
  {
    Material rock; // type 1 of the paper
    rock.youngs_modulus       = 10e9;
    rock.poisson_ratio        = 0.15;
    rock.friction_angle       = Angle(25);
    rock.compressive_strength = 15e6;
    Scene scene;
    scene.radius           = 0.1;
    const FirstYield yield = first_yield(rock, scene);
    scene.force_max        = plastic_level * yield.force;
    const double radius =
      hertz::contact_radius(scene, hertz::approach(rock, scene, scene.force_max));

    const double    start = seconds();
    ContactModel<3> model(rock, scene, options, radius, processes);
    nlohmann::json  result = {{"processes", processes.size()},
                              {"cells", model.quality().n_cells},
                              {"unknowns", model.discretisation().n_free()},
                              {"set_up_seconds", seconds() - start}};

    double       since  = seconds();
    unsigned int solves = 0, iterations = 0;
    const auto   step = [&](const char *, double, const int newton) {
      const auto &system = model.system();
      result["steps"].push_back({{"newton_iterations", newton},
                                 {"linear_solves", system.linear_solves() - solves},
                                 {"linear_iterations", system.linear_iterations() - iterations},
                                 {"seconds", seconds() - since}});
      if (processes.rank() == 0)
        std::cerr << "dpcontact_space: " << result["steps"].back().dump() << std::endl;
      solves     = system.linear_solves();
      iterations = system.linear_iterations();
      since      = seconds();
    };
    const auto legs =
      run_history(model, {{elastic_share * yield.onset_force(), 1}, {scene.force_max, 1}}, step);
    const double elastic_force = elastic_share * yield.onset_force();
    result["elastic_error"] =
      legs[0].back().approach / hertz::approach(rock, scene, elastic_force) - 1;
    result["approaches"]     = {legs[0].back().approach, legs[1].back().approach};
    result["plastic_volume"] = legs[1].back().plastic_volume;
    result["cut_backs"]      = model.counters().cut_backs;
    result["memory_bytes"]   = processes.sum(static_cast<double>(peak_memory()));
    return result;
  }
} // namespace

int main(int argc, char **argv)
try
  {
    if (argc != 8)
      {
        std::cerr << "usage: dpcontact_space GEOMETRY ELEMENT RESOLUTION LEVEL DOMAIN-RADIUS "
                     "SOLVER ANGLE\n";
        return 2;
      }
    SolverOptions options = SolverOptions::of(parse_enum<Geometry>(argv[1]));
    options.element       = parse_enum<Element>(argv[2]);
    options.resolution    = static_cast<unsigned int>(std::stoul(argv[3]));
    options.refinements   = static_cast<unsigned int>(std::stoul(argv[4]));
    options.domain_radius = std::stod(argv[5]);
    options.linear_solver = parse_enum<LinearSolver>(argv[6]);
    options.sector_angle  = std::stod(argv[7]);
    options.check();
    const Environment    environment;
    const Communicator   processes = environment.world();
    const nlohmann::json result    = measure(options, processes);
    if (processes.rank() == 0)
      std::cout << result.dump(2) << std::endl;
    return 0;
  }
catch (const std::exception &error)
  {
    std::cerr << "dpcontact_space: " << error.what() << std::endl;
    return 1;
  }
