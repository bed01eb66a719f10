#include "solver/checkpoint.h"

#include "meshing/errors.h"

namespace dpcontact
{
  namespace
  {
    constexpr double CurvePoint::*const point_numbers[] = {&CurvePoint::approach,
                                                           &CurvePoint::force,
                                                           &CurvePoint::contact_radius,
                                                           &CurvePoint::pressure_max,
                                                           &CurvePoint::plastic_volume,
                                                           &CurvePoint::dissipated_energy,
                                                           &CurvePoint::plastic_strain_max,
                                                           &CurvePoint::mises_stress_max};
    constexpr std::size_t               per_point       = std::size(point_numbers) + 1;
  } // namespace

  std::vector<double> numbers_of(const std::vector<CurvePoint> &points)
  {
    std::vector<double> numbers;
    for (const CurvePoint &point : points)
      {
        for (const auto number : point_numbers)
          numbers.push_back(point.*number);
        numbers.push_back(point.newton_iterations);
      }
    return numbers;
  }

  std::vector<CurvePoint> points_of(const std::vector<double> &numbers)
  {
    if (numbers.size() % per_point != 0)
      throw InputError("a saved state has " + std::to_string(numbers.size()) +
                       " numbers of curve points, which have " + std::to_string(per_point) +
                       " each: it is not one of this version; start anew without it");
    std::vector<CurvePoint> points(numbers.size() / per_point);
    const double           *next = numbers.data();
    for (CurvePoint &point : points)
      {
        for (const auto number : point_numbers)
          point.*number = *next++;
        point.newton_iterations = static_cast<int>(*next++);
      }
    return points;
  }
} // namespace dpcontact
