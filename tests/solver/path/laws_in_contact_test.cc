#include "solver/laws/law.h"
#include "tests/support/contact_problem.h"
#include "tests/support/floating_point_traps.h"
#include "tests/support/solver_environment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

// Each law on the contact problem: Newton's convergence, the tangent, and what every converged
// state must fulfil.
namespace
{
  using namespace dpcontact;
  using tests::ContactProblem;

  const auto *const traps  = tests::FloatingPointTraps::install();
  const auto *const solver = tests::SolverEnvironment::install();

  constexpr double       nu = 0.2, strength = 0.08; // yields at 1/45 of the peak
  constexpr unsigned int resolution = 8;

  double peak() { return 0.5 * ContactProblem::hertz_force(nu); }

  struct Rock
  {
    std::string name;
    Material    material;

    friend void PrintTo(const Rock &rock, std::ostream *out) { *out << rock.name; }
  };

  /// In the units of ContactProblem: E = 1, σc over E a/R.
  std::vector<Rock> rocks()
  {
    const Material    cone{1, nu, Angle(30), strength};
    std::vector<Rock> result{{"drucker_prager", cone}};
    const auto add = [&](const std::string &name, const Material &start, const auto &change) {
      Material material = start;
      change(material);
      material.check();
      result.push_back({name, material});
    };
    add("flow_stress_ratio", cone, [](Material &m) { m.flow_stress_ratio = .778; });
    add("half_dilation", cone, [&](Material &m) { m.dilation_angle = Angle(15); });
    add("isochoric", cone, [](Material &m) { m.dilation_angle = Angle(0); });
    add("rounded_half_dilation", cone, [&](Material &m) {
      m.flow_stress_ratio = .778;
      m.dilation_angle    = Angle(15);
    });
    add("hardening", cone, [](Material &m) { m.hardening = 0.1; });
    add("von_mises", {1, nu, Angle(0), strength}, [](Material &m) {
      m.criterion = Criterion::von_mises;
    });
    add("von_mises_hardening", {1, nu, Angle(0), strength}, [](Material &m) {
      m.criterion = Criterion::von_mises;
      m.hardening = 0.1;
    });
    add("mohr_coulomb", cone, [](Material &m) { m.criterion = Criterion::mohr_coulomb; });
    add("mohr_coulomb_cutoff", cone, [](Material &m) {
      m.criterion      = Criterion::mohr_coulomb;
      m.tension_cutoff = 0.1 * strength;
    });
    add("mohr_coulomb_half_dilation", cone, [&](Material &m) {
      m.criterion      = Criterion::mohr_coulomb;
      m.dilation_angle = Angle(15);
    });
    return result;
  }

  class LawInContact : public ::testing::TestWithParam<Rock>
  {};
  INSTANTIATE_TEST_SUITE_P(laws,
                           LawInContact,
                           ::testing::ValuesIn(rocks()),
                           [](const auto &param_info) { return param_info.param.name; });

  LoadPath<2>::Options options(const unsigned int steps, const bool augment)
  {
    LoadPath<2>::Options result;
    result.loading_steps = result.unloading_steps = steps;
    result.augment                                = augment;
    return result;
  }

  TEST_P(LawInContact, newton_ends_quadratically)
  {
    // Plain penalty, so that one Newton solve makes one step. r_{k+1} ≤ C r_k² once the active
    // planes, nodes and plastic points are those of the solution; while a few still change the
    // residual falls otherwise, so the last iteration of each step is judged: C reaches 30 for the
    // smooth laws; 1e-10 is what rounding leaves.
    ContactProblem problem(law_of(GetParam().material), nu, resolution);
    unsigned int   judged = 0, quadratic = 0, steps = 0;
    LoadPath<2>    path(problem.system, options(6, false), [&](const char *, double, int) {
      const auto &r = path.last_newton().residuals;
      ++steps;
      ASSERT_GE(r.size(), 2u);
      const double before = r[r.size() - 2], last = r.back();
      if (before > 1e-2)
        return; // one jump to the solution
      ++judged;
      quadratic += last <= 100 * before * before + 1e-10;
    });
    path.load(peak(), 1.);
    EXPECT_GE(judged, steps - 1);
    EXPECT_EQ(quadratic, judged);
    EXPECT_EQ(path.counters().cut_backs, 0u);
  }

