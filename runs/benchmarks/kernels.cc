// What the parts of a curve take, by Google Benchmark. Parts of the solution are measured in one
// state: the material with Λ = 392 loaded to its peak and pressed on by 2 %, so that the points
// that have yielded flow.
#include "fitting/curve_fit.h"
#include "meshing/zoned_mesh.h"
#include "solver/laws/strengths.h"
#include "solver/parallel/environment.h"
#include "solver/path/load_path.h"
#include "solver/path/solution.h"
#include "solver/path/solve.h"
#include "solver/system/contact_system.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <vector>

namespace
{
  using namespace dpcontact;
  using laws::DruckerPrager;

  constexpr unsigned int loading_steps = 10;
  constexpr double       press         = 1.02;

  Material material() { return {10e9, 0.1, Angle(20), 5e6}; }

  /// A coarse solution: it knows the contact radius at the peak, and it has a curve to fit.
  const Solution &coarse_solution()
  {
    static const Solution solution = [] {
      SolverOptions options;
      options.resolution     = 10;
      options.step_tolerance = 0.1;
      return solve_contact(material(), Scene(), options);
    }();
    return solution;
  }

  /// In units of the contact radius a, of E a/R and of a²/R.
  DruckerPrager scaled_law()
  {
    const Material rock   = material();
    const double   nu     = rock.poisson_ratio;
    const double   stress = rock.youngs_modulus * coarse_solution().mesh_radius / Scene().radius;
    DruckerPrager  law{};
    law.xi            = 1;
    law.shear_modulus = 1 / (2 * (1 + nu));
    law.bulk_modulus  = 1 / (3 * (1 - 2 * nu));
    law.alpha         = laws::drucker_prager_alpha(rock.friction_angle.radians());
    law.strength =
      laws::drucker_prager_strength(rock.friction_angle.radians(), rock.compressive_strength) /
      stress;
    return law;
  }

  double scaled_peak_force()
  {
    const double a = coarse_solution().mesh_radius;
    return Scene().force_max * Scene().radius / (material().youngs_modulus * a * a * a);
  }

  Zones zones(const unsigned int resolution)
  {
    Zones result;
    result.resolution = resolution;
    return result;
  }

  BoussinesqField<2> far_field() { return BoussinesqField<2>(1., material().poisson_ratio); }

  struct Space
  {
    dealii::Triangulation<2>           mesh;
    std::unique_ptr<Discretisation<2>> discretisation;

    explicit Space(const unsigned int resolution)
    {
      make_zoned_mesh(zones(resolution), mesh);
      discretisation =
        std::make_unique<Discretisation<2>>(mesh, far_field(), Element::serendipity_reduced);
    }

    static const Discretisation<2> &get(const unsigned int resolution)
    {
      static std::map<unsigned int, std::unique_ptr<Space>> made;
      auto                                                 &space = made[resolution];
      if (!space)
        space = std::make_unique<Space>(resolution);
      return *space->discretisation;
    }
  };

  std::unique_ptr<ContactSystem<2>> make_system(const unsigned int resolution, const bool condensed)
  {
    return std::make_unique<ContactSystem<2>>(Space::get(resolution),
                                              std::vector<laws::Law>{scaled_law()},
                                              UndeformedGap(1., 0.),
                                              SolverOptions().penalty_stiffness,
                                              condensed ? Condensation::nested_subdomains
                                                        : Condensation::none);
  }

  struct Loaded
  {
    std::unique_ptr<ContactSystem<2>> system;
    double                            reach = 0; ///< of contact and plastic zone at the peak

    Loaded(const unsigned int resolution, const bool condensed)
      : system(make_system(resolution, condensed))
    {
      LoadPath<2>::Options options;
      options.loading_steps = loading_steps;
      LoadPath<2> path(*system, options, {});
      path.load(scaled_peak_force(), 1.);
      reach = system->reach();
      system->set_control(ContactSystem<2>::Control::force, press * scaled_peak_force(), 1.);
      for (double &value : system->unknowns().u)
        value *= press;
      system->unknowns().approach *= press;
      system->residual();
      if (system->reach() <= 1)
        throw std::logic_error("the state to be measured does not flow");
    }

    static Loaded &get(const unsigned int resolution, const bool condensed)
    {
      static std::map<std::pair<unsigned int, bool>, std::unique_ptr<Loaded>> made;
      auto &loaded = made[{resolution, condensed}];
      if (!loaded)
        loaded = std::make_unique<Loaded>(resolution, condensed);
      return *loaded;
    }
  };

  unsigned int resolution(const benchmark::State &state)
  {
    return static_cast<unsigned int>(state.range(0));
  }

  ContactSystem<2> &loaded_system(benchmark::State &state)
  {
    auto &system               = *Loaded::get(resolution(state), state.range(1) != 0).system;
    state.counters["unknowns"] = system.tangent().n();
    state.counters["dofs"]     = system.discretisation().n_free();
    return system;
  }

  // Material points.

