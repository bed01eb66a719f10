#ifndef DPCONTACT_TESTS_SUPPORT_LAW_CHECKS_H
#define DPCONTACT_TESTS_SUPPORT_LAW_CHECKS_H

#include "tests/support/law_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

// What every law must fulfil, at random states. A Law has evaluate(State, strain),
// yield_function(stress, hardening_variable), shear_modulus, bulk_modulus and associated().
namespace dpcontact::tests
{
  /// How often each branch and each boundary between two branches was checked.
  struct Tally
  {
    std::map<Branch, unsigned int>                    branches;
    std::map<std::pair<Branch, Branch>, unsigned int> boundaries; ///< lower branch first
    unsigned int unresolved = 0; ///< states where finite differences have too few digits

    static std::pair<Branch, Branch> pair(const Branch a, const Branch b)
    {
      return {std::min(a, b), std::max(a, b)};
    }
  };

  inline void
  expect_branches(const Tally &tally, const std::set<Branch> &expected, const unsigned int at_least)
  {
    for (const Branch branch : expected)
      {
        const auto found = tally.branches.find(branch);
        EXPECT_GE(found == tally.branches.end() ? 0 : found->second, at_least)
          << "branch " << static_cast<int>(branch);
      }
    for (const auto &[branch, count] : tally.branches)
      EXPECT_TRUE(expected.count(branch)) << "branch " << static_cast<int>(branch);
  }

  inline void expect_boundaries(const Tally                               &tally,
                                const std::set<std::pair<Branch, Branch>> &expected,
                                const unsigned int                         at_least)
  {
    for (const auto &[a, b] : expected)
      {
        const auto found = tally.boundaries.find(Tally::pair(a, b));
        EXPECT_GE(found == tally.boundaries.end() ? 0 : found->second, at_least)
          << "boundary " << static_cast<int>(a) << '-' << static_cast<int>(b);
      }
  }

  template <typename Law>
  StressTensor hooke(const Law &law, const StressTensor &strain)
  {
    return 2 * law.shear_modulus * dealii::deviator(strain) +
           law.bulk_modulus * dealii::trace(strain) * dealii::unit_symmetric_tensor<3>();
  }

  /// Norm of the elastic stiffness on unit strains
  template <typename Law>
  double stiffness(const Law &law)
  {
    return std::max(2 * law.shear_modulus, 3 * law.bulk_modulus);
  }

  /// A stress of which one rounding of the strains (total and plastic) changes the trial stress.
  template <typename Law>
  double rounding_of_stress(const Law &law, const State &old_state, const StressTensor &strain)
  {
    return unit_roundoff * stiffness(law) * (strain.norm() + old_state.plastic_strain.norm());
  }

  /// On the surface if it flowed, inside and unchanged if not; stress = C : (ε − εᵖ).
  template <typename Law>
  Tally check_returns(const std::vector<LawCase<Law>> &cases,
                      const unsigned int               points,
                      const std::uint32_t              seed)
  {
    Tally tally;
    for_random_points(
      cases,
      points,
      seed,
      [&tally](const auto &a_case, const auto &old, const auto &strain, const auto &r, auto &) {
        const Law &law = a_case.law;
        ++tally.branches[r.branch];
        // some twenty operations, each with one rounding of trial stress or strength
        const double tolerance =
          20 * (rounding_of_stress(law, old, strain) + unit_roundoff * a_case.yield_stress);
        const double f = law.yield_function(r.stress, r.state.hardening_variable);
        if (r.branch == Branch::elastic)
          {
            EXPECT_LE(f, tolerance);
            EXPECT_EQ((r.state.plastic_strain - old.plastic_strain).norm(), 0);
            EXPECT_EQ(r.state.hardening_variable, old.hardening_variable);
          }
        else
          {
            EXPECT_NEAR(f, 0, tolerance);
            EXPECT_GT(
              law.yield_function(hooke(law, strain - old.plastic_strain), old.hardening_variable),
              -tolerance);
          }
        EXPECT_LE((r.stress - hooke(law, strain - r.state.plastic_strain)).norm(), tolerance);
      });
    return tally;
  }