  TEST_P(LawInContact, jacobian_is_the_derivative_of_the_residual)
  {
    ContactProblem problem(law_of(GetParam().material), nu, resolution, 1e3);
    auto          &system = problem.system;
    LoadPath<2>    path(system, options(6, false), {});
    path.load(peak(), 1.);
    // Into a step, off the states on the yield surface that the last one ended with.
    system.set_control(ContactSystem<2>::Control::force, 1.2 * peak(), peak());
    ASSERT_TRUE(solve_newton(system, NewtonOptions()).converged);
    std::vector<double> direction(system.unknowns().u.size());
    for (std::size_t i = 0; i < direction.size(); ++i)
      direction[i] = std::sin(1. + 1.7 * static_cast<double>(i));
    const auto          Kv   = tests::multiply(system.tangent(), direction);
    const auto          base = system.unknowns().u;
    std::vector<double> difference(Kv.size(), 0.);
    const double        h = 1e-7;
    for (const double sign : {1., -1.})
      {
        for (std::size_t i = 0; i < base.size(); ++i)
          system.unknowns().u[i] = base[i] + sign * h * direction[i];
        system.residual();
        for (std::size_t i = 0; i < base.size(); ++i)
          difference[i] += sign * system.residual_vector()[i] / (2 * h);
      }
    std::vector<double> error(Kv.size());
    for (std::size_t i = 0; i < Kv.size(); ++i)
      error[i] = difference[i] - Kv[i];
    // Central differences: second order in h/(yield strain) where no point changes its branch, and
    // the few that do are within h of it.
    EXPECT_LT(tests::norm(error), 1e-5 * tests::norm(Kv));
  }

  TEST_P(LawInContact, a_cycle_keeps_every_balance)
  {
    ContactProblem problem(law_of(GetParam().material), nu, resolution);
    LoadPath<2>    path(problem.system, options(8, true), {});
    const auto     loading   = path.load(peak(), 1.);
    const auto     unloading = path.unload();
    const auto    &checks    = path.checks();
    EXPECT_GT(loading.back().plastic_volume, 0);
    EXPECT_LT(checks.residual, 1e-8);
    EXPECT_LT(checks.yield_excess, 1e-12);
    EXPECT_LE(checks.penetration, 1e-6);
    // What Newton leaves of equilibrium, times the displacements.
    EXPECT_LT(checks.energy_error, 1e-8 * checks.largest_work);
    EXPECT_GT(checks.mean_dissipation, 0.01 * checks.largest_work);
    EXPECT_GT(checks.elastic_energy, 0) << "residual stresses";

    // Released: no force on the plate, and the residual stresses in equilibrium.
    EXPECT_EQ(problem.system.force(), 0);
    EXPECT_LT(problem.system.residual(), 1e-9);
    EXPECT_EQ(unloading.back().force, 0);
    // No tension in contact on the way.
    for (const auto &point : loading)
      EXPECT_GE(point.pressure_max, 0);
  }

  double energy_gap(const Material &material, const unsigned int steps)
  {
    ContactProblem problem(law_of(material), nu, resolution);
    LoadPath<2>    path(problem.system, options(steps, true), {});
    path.load(peak(), 1.);
    path.unload();
    return path.checks().energy_gap();
  }

  TEST_P(LawInContact, gap_of_backward_euler_falls_with_the_step)
  {
    // Σ ½Δσ:Δεᵖ: of first order where the flow is not normal to the yield surface; where it is,
    // perfect plasticity has dσ:dεᵖ = 0 and the gap falls faster.
    const Material &material = GetParam().material;
    const double    coarse = energy_gap(material, 10), middle = energy_gap(material, 20),
                 fine = energy_gap(material, 40);
    EXPECT_LT(middle, 0.62 * coarse);
    EXPECT_LT(fine, 0.55 * middle);
    if (!laws::associated(law_of(material)))
      {
        EXPECT_NEAR(fine / middle, 0.5, 0.05);
      }
  }
} // namespace