  void material_point(benchmark::State &state, const double shear, const double volume)
  {
    // Strains over that of first yield in shear.
    const DruckerPrager law  = scaled_law();
    const double        unit = law.strength / law.shear_modulus;
    laws::StressTensor  strain;
    strain[0][1] = shear * unit;
    strain[0][0] = strain[1][1] = strain[2][2] = volume * unit;
    const laws::State virgin;
    for (auto _ : state)
      benchmark::DoNotOptimize(law.evaluate(virgin, strain));
    state.counters["branch"] = static_cast<double>(law.evaluate(virgin, strain).branch);
  }
  BENCHMARK_CAPTURE(material_point, elastic, 0.1, 0.);
  BENCHMARK_CAPTURE(material_point, regular, 2., 0.);
  BENCHMARK_CAPTURE(material_point, apex, 0.01, 20.);

  // One Newton iteration and its parts.

  void newton_iteration(benchmark::State &state)
  {
    auto &system = loaded_system(state);
    for (auto _ : state)
      {
        benchmark::DoNotOptimize(system.correction());
        benchmark::DoNotOptimize(system.residual());
      }
  }

  void residual(benchmark::State &state)
  {
    auto &system = loaded_system(state);
    for (auto _ : state)
      benchmark::DoNotOptimize(system.residual());
  }

  void assemble(benchmark::State &state)
  {
    auto &system = loaded_system(state);
    for (auto _ : state)
      benchmark::DoNotOptimize(system.tangent().value.data());
  }

  void factorise(benchmark::State &state)
  {
    const auto &matrix = loaded_system(state).tangent();
    const auto  solver = make_direct_solver(matrix);
    for (auto _ : state)
      benchmark::DoNotOptimize(solver->factorize(matrix));
  }

  void solve(benchmark::State &state)
  {
    const auto &matrix = loaded_system(state).tangent();
    const auto  solver = make_direct_solver(matrix);
    solver->factorize(matrix);
    const std::vector<double> b(matrix.n(), 1.);
    std::vector<double>       x;
    for (auto _ : state)
      {
        solver->solve(b, x);
        benchmark::DoNotOptimize(x.data());
      }
  }

  // What a curve does once.

  void mesh(benchmark::State &state)
  {
    for (auto _ : state)
      {
        dealii::Triangulation<2> triangulation;
        make_zoned_mesh(zones(resolution(state)), triangulation);
      }
  }

  void discretisation(benchmark::State &state)
  {
    dealii::Triangulation<2> triangulation;
    make_zoned_mesh(zones(resolution(state)), triangulation);
    for (auto _ : state)
      {
        Discretisation<2> space(triangulation, far_field(), Element::serendipity_reduced);
        benchmark::DoNotOptimize(space.n_free());
      }
  }

  /// Elastic stiffness of every cell, and the smallest core or the whole body.
  void system(benchmark::State &state)
  {
    Space::get(resolution(state));
    for (auto _ : state)
      benchmark::DoNotOptimize(
        make_system(resolution(state), state.range(1) != 0)->unknowns().u.data());
  }

  /// All further cores up to the one in use at the peak: patterns, condensation, symbolic analysis.
  void cores(benchmark::State &state)
  {
    const double reach = Loaded::get(resolution(state), true).reach;
    for (auto _ : state)
      {
        state.PauseTiming();
        auto fresh = make_system(resolution(state), true);
        state.ResumeTiming();
        for (double distance = reach / 100; distance < reach; distance *= 1.1)
          fresh->cover(distance);
        fresh->cover(reach);
        state.PauseTiming();
        fresh.reset();
        state.ResumeTiming();
      }
  }

  /// Both branches with standard errors and the rival forms.
  void fit(benchmark::State &state)
  {
    const Solution &solution = coarse_solution();
    for (auto _ : state)
      benchmark::DoNotOptimize(
        fit_curve(solution.curve, solution.yield.force, solution.yield.approach).residual_approach);
  }

  void meshes(benchmark::internal::Benchmark *b)
  {
    b->ArgName("resolution")->Arg(20)->Arg(40)->Arg(80)->Unit(benchmark::kMillisecond);
  }

  void bodies(benchmark::internal::Benchmark *b)
  {
    b->ArgNames({"resolution", "condensed"})->ArgsProduct({{20, 40, 80}, {1, 0}});
    b->Unit(benchmark::kMillisecond);
  }

  BENCHMARK(newton_iteration)->Apply(bodies);
  BENCHMARK(residual)->Apply(bodies);
  BENCHMARK(assemble)->Apply(bodies);
  BENCHMARK(factorise)->Apply(bodies);
  BENCHMARK(solve)->Apply(bodies);
  BENCHMARK(mesh)->Apply(meshes);
  BENCHMARK(discretisation)->Apply(meshes);
  BENCHMARK(system)->Apply(bodies);
  BENCHMARK(cores)->Apply(meshes);
  BENCHMARK(fit)->Unit(benchmark::kMillisecond);
} // namespace

int main(int argc, char **argv)
{
  const dpcontact::Environment environment;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
