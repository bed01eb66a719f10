#include "solver/system/checkpoint.h"

#include "meshing/errors.h"

#include <type_traits>
#include <variant>

namespace dpcontact
{
  namespace
  {
    /// Calls `visit` with every number of a point: first the real ones, then the counts.
    template <class Point, class Visit>
    void visit_numbers(Point &point, const Visit &visit)
    {
      for (const CurveQuantity &quantity : curve_quantities())
        if (const auto *const member = std::get_if<double CurvePoint::*>(&quantity.member))
          visit(point.**member);
      for (const CurveQuantity &quantity : curve_quantities())
        if (const auto *const member = std::get_if<int CurvePoint::*>(&quantity.member))
          visit(point.**member);
    }
  } // namespace

  std::vector<double> numbers_of(const std::vector<CurvePoint> &points)
  {
    std::vector<double> numbers;
    for (const CurvePoint &point : points)
      visit_numbers(
        point, [&numbers](const auto number) { numbers.push_back(static_cast<double>(number)); });
    return numbers;
  }

  std::vector<CurvePoint> points_of(const std::vector<double> &numbers)
  {
    const std::size_t per_point = curve_quantities().size();
    if (numbers.size() % per_point != 0)
      throw InputError("a saved state has " + std::to_string(numbers.size()) +
                       " numbers of curve points, which have " + std::to_string(per_point) +
                       " each: it is not one of this version; start anew without it");
    std::vector<CurvePoint> points(numbers.size() / per_point);
    const double           *next = numbers.data();
    for (CurvePoint &point : points)
      visit_numbers(point, [&next](auto &number) {
        number = static_cast<std::decay_t<decltype(number)>>(*next++);
      });
    return points;
  }
} // namespace dpcontact