  /// Compares D:e with central differences of the stress over the six unit directions e. The
  /// tolerance is measured: truncation is a third of the change from step h to h/2 (error ∝ h²,
  /// taken three times as large), and rounding is that of the stress over h. Steps are tried from
  /// the smallest on until this leaves less than 1e-4 of the stiffness 2G.
  /// Returns whether there was such a step with the whole stencil on one branch.
  template <typename Law>
  bool check_tangent(const Law          &law,
                     const State        &old_state,
                     const StressTensor &strain,
                     const Response     &response)
  {
    const double size       = (strain - old_state.plastic_strain).norm();
    const double resolution = 1e-4 * 2 * law.shear_modulus;
    for (const double step : {1e-8, 1e-7, 1e-6, 1e-5, 1e-4})
      {
        const double h = step * size;
        // The strain itself is rounded; five roundings of the stress in either value.
        const double rounding = 10 * rounding_of_stress(law, old_state, strain) / h;
        if (rounding > resolution / 4 || h == 0)
          continue;
        double error[6], tolerance[6];
        for (unsigned int i = 0; i < 6; ++i)
          {
            StressTensor e;
            e.access_raw_entry(i) = 1;
            StressTensor difference[2];
            for (unsigned int k = 0; k < 2; ++k)
              {
                const double hk    = k == 0 ? h : h / 2;
                const auto   plus  = law.evaluate(old_state, strain + hk * e);
                const auto   minus = law.evaluate(old_state, strain - hk * e);
                if (plus.branch != response.branch || minus.branch != response.branch)
                  return false; // larger steps are no better
                difference[k] = (plus.stress - minus.stress) / (2 * hk);
              }
            error[i]     = (response.tangent * e - difference[1]).norm();
            tolerance[i] = (difference[0] - difference[1]).norm() + 3 * rounding;
          }
        if (*std::max_element(tolerance, tolerance + 6) > resolution)
          continue;
        for (unsigned int i = 0; i < 6; ++i)
          EXPECT_LE(error[i], tolerance[i]) << "branch " << static_cast<int>(response.branch)
                                            << " direction " << i << " step " << step;
        return true;
      }
    return false;
  }

  template <typename Law>
  Tally check_tangents(const std::vector<LawCase<Law>> &cases,
                       const unsigned int               points,
                       const std::uint32_t              seed)
  {
    Tally tally;
    for_random_points(
      cases,
      points,
      seed,
      [&tally](const auto &a_case, const auto &old, const auto &strain, const auto &r, auto &) {
        if (check_tangent(a_case.law, old, strain, r))
          ++tally.branches[r.branch];
        else
          ++tally.unresolved;
      });
    return tally;
  }

  /// Finds boundaries between two branches by bisection between random strains. Across one the
  /// stress is continuous; beside it, nearer and nearer, the tangent is the derivative. The
  /// tangents, which cost most, are compared beside the first so many boundaries of each kind.
  template <typename Law>
  Tally check_boundaries(const std::vector<LawCase<Law>> &cases,
                         const unsigned int               pairs,
                         const std::uint32_t              seed,
                         const unsigned int               tangents_of_each_kind)
  {
    Tally tally;
    for_random_points(
      cases,
      pairs,
      seed,
      [&tally, tangents_of_each_kind](
        const auto &a_case, const auto &old, const auto &strain, const auto &r, auto &uniform) {
        const Law         &law  = a_case.law;
        const double       size = (strain - old.plastic_strain).norm();
        const StressTensor end =
          old.plastic_strain + random_strain(uniform, size * log_uniform(uniform, -0.5, 0.5));
        double     lower = 0, upper = 1;
        const auto at       = [&](const double t) { return (1 - t) * strain + t * end; };
        Response   at_lower = r;
        Response   at_upper = law.evaluate(old, end);
        if (at_lower.branch == at_upper.branch)
          return;
        while (upper - lower > 4 * unit_roundoff)
          {
            const double middle    = (lower + upper) / 2;
            Response     at_middle = law.evaluate(old, at(middle));
            if (at_middle.branch == at_lower.branch)
              {
                lower    = middle;
                at_lower = at_middle;
              }
            else
              {
                upper    = middle;
                at_upper = at_middle;
              }
          }
        const double length = (end - strain).norm();
        const double slope =
          std::max({stiffness(law), at_lower.tangent.norm(), at_upper.tangent.norm()});
        EXPECT_LE((at_upper.stress - at_lower.stress).norm(),
                  slope * (upper - lower) * length +
                    40 * slope * unit_roundoff *
                      (strain.norm() + end.norm() + old.plastic_strain.norm()))
          << "branches " << static_cast<int>(at_lower.branch) << ' '
          << static_cast<int>(at_upper.branch);
        auto &compared_before = tally.boundaries[Tally::pair(at_lower.branch, at_upper.branch)];
        if (compared_before >= tangents_of_each_kind)
          return;

        bool compared[2] = {false, false};
        for (const double distance : {1e-3, 1e-5, 1e-7})
          for (const int side : {-1, 1})
            {
              const double t = side < 0 ? lower - distance : upper + distance;
              if (t < 0 || t > 1)
                continue;
              const auto beside = law.evaluate(old, at(t));
              if (beside.branch != (side < 0 ? at_lower : at_upper).branch)
                continue;
              if (check_tangent(law, old, at(t), beside))
                compared[side > 0] = true;
            }
        if (compared[0] && compared[1])
          ++compared_before;
        else
          ++tally.unresolved;
      });
    return tally;
  }

