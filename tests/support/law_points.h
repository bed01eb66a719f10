#ifndef DPCONTACT_TESTS_SUPPORT_LAW_POINTS_H
#define DPCONTACT_TESTS_SUPPORT_LAW_POINTS_H

#include "solver/laws/point.h"
#include "tests/support/law_states.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

// Random material points of any law. A Law has evaluate(State, strain) and shear_modulus.
namespace dpcontact::tests
{
  using laws::Branch;
  using laws::Response;
  using laws::State;
  using laws::Tangent;

  template <typename Law>
  struct LawCase
  {
    std::string name;
    Law         law;
    double      yield_stress; ///< any stress of the yield surface's size; sets the strains' size
  };

  constexpr double unit_roundoff = std::numeric_limits<double>::epsilon();

  class Rotation
  {
  public:
    /// A proper rotation from a random unit quaternion.
    explicit Rotation(Uniform &uniform)
    {
      double q[4], norm = 0;
      do
        {
          norm = 0;
          for (double &component : q)
            {
              component = uniform();
              norm += component * component;
            }
        }
      while (norm < 0.01);
      for (double &component : q)
        component /= std::sqrt(norm);
      const auto [w, x, y, z]  = q;
      const double entry[3][3] = {
        {1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
        {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
        {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          Q[i][j] = entry[i][j];
    }

    StressTensor operator()(const StressTensor &t) const
    {
      double full[3][3];
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          full[i][j] = t[i][j];
      StressTensor result;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = i; j < 3; ++j)
          {
            double sum = 0;
            for (unsigned int a = 0; a < 3; ++a)
              for (unsigned int b = 0; b < 3; ++b)
                sum += Q[i][a] * full[a][b] * Q[j][b];
            result[i][j] = sum;
          }
      return result;
    }

  private:
    double Q[3][3];
  };

  /// 10 to a power uniform in [lower, upper]
  inline double log_uniform(Uniform &uniform, const double lower, const double upper)
  {
    return std::pow(10., lower + (upper - lower) * (uniform() + 1) / 2);
  }

  /// Random strains of the given size: general ones, ones with two principal values equal exactly
  /// (as on an axis of symmetry), equal up to the rounding of a rotation, or nearly equal, and
  /// hydrostatic tension with a small deviator.
  inline StressTensor random_strain(Uniform &uniform, const double size)
  {
    const unsigned int kind = static_cast<unsigned int>(5.999 * (uniform() + 1) / 2);
    const double       a = uniform(), b = uniform();
    StressTensor       t;
    switch (kind)
      {
        case 0:
          t = uniform.tensor(1);
          break;
        case 1:
          t = uniform.tensor(1) + 1.5 * a * dealii::unit_symmetric_tensor<3>();
          break;
        case 2:
          t = diagonal(a, a, b);
          if (uniform() > 0)
            std::swap(t[0][0], t[2][2]);
          break;
        case 3:
          t = Rotation(uniform)(diagonal(a, a, b));
          break;
        case 4:
          t = Rotation(uniform)(diagonal(a, a + log_uniform(uniform, -15, 0), b));
          break;
        default:
          t = diagonal(1, 1, 1) + uniform.tensor(log_uniform(uniform, -8, 0));
      }
    const double norm = t.norm();
    return norm > 0 ? size / norm * t : t;
  }

  template <typename Law>
  struct RandomPoint
  {
    State        old_state;
    StressTensor strain;

    /// Elastic strains from below the yield strain to a hundred times it.
    RandomPoint(const LawCase<Law> &a_case, Uniform &uniform)
    {
      const double yield_strain = a_case.yield_stress / (2 * a_case.law.shear_modulus);
      if (uniform() > 0)
        {
          old_state.plastic_strain     = uniform.tensor(3 * yield_strain);
          old_state.hardening_variable = yield_strain * (uniform() + 1);
        }
      strain = old_state.plastic_strain +
               random_strain(uniform, yield_strain * log_uniform(uniform, -0.5, 2));
    }
  };

  /// Visits random points, the cases in turn: visit(case, old state, strain, response, uniform).
  template <typename Law, typename Visitor>
  void for_random_points(const std::vector<LawCase<Law>> &cases,
                         const unsigned int               points,
                         const std::uint32_t              seed,
                         Visitor                        &&visit)
  {
    Uniform uniform(seed);
    for (unsigned int i = 0; i < points; ++i)
      {
        const auto            &a_case = cases[i % cases.size()];
        const RandomPoint<Law> point(a_case, uniform);
        visit(a_case,
              point.old_state,
              point.strain,
              a_case.law.evaluate(point.old_state, point.strain),
              uniform);
        if (::testing::Test::HasFailure())
          {
            ADD_FAILURE() << "point " << i << " of case " << a_case.name << ", strain "
                          << point.strain << ", plastic strain " << point.old_state.plastic_strain;
            return;
          }
      }
  }
} // namespace dpcontact::tests

#endif
