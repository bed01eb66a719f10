#include "solver/step_extrapolation.h"

#include "meshing/errors.h"

#include <algorithm>
#include <cmath>

namespace dpcontact
{
  namespace
  {
    using Branch = std::vector<CurvePoint>;

    void check_levels(const Branch &coarse, const Branch &fine)
    {
      bool same = fine.size() == 2 * coarse.size() - 1;
      for (std::size_t i = 0; same && i < coarse.size(); ++i)
        same = std::abs(coarse[i].force - fine[2 * i].force) <=
               1e-6 * std::max(fine.front().force, fine.back().force);
      if (!same)
        throw SolverError("step extrapolation: the two paths do not share their force levels");
    }

    Branch extrapolate(const Branch &coarse, const Branch &fine, const double weight)
    {
      check_levels(coarse, fine);
      Branch     result     = fine;
      const auto difference = [&](double CurvePoint::*quantity, const std::size_t i) {
        const auto at = [&](const std::size_t k) {
          return fine[2 * k].*quantity - coarse[k].*quantity;
        };
        return i % 2 == 0 ? at(i / 2) : (at(i / 2) + at(i / 2 + 1)) / 2;
      };
      for (std::size_t i = 0; i < fine.size(); ++i)
        for (double CurvePoint::*quantity : {&CurvePoint::approach, &CurvePoint::dissipated_energy})
          result[i].*quantity += weight * difference(quantity, i);
      const double direction = fine.back().force > fine.front().force ? 1 : -1;
      for (std::size_t i = 1; i < result.size(); ++i)
        if (!(direction * (result[i].approach - result[i - 1].approach) > 0))
          throw StepsTooLarge(
            "step extrapolation: the extrapolated approach is not monotone; the load "
            "steps are too large");
      return result;
    }

    double difference(const Branch &coarse, const Branch &fine)
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

  double step_difference(const Curve &coarse, const Curve &fine)
  {
    return std::max(difference(coarse.loading, fine.loading),
                    difference(coarse.unloading, fine.unloading));
  }
} // namespace dpcontact
