#include "runs/studies/hard_cases.h"

#include "fitting/curve_fit.h"
#include "meshing/errors.h"
#include "solver/closed_form/first_yield.h"
#include "solver/closed_form/hertz.h"
#include "solver/laws/law.h"
#include "solver/laws/strengths.h"
#include "solver/path/pilot.h"
#include "solver/path/runs.h"
#include "solver/path/solution.h"
#include "solver/path/solve.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>

namespace dpcontact
{
  namespace
  {
    constexpr double radius = 0.1;

    /// φ in degrees; E and σc of a rock.
    Material rock(const double nu, const double phi_deg) { return {10e9, nu, Angle(phi_deg), 5e6}; }

    Material metal(const double nu)
    {
      Material material  = rock(nu, 0);
      material.criterion = Criterion::von_mises;
      return material;
    }

    /// Coarse enough for dozens of cases a minute; what is judged does not depend on the mesh.
    SolverOptions coarse()
    {
      SolverOptions options;
      options.resolution     = 16;
      options.step_tolerance = 0.02;
      options.closed_form    = false;
      return options;
    }

    Scene at_load_level(const Material &material, const double load_level, const double R = radius)
    {
      return {R, load_level * first_yield(material, R).force};
    }

    std::string text(const double value)
    {
      std::ostringstream stream;
      stream.precision(4);
      stream << value;
      return stream.str();
    }

    HardCaseRun run_of(const Solution &solution)
    {
      return {solution.checks, solution.cost.newton_iterations, solution.cost.cut_backs, {}, true};
    }

    /// Approach at the peak and after release over δ_y.
    std::string shape_of(const Solution &solution)
    {
      return "delta_max " + text(solution.curve.loading.back().approach / solution.yield.approach) +
             ", delta_res " + text(solution.curve.residual_approach() / solution.yield.approach) +
             " delta_y";
    }

    HardCaseRun solved(const Material &material, const Scene &scene, const SolverOptions &options)
    {
      const Solution solution = solve_contact(material, scene, options);
      HardCaseRun    run      = run_of(solution);
      run.found               = shape_of(solution);
      return run;
    }

    HardCase scene_case(const std::string   &name,
                        const std::string   &about,
                        const Material      &material,
                        const double         load_level,
                        const SolverOptions &options = coarse())
    {
      return {name, about, [=] {
                return solved(material, at_load_level(material, load_level), options);
              }};
    }

    /// Largest relative difference of the curves' approaches at the same forces, in units of δ_y.
    double curve_difference(const Solution &one, const Solution &other)
    {
      double     largest = 0;
      const auto compare = [&](const auto &a, const auto &b) {
        const std::size_t n = std::min(a.size(), b.size());
        if (a.size() != b.size())
          largest = 1;
        for (std::size_t i = 0; i < n; ++i)
          largest = std::max(
            largest,
            std::abs(a[i].approach / one.yield.approach - b[i].approach / other.yield.approach));
      };
      compare(one.curve.loading, other.curve.loading);
      compare(one.curve.unloading, other.curve.unloading);
      return largest / (one.curve.loading.back().approach / one.yield.approach);
    }

    /// The scene that same_curve() compares with; computed once.
    const Solution &reference()
    {
      const Material        material = rock(.2, 30);
      static const Solution solution =
        solve_contact(material, at_load_level(material, 30), coarse());
      return solution;
    }

    /// A case that must give the reference's curve.
    HardCase same_curve(const std::string   &name,
                        const std::string   &about,
                        const double         scale,
                        const SolverOptions &options,
                        const double         tolerance)
    {
      return {name, about, [=] {
                const Material material = rock(.2, 30);
                const Solution solution =
                  solve_contact(material, at_load_level(material, 30, radius * scale), options);
                HardCaseRun  run        = run_of(solution);
                const double difference = curve_difference(reference(), solution);
                run.found               = "dimensionless curve within " + text(difference);
                run.holds               = difference <= tolerance;
                return run;
              }};
    }

