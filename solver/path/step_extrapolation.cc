#include "solver/path/step_extrapolation.h"

#include "meshing/errors.h"

#include <deal.II/lac/householder.h>

#include <algorithm>
#include <cmath>

namespace dpcontact
{
  namespace
  {
    using Points = std::vector<CurvePoint>;

    void check_levels(const Points &coarse, const Points &fine)
    {
      bool same = fine.size() == 2 * coarse.size() - 1;
      for (std::size_t i = 0; same && i < coarse.size(); ++i)
        same = std::abs(coarse[i].force - fine[2 * i].force) <=
               1e-6 * std::max(fine.front().force, fine.back().force);
      if (!same)
        throw SolverError("step extrapolation: the two paths do not share their force levels");
    }

    void require_monotone(const Points &branch, const double direction)
    {
      for (std::size_t i = 1; i < branch.size(); ++i)
        if (!(direction * (branch[i].approach - branch[i - 1].approach) > 0))
          throw StepsTooLarge(
            "step extrapolation: the extrapolated approach is not monotone; the load "
            "steps are too large");
    }

    Points extrapolate(const Points &coarse, const Points &fine, const double weight)
    {
      check_levels(coarse, fine);
      Points     result     = fine;
      const auto difference = [&](double CurvePoint::*quantity, const std::size_t i) {
        const auto at = [&](const std::size_t k) {
          return fine[2 * k].*quantity - coarse[k].*quantity;
        };
        return i % 2 == 0 ? at(i / 2) : (at(i / 2) + at(i / 2 + 1)) / 2;
      };
      for (std::size_t i = 0; i < fine.size(); ++i)
        for (double CurvePoint::*quantity : {&CurvePoint::approach, &CurvePoint::dissipated_energy})
          result[i].*quantity += weight * difference(quantity, i);
      require_monotone(result, fine.back().force > fine.front().force ? 1 : -1);
      return result;
    }

    /// The smooth part of (fine − coarse)/fine of the approach as a polynomial in ln F; constant
    /// below a share of the peak force.
    class SmoothDifference
    {
    public:
      SmoothDifference(const Points &coarse, const Points &fine)
        : peak(fine.back().force)
      {
        check_levels(coarse, fine);
        std::vector<double> positions, values;
        for (std::size_t k = 1; k < coarse.size(); ++k)
          if (coarse[k].force >= least_share * peak)
            {
              positions.push_back(position(coarse[k].force));
              values.push_back(1 - coarse[k].approach / fine[2 * k].approach);
            }
        const auto terms =
          static_cast<unsigned int>(std::min<std::size_t>(most_terms, (positions.size() + 3) / 4));
        dealii::FullMatrix<double> matrix(positions.size(), terms);
        dealii::Vector<double>     right(values.begin(), values.end()), solution(terms);
        for (unsigned int i = 0; i < positions.size(); ++i)
          for (unsigned int j = 0; j < terms; ++j)
            matrix(i, j) = std::pow(positions[i], j);
        dealii::Householder<double>(matrix).least_squares(solution, right);
        coefficients.assign(solution.begin(), solution.end());
      }

      double operator()(const double force) const
      {
        const double x     = position(std::max(force, least_share * peak));
        double       value = 0;
        for (std::size_t j = coefficients.size(); j-- > 0;)
          value = value * x + coefficients[j];
        return value;
      }

    private:
      static constexpr double      least_share = 0.03; ///< well below a path's first stop
      static constexpr std::size_t most_terms  = 5;

      /// From −1 at the least share to 1 at the peak.
      double position(const double force) const
      {
        return 1 - 2 * std::log(force / peak) / std::log(least_share);
      }

      double              peak;
      std::vector<double> coefficients;
    };

    double difference(const Points &coarse, const Points &fine)
    {
      check_levels(coarse, fine);
      const double peak    = std::max(fine.front().force, fine.back().force);
      double       largest = 0;
      for (std::size_t k = 0; k < coarse.size(); ++k)
        {
          const std::size_t i = 2 * k, low = i == 0 ? 0 : i - 1,
                            high = std::min(i + 1, fine.size() - 1);
          const double slope =
            (fine[high].force - fine[low].force) / (fine[high].approach - fine[low].approach);
          largest = std::max(largest, std::abs(slope * (fine[i].approach - coarse[k].approach)));
        }
      return largest / peak;
    }
  } // namespace

  Curve extrapolate_steps(const Curve &coarse, const Curve &fine, const double order)
  {
    const double weight = 1 / (std::pow(2., order) - 1);
    return {extrapolate(coarse.loading, fine.loading, weight),
            extrapolate(coarse.unloading, fine.unloading, weight)};
  }

  Curve extrapolate_steps_smoothly(const Curve &coarse, const Curve &fine, const double order)
  {
    const double           weight = 1 / (std::pow(2., order) - 1);
    const SmoothDifference smooth(coarse.loading, fine.loading);
    check_levels(coarse.unloading, fine.unloading);
    Curve result = fine;
    for (CurvePoint &point : result.loading)
      point.approach *= 1 + weight * smooth(point.force);

    const double at_peak = result.loading.back().approach - fine.loading.back().approach;
    const auto   change  = [&](const std::size_t k) {
      return fine.unloading[2 * k].approach - fine.unloading[0].approach -
             (coarse.unloading[k].approach - coarse.unloading[0].approach);
    };
    for (std::size_t i = 0; i < result.unloading.size(); ++i)
      result.unloading[i].approach +=
        at_peak + weight * (i % 2 == 0 ? change(i / 2) : (change(i / 2) + change(i / 2 + 1)) / 2);

    const auto energy = [&](Points &branch, const Points &before) {
      for (std::size_t i = 0; i < branch.size(); ++i)
        {
          const auto at = [&](const std::size_t k) {
            return branch[2 * k].dissipated_energy - before[k].dissipated_energy;
          };
          if (i % 2 == 1)
            branch[i].dissipated_energy += weight * (at(i / 2) + at(i / 2 + 1)) / 2;
        }
      for (std::size_t k = 0; k < before.size(); ++k)
        branch[2 * k].dissipated_energy +=
          weight * (branch[2 * k].dissipated_energy - before[k].dissipated_energy);
    };
    energy(result.loading, coarse.loading);
    energy(result.unloading, coarse.unloading);
    require_monotone(result.loading, 1);
    require_monotone(result.unloading, -1);
    return result;
  }

  double smooth_step_difference(const Curve &coarse, const Curve &fine)
  {
    const SmoothDifference smooth(coarse.loading, fine.loading);
    Curve                  corrected = coarse;
    const double at_peak = smooth(fine.loading.back().force) * fine.loading.back().approach;
    double       largest = 0;
    for (std::size_t i = 1; i < fine.loading.size(); ++i)
      {
        // the slope over several points, as single ones jump
        const CurvePoint &low = fine.loading[i < 8 ? 0 : i - 8], &high = fine.loading[i];
        largest = std::max(largest,
                           std::abs(smooth(high.force) * high.approach * (high.force - low.force) /
                                    (high.approach - low.approach)) /
                             fine.loading.back().force);
      }
    // of unloading the change since the peak
    const double offset = at_peak - (fine.unloading[0].approach - coarse.unloading[0].approach);
    for (CurvePoint &point : corrected.unloading)
      point.approach -= offset;
    return std::max(largest, difference(corrected.unloading, fine.unloading));
  }

  double step_difference(const Curve &coarse, const Curve &fine)
  {
    return std::max(difference(coarse.loading, fine.loading),
                    difference(coarse.unloading, fine.unloading));
  }
} // namespace dpcontact
