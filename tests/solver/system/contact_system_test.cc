#include "solver/system/newton.h"
#include "tests/support/contact_problem.h"
#include "tests/support/floating_point_traps.h"
#include "tests/support/law_states.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace
{
  using namespace dpcontact;
  using tests::ContactProblem;
  using Control = ContactSystem<2>::Control;

  const auto *const traps = tests::FloatingPointTraps::install();

  constexpr double nu = 0.2, friction_angle = 30, strength = 0.08; // yields at 1/45 of the peak
  constexpr unsigned int resolution = 8;

  /// Half of Hertz's force: the plastic contact then still fits the mesh.
  double peak() { return 0.5 * ContactProblem::hertz_force(nu); }

  LoadPath<2>::Options options(const unsigned int steps, const bool augment = true)
  {
    LoadPath<2>::Options result;
    result.loading_steps   = steps;
    result.unloading_steps = (steps + 1) / 2;
    result.augment         = augment;
    return result;
  }

  /// A contact soft enough for its rounding not to hide the smallest remainders.
  constexpr double soft_penalty = 1e2;

  /// Loaded to the peak, then moved on by a fifth without iterating: out of equilibrium, in
  /// contact, and yielding beyond its history. The tangent is that of this state.
  void press_on(ContactProblem &problem)
  {
    auto       &system = problem.system;
    LoadPath<2> path(system, options(6), {});
    path.load(peak(), 1.);
    for (double &value : system.unknowns().u)
      value *= 1.2;
    system.set_control(Control::force, peak(), 1.);
    system.unknowns().approach *= 1.2;
    system.residual();
    ASSERT_TRUE(system.correction());
    ASSERT_GT(system.contact_contribution().active, 5u);
    const auto saved  = system.snapshot();
    const auto result = system.commit();
    ASSERT_GT(result.dissipation, 0.01 * result.elastic_energy) << "the state must flow";
    system.restore(saved);
  }

  struct Direction
  {
    std::vector<double> u;
    double              approach;
  };

  /// Random in every unknown, far field included, by about a tenth of its value.
  Direction random_direction(const ContactSystem<2> &system, const std::uint32_t seed)
  {
    tests::Uniform random(seed);
    Direction      direction;
    for (const double value : system.unknowns().u)
      direction.u.push_back(0.1 * value * (1 + 0.1 * random()));
    direction.approach = 0.1 * system.unknowns().approach * random();
    EXPECT_NE(direction.u[system.discretisation().far_unknown()], 0.);
    return direction;
  }

  struct Evaluation
  {
    std::vector<double> residual;
    double              force;
  };

  Evaluation at(ContactSystem<2>                 &system,
                const ContactSystem<2>::Snapshot &base,
                const Direction                  &v,
                const double                      h)
  {
    for (std::size_t i = 0; i < system.unknowns().u.size(); ++i)
      system.unknowns().u[i] = base.unknowns.u[i] + h * v.u[i];
    system.unknowns().approach = base.unknowns.approach + h * v.approach;
    system.residual();
    return {system.residual_vector(), system.force()};
  }

  /// ∂R/∂d at the present state, which is also ∂F/∂u.
  std::vector<double> approach_derivative(const ContactSystem<2> &system)
  {
    std::vector<double> unused(system.unknowns().u.size(), 0.),
      derivative(system.unknowns().u.size(), 0.);
    system.contact().evaluate(system.unknowns(),
                              unused,
                              derivative,
                              [](unsigned int, const std::vector<double> &, double) {});
    return derivative;
  }

  double dot(const std::vector<double> &a, const std::vector<double> &b)
  {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
      sum += a[i] * b[i];
    return sum;
  }

  TEST(ContactSystem, axisymmetric_plastic_contact_tangent_passes_the_taylor_test)
  {
    ContactProblem problem(nu, friction_angle, strength, resolution, soft_penalty);
    press_on(problem);
    auto        &system  = problem.system;
    const auto   base    = system.snapshot();
    const auto   r_d     = approach_derivative(system);
    const auto   v       = random_direction(system, 11);
    const auto   start   = at(system, base, v, 0);
    const double force_d = system.contact_contribution().force_stiffness;
    const auto   Kv      = tests::multiply(system.tangent(), v.u);

    // Above h = 1e-3 points begin to yield and nodes to touch, below 1e-5 rounding shows.
    double before = 0;
    for (const double h : {1e-3, 1e-4, 1e-5})
      {
        const auto          moved = at(system, base, v, h);
        std::vector<double> remainder(moved.residual);
        for (std::size_t i = 0; i < remainder.size(); ++i)
          remainder[i] -= start.residual[i] + h * (Kv[i] + r_d[i] * v.approach);
        const double size = tests::norm(remainder);
        if (before > 0)
          {
            EXPECT_NEAR(before / size, 100, 3) << "h = " << h;
          }
        else
          {
            EXPECT_GT(size, 1e-9) << "a linear response would prove nothing";
          }
        before = size;

        // The contact's force is linear until a node touches or opens.
        const double slope = dot(r_d, v.u) + force_d * v.approach;
        EXPECT_NEAR(moved.force, start.force + h * slope, 1e-12 * start.force) << "h = " << h;
      }
  }

  TEST(ContactSystem, axisymmetric_plastic_contact_jacobian_is_symmetric)
  {
    ContactProblem problem(nu, friction_angle, strength, resolution, soft_penalty);
    press_on(problem);
    auto        &system = problem.system;
    const auto   base   = system.snapshot();
    const auto   v = random_direction(system, 21), w = random_direction(system, 22);
    const double h      = 1e-4; // central differences: an error of h² of the tangent's change
    const auto   change = [&](const Direction &direction) {
      auto       above = at(system, base, direction, h);
      const auto below = at(system, base, direction, -h);
      for (std::size_t i = 0; i < above.residual.size(); ++i)
        above.residual[i] = (above.residual[i] - below.residual[i]) / (2 * h);
      above.force = (above.force - below.force) / (2 * h);
      return above;
    };
    const auto   along_v = change(v), along_w = change(w);
    const double wAv = dot(w.u, along_v.residual) + w.approach * along_v.force;
    const double vAw = dot(v.u, along_w.residual) + v.approach * along_w.force;
    EXPECT_NEAR(wAv, vAw, 1e-7 * std::abs(wAv));
  }

  TEST(ContactSystem, axisymmetric_plastic_contact_newton_ends_quadratically)
  {
    // Plain penalty, so that one Newton solve makes one step. Within the last active set
    // r_{k+1} ≤ C r_k²; C is 20 here, 1e-11 is what rounding leaves.
    ContactProblem problem(nu, friction_angle, strength, resolution);
    unsigned int   judged = 0, steps = 0;
    LoadPath<2>    path(problem.system, options(6, false), [&](const char *, double, int) {
      const auto &residuals = path.last_newton().residuals;
      ++steps;
      for (std::size_t k = 0; k + 1 < residuals.size(); ++k)
        if (residuals[k] < 1e-2 && residuals[k] > 1e-7)
          {
            ++judged;
            EXPECT_LE(residuals[k + 1], 100 * residuals[k] * residuals[k] + 1e-11)
              << "step " << steps;
          }
    });
    path.load(peak(), 1.);
    EXPECT_GE(judged, 2 * steps - 4) << "nearly every step must show its last two iterations";
    EXPECT_EQ(path.counters().cut_backs, 0u);
  }

  TEST(ContactSystem, axisymmetric_plastic_contact_lands_on_the_peak_force)
  {
    ContactProblem problem(nu, friction_angle, strength, resolution);
    LoadPath<2>    path(problem.system, options(6), {});
    const auto     points = path.load(peak(), 1.);
    EXPECT_NEAR(points.back().force / peak(), 1, 1e-9)
      << "Newton's tolerance is 1e-10, 1e-6 is asked for";
    EXPECT_GT(points.back().plastic_strain_max, 0.05);
  }

  bool same_bits(const std::vector<double> &a, const std::vector<double> &b)
  {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
  }

  TEST(ContactSystem, a_restored_state_continues_bit_for_bit)
  {
    ContactProblem problem(nu, friction_angle, strength, resolution);
    auto          &system = problem.system;
    LoadPath<2>    path(system, options(6), {});
    path.load(0.5 * peak(), 1.);
    const auto go_on = [&system] {
      system.set_control(Control::force, 0.6 * peak(), peak());
      EXPECT_TRUE(solve_newton(system, NewtonOptions()).converged);
      system.contact().augment(system.unknowns());
      system.commit();
      return system.snapshot();
    };
    const auto saved = system.snapshot();
    const auto first = go_on();

    // A wholly different path in between: deeper, augmented, committed.
    system.set_control(Control::force, 0.9 * peak(), peak());
    ASSERT_TRUE(solve_newton(system, NewtonOptions()).converged);
    system.contact().augment(system.unknowns());
    system.commit();
    ASSERT_FALSE(same_bits(system.snapshot().unknowns.u, first.unknowns.u));

    system.restore(saved);
    const auto second = go_on();
    EXPECT_TRUE(same_bits(first.unknowns.u, second.unknowns.u));
    EXPECT_EQ(first.unknowns.approach, second.unknowns.approach);
    EXPECT_TRUE(same_bits(first.multipliers, second.multipliers));
    EXPECT_TRUE(same_bits(first.points.accumulated_strain, second.points.accumulated_strain));
    for (std::size_t i = 0; i < first.points.states.size(); ++i)
      {
        ASSERT_EQ(first.points.states[i].plastic_strain, second.points.states[i].plastic_strain);
        ASSERT_EQ(first.points.states[i].hardening_variable,
                  second.points.states[i].hardening_variable);
      }
  }

  TEST(ContactSystem, reset_gives_the_virgin_state_back_bit_for_bit)
  {
    ContactProblem problem(nu, friction_angle, strength, resolution);
    const auto     run = [&problem] {
      problem.system.reset();
      LoadPath<2> path(problem.system, options(4), {});
      path.load(peak(), 1.);
      path.unload();
      return problem.system.snapshot();
    };
    const auto first = run(), second = run();
    EXPECT_TRUE(same_bits(first.unknowns.u, second.unknowns.u));
    EXPECT_TRUE(same_bits(first.points.accumulated_strain, second.points.accumulated_strain));
  }

  std::vector<CurvePoint> curve(const double penalty_stiffness, const bool augment)
  {
    ContactProblem problem(nu, friction_angle, strength, resolution, penalty_stiffness);
    LoadPath<2>    path(problem.system, options(6, augment), {});
    auto           points = path.load(peak(), 1.);
    const auto     back   = path.unload();
    points.insert(points.end(), back.begin(), back.end());
    return points;
  }

  /// Largest difference of the approach at the same forces, over the approach at the peak.
  double difference(const std::vector<CurvePoint> &a, const std::vector<CurvePoint> &b)
  {
    EXPECT_EQ(a.size(), b.size());
    double largest = 0, most = 0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
      {
        EXPECT_NEAR(a[i].force, b[i].force, 1e-8 * peak());
        largest = std::max(largest, std::abs(a[i].approach - b[i].approach));
        most    = std::max(most, a[i].approach);
      }
    return largest / most;
  }

  TEST(ContactSystem, augmentation_leaves_no_trace_of_the_penalty)
  {
    // Gaps are closed to 1e-7 of the approach.
    const auto reference = curve(1e6, true);
    for (const double stiffness : {1e4, 1e5})
      EXPECT_LT(difference(curve(stiffness, true), reference), 1e-6) << "stiffness " << stiffness;
  }

  TEST(ContactSystem, plain_penalty_errs_in_proportion_to_its_flexibility)
  {
    const auto   reference = curve(1e5, true);
    const double soft      = difference(curve(1e3, false), reference),
                 stiff     = difference(curve(1e4, false), reference);
    EXPECT_GT(soft, 1e-4) << "there must be something to measure";
    EXPECT_NEAR(soft / stiff, 10, 0.5);
  }
} // namespace