    void add_materials(std::vector<HardCase> &cases)
    {
      for (const double level : {0.01, 1., 100., 1e4, 1e5})
        cases.push_back(scene_case(
          "load-level-" + text(level), "F_max/F_y = " + text(level), rock(.2, 30), level));
      for (const double phi : {0., 60.})
        cases.push_back(scene_case(
          "friction-angle-" + text(phi), "phi = " + text(phi) + " degrees", rock(.2, phi), 30));
      for (const double nu : {0., .49})
        cases.push_back(
          scene_case("poisson-ratio-" + text(nu), "nu = " + text(nu), rock(nu, 30), 30));
      cases.push_back(scene_case(
        "von-mises-0.499", "von Mises, nu = 0.499: hardly compressible", metal(.499), 30));

      Material rounded          = rock(.2, 30);
      rounded.flow_stress_ratio = .778;
      cases.push_back(scene_case(
        "flow-stress-ratio-0.778", "K = 0.778, where the cone is hardly convex", rounded, 100));
      Material pyramid  = rock(.2, 30);
      pyramid.criterion = Criterion::mohr_coulomb;
      cases.push_back(scene_case("mohr-coulomb-edges",
                                 "Mohr-Coulomb: on the axis two principal stresses coincide",
                                 pyramid,
                                 100));
      pyramid.tension_cutoff = 0.05 * pyramid.compressive_strength;
      cases.push_back(scene_case("mohr-coulomb-cutoff",
                                 "Mohr-Coulomb with a tension cut-off: edges, corners",
                                 pyramid,
                                 100));
      Material isochoric       = rock(.2, 40);
      isochoric.dilation_angle = Angle(0);
      cases.push_back(scene_case(
        "isochoric-10", "phi = 40, psi = 0, perfectly plastic, F_max/F_y = 10", isochoric, 10));
      isochoric.dilation_angle = Angle(20);
      cases.push_back(scene_case("half-dilation-100",
                                 "phi = 40, psi = 20, perfectly plastic, F_max/F_y = 100",
                                 isochoric,
                                 100));
    }

    /// The material's point driven through the cone's apex and back.
    HardCase apex_case()
    {
      return {
        "apex", "a point stretched through the cone's apex, sheared there, and pressed back", [] {
          const Material     material = rock(.2, 30);
          const laws::Law    law      = law_of(material);
          const auto         unit     = dealii::unit_symmetric_tensor<3>();
          const double       alpha = laws::drucker_prager_alpha(material.friction_angle.radians());
          const double       k   = laws::drucker_prager_strength(material.friction_angle.radians(),
                                                         material.compressive_strength);
          const double       tip = k / (3 * alpha) / (3 * laws::bulk_modulus(law));
          laws::StressTensor shear;
          shear[0][1] = tip;
          HardCaseRun        run;
          laws::State        state;
          laws::StressTensor strain;
          unsigned int       at_apex = 0, elsewhere = 0, back_inside = 0;
          const auto         step_to = [&](const laws::StressTensor &next) {
            strain              = next;
            const auto response = laws::evaluate(law, state, strain);
            state               = response.state;
            run.checks.yield_excess =
              std::max(run.checks.yield_excess,
                       laws::yield_excess(law, response.stress, state.hardening_variable));
            at_apex += response.branch == laws::Branch::apex;
            elsewhere += response.branch == laws::Branch::regular;
            return response;
          };
          for (unsigned int i = 1; i <= 30; ++i)
            step_to(0.1 * i * tip * unit);
          for (unsigned int i = 1; i <= 30; ++i)
            step_to(3 * tip * unit + 0.2 * i * shear);
          for (unsigned int i = 1; i <= 60; ++i)
            back_inside +=
              step_to((3 - 0.1 * i) * tip * unit + 6 * shear).branch == laws::Branch::elastic;
          run.found = text(at_apex) + " states at the apex, " + text(elsewhere) + " on the cone, " +
                      text(back_inside) + " back inside";
          run.holds = at_apex >= 10 && elsewhere >= 5 && back_inside >= 5;
          return run;
        }};
    }