  /// Turning the strains turns stress, plastic strain and tangent.
  template <typename Law>
  Tally check_frame_invariance(const std::vector<LawCase<Law>> &cases,
                               const unsigned int               points,
                               const std::uint32_t              seed)
  {
    Tally tally;
    for_random_points(
      cases,
      points,
      seed,
      [&tally](
        const auto &a_case, const auto &old, const auto &strain, const auto &r, auto &uniform) {
        const Law     &law = a_case.law;
        const Rotation rotate(uniform);
        State          turned_state = old;
        turned_state.plastic_strain = rotate(old.plastic_strain);
        const StressTensor turned   = rotate(strain);
        const Response     s        = law.evaluate(turned_state, turned);
        const double       slope    = std::max(stiffness(law), r.tangent.norm());
        // a rotation is some thirty operations
        const double strain_rounding =
          30 * unit_roundoff * (strain.norm() + old.plastic_strain.norm());
        EXPECT_LE((s.stress - rotate(r.stress)).norm(),
                  slope * strain_rounding + 30 * unit_roundoff * r.stress.norm());

        // The tangent's own sensitivity to roundings of the strain, as measured.
        double sensitivity = 0;
        for (unsigned int i = 0; i < 4; ++i)
          {
            const auto near = law.evaluate(old, strain + uniform.tensor(strain_rounding));
            if (near.branch != r.branch)
              return;
            sensitivity = std::max(sensitivity, (near.tangent - r.tangent).norm());
          }
        const double tolerance = 1e-12 * stiffness(law) + 4 * sensitivity;
        if (s.branch != r.branch || tolerance > 1e-4 * 2 * law.shear_modulus)
          {
            ++tally.unresolved;
            return;
          }
        ++tally.branches[r.branch];
        const StressTensor direction = uniform.tensor(1);
        EXPECT_LE((s.tangent * rotate(direction) - rotate(r.tangent * direction)).norm(),
                  tolerance * direction.norm());
      });
    return tally;
  }

  /// σ:Δεᵖ ≥ 0 and, where the flow is associated, σ:Δεᵖ ≥ τ:Δεᵖ for every admissible τ. With
  /// Hooke's law this is at once that the associated return is the closest point of the surface
  /// in the energy norm.
  template <typename Law>
  Tally check_dissipation(const std::vector<LawCase<Law>> &cases,
                          const unsigned int               points,
                          const std::uint32_t              seed)
  {
    Tally tally;
    for_random_points(
      cases,
      points,
      seed,
      [&tally](
        const auto &a_case, const auto &old, const auto &strain, const auto &r, auto &uniform) {
        const Law         &law  = a_case.law;
        const StressTensor flow = r.state.plastic_strain - old.plastic_strain;
        // rounding of the stress and of the flow
        const double rounding = 20 * rounding_of_stress(law, old, strain);
        const double tolerance =
          rounding * flow.norm() + r.stress.norm() * rounding / stiffness(law);
        EXPECT_GE(r.stress * flow, -tolerance);
        ++tally.branches[r.branch];
        if (r.branch == Branch::elastic || !law.associated())
          return;
        const double hv = r.state.hardening_variable;
        for (unsigned int i = 0; i < 10; ++i)
          {
            StressTensor tau =
              r.stress + uniform.tensor(a_case.yield_stress * log_uniform(uniform, -4, 1));
            // every other one brought back to the surface
            if (i % 2 == 0)
              {
                State state;
                state.hardening_variable = hv;
                tau                      = law
                        .evaluate(state,
                                  dealii::deviator(tau) / (2 * law.shear_modulus) +
                                    dealii::trace(tau) / (9 * law.bulk_modulus) *
                                      dealii::unit_symmetric_tensor<3>())
                        .stress;
              }
            const double roundings = 20 * unit_roundoff * (tau.norm() + r.stress.norm());
            if (law.yield_function(tau, hv) <= roundings)
              {
                EXPECT_GE((r.stress - tau) * flow,
                          -tolerance - (roundings + tau.norm() * 20 * unit_roundoff) * flow.norm() -
                            tau.norm() * rounding / stiffness(law))
                  << "branch " << static_cast<int>(r.branch) << " tau " << tau;
              }
          }
      });
    return tally;
  }

  /// Major symmetry to the last bit where the flow is associated, and else its absence somewhere.
  template <typename Law>
  void check_major_symmetry(const std::vector<LawCase<Law>> &cases,
                            const unsigned int               points,
                            const std::uint32_t              seed)
  {
    bool         all_associated = true;
    unsigned int asymmetric     = 0;
    for (const auto &a_case : cases)
      all_associated = all_associated && a_case.law.associated();
    for_random_points(
      cases,
      points,
      seed,
      [&asymmetric](const auto &a_case, const auto &, const auto &, const auto &r, auto &) {
        const double *const D          = r.tangent.begin_raw();
        double              difference = 0;
        for (unsigned int i = 0; i < 6; ++i)
          for (unsigned int j = 0; j < i; ++j)
            difference = std::max(difference, std::abs(D[6 * i + j] - D[6 * j + i]));
        if (a_case.law.associated())
          EXPECT_EQ(difference, 0);
        else if (difference > 1e-3 * a_case.law.shear_modulus)
          ++asymmetric;
      });
    if (!all_associated)
      {
        EXPECT_GT(asymmetric, points / 100);
      }
  }
} // namespace dpcontact::tests

#endif