    HalfSpaceModel plastic_model(const Scene &scene)
    {
      const Material material = rock(.2, 30);
      Cost           cost;
      return HalfSpaceModel(
        material,
        scene,
        coarse(),
        run_pilots(material, scene, first_yield(material, scene.radius), cost, {}).contact_radius);
    }

    HardCaseRun run_of(const HalfSpaceModel &model)
    {
      return {
        model.checks(), model.counters().newton_iterations, model.counters().cut_backs, {}, true};
    }

    void add_load_paths(std::vector<HardCase> &cases)
    {
      cases.push_back({"single-step", "from nothing to F_max/F_y = 30 in one load step", [] {
                         const Scene    scene = at_load_level(rock(.2, 30), 30);
                         HalfSpaceModel model = plastic_model(scene);
                         const double   fine  = run_cycle(model, 32).loading.back().approach;
                         const double   one   = run_cycle(model, 1).loading.back().approach;
                         HardCaseRun    run   = run_of(model);
                         run.found = "delta_max " + text(one / fine) + " of that in 32 steps";
                         run.holds = std::abs(one / fine - 1) < 0.2; // first order in the step
                         return run;
                       }});
      cases.push_back(
        {"ten-cycles", "ten cycles of load and release to F_max/F_y = 30", [] {
           const Scene    scene  = at_load_level(rock(.2, 30), 30);
           HalfSpaceModel model  = plastic_model(scene);
           const auto     cycles = run_cycles(model, 16, std::vector<double>(10, scene.force_max));
           HardCaseRun    run    = run_of(model);
           const auto     drift  = [&](const std::size_t from, const std::size_t to) {
             return std::abs(cycles[to].residual_approach() - cycles[from].residual_approach()) /
                    cycles[0].residual_approach();
           };
           const auto dissipated = [&](const std::size_t i) {
             return (cycles[i].unloading.back().dissipated_energy -
                     cycles[i - 1].unloading.back().dissipated_energy) /
                    cycles[0].unloading.back().dissipated_energy;
           };
           run.found = "delta_res moves by " + text(drift(0, 1)) + " in the second cycle, " +
                       text(drift(8, 9)) + " in the tenth; dissipation there " +
                       text(dissipated(9)) + " of the first's";
           // Shakedown: what a cycle still changes dies out.
           run.holds = drift(8, 9) < 1e-3 && drift(8, 9) <= drift(0, 1);
           return run;
         }});
      cases.push_back(
        {"higher-reload", "released from F_max/2, then loaded to F_max", [] {
           const Scene    scene  = at_load_level(rock(.2, 30), 30);
           HalfSpaceModel model  = plastic_model(scene);
           const double   virgin = run_cycle(model, 32).loading.back().approach;
           const auto     cycles = run_cycles(model, 32, {scene.force_max / 2, scene.force_max});
           HardCaseRun    run    = run_of(model);
           const double   difference = cycles[1].loading.back().approach / virgin - 1;
           run.found = "delta_max differs from the virgin one by " + text(difference);
           // both carry a load-step error of this size
           run.holds = std::abs(difference) < 5e-3;
           return run;
         }});
      cases.push_back({"near-zero-load", "F_max = 1e-12 N on a sphere of 0.1 m", [] {
                         const Material material = rock(.2, 30);
                         const Scene    scene{radius, 1e-12};
                         const Solution solution = solve_contact(material, scene, coarse());
                         HardCaseRun    run      = run_of(solution);
                         const double   ratio    = solution.curve.loading.back().approach /
                                              hertz::approach(material, radius, scene.force_max);
                         run.found = "delta_max " + text(ratio) + " of Hertz's";
                         run.holds = std::abs(ratio - 1) < 3e-3; // coarse mesh: 16 elements
                         return run;
                       }});

      Material isochoric       = rock(.2, 60);
      isochoric.dilation_angle = Angle(0);
      HardCase unreachable =
        scene_case("out-of-reach",
                   "phi = 60, psi = 0, F_max/F_y = 1000: equilibrium is lost before the peak",
                   isochoric,
                   1000);
      unreachable.error = "a stable equilibrium need not exist";
      cases.push_back(unreachable);
    }

    void add_discretisations(std::vector<HardCase> &cases)
    {
      for (const double decade : {0., 2., 4., 6., 8., 10.})
        {
          SolverOptions options     = coarse();
          options.penalty_stiffness = std::pow(10., decade);
          // Augmentation stops at a violation of 1e-6 of the approach at every stiffness.
          HardCase stiffness = same_curve("penalty-1e" + text(decade),
                                          "contact stiffness 1e" + text(decade) + " E/a",
                                          1,
                                          options,
                                          1e-6);
          if (decade == 0) // as soft as the body
            stiffness.error = "a larger penalty-stiffness helps";
          if (decade == 8) // the gap's rounding times the stiffness
            stiffness.residual_limit = 1e-7;
          if (decade == 10)
            stiffness.error = "beyond which the rounding of the gap moves the force";
          cases.push_back(stiffness);
        }
      for (const unsigned int resolution : {4u, 128u})
        {
          SolverOptions options = coarse();
          options.resolution    = resolution;
          HardCase elements =
            scene_case("elements-" + std::to_string(resolution),
                       std::to_string(resolution) + " elements across the contact",
                       rock(.2, 30),
                       30,
                       options);
          if (resolution == 4) // on so few nodes a pressure's rounding is a larger force
            elements.residual_limit = 1e-7;
          cases.push_back(elements);
        }
      SolverOptions distorted   = coarse();
      distorted.mesh_distortion = 0.25;
      // 16 elements across: the mesh's own error is 5e-3.
      cases.push_back(same_curve(
        "distorted-mesh", "vertices moved by up to a quarter of an edge", 1, distorted, 1e-2));
      // Only rounding parts these.
      cases.push_back(
        same_curve("nanometre-grain", "R = 1 nm, same F_max/F_y", 1e-8, coarse(), 1e-6));
      cases.push_back(same_curve("planet", "R = 6000 km, same F_max/F_y", 6e7, coarse(), 1e-6));
      SolverOptions si = coarse();
      si.units         = Units::si;
      cases.push_back(same_curve("planet-si", "the same, solved in SI units", 6e7, si, 1e-6));
    }
  } // namespace

  const std::vector<HardCase> &hard_cases()
  {
    static const std::vector<HardCase> all = [] {
      std::vector<HardCase> cases;
      add_materials(cases);
      cases.push_back(apex_case());
      add_load_paths(cases);
      add_discretisations(cases);
      return cases;
    }();
    return all;
  }

  HardCaseOutcome run_hard_case(const HardCase &hard_case)
  {
    const auto      start = std::chrono::steady_clock::now();
    HardCaseOutcome result;
    try
      {
        result.run             = hard_case.run();
        result.outcome         = "converged";
        const PathChecks &seen = result.run.checks;
        result.as_expected =
          hard_case.error.empty() && result.run.holds &&
          seen.residual <= hard_case.residual_limit &&
          seen.yield_excess <= hard_case_limits::yield_excess &&
          seen.penetration <= hard_case_limits::penetration &&
          seen.energy_error <= hard_case_limits::energy_error * seen.largest_work;
      }
    catch (const Error &error)
      {
        result.outcome = error.what();
        result.as_expected =
          !hard_case.error.empty() && result.outcome.find(hard_case.error) != std::string::npos;
      }
    result.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
  }
} // namespace dpcontact
