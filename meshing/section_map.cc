#include "meshing/section_map.h"

#include <algorithm>
#include <cmath>

namespace dpcontact
{
  namespace
  {
    /// (cos θ, sin θ), the cosine of a right angle exactly 0.
    dealii::Tensor<1, 2> direction(const double theta)
    {
      const double         cosine = std::cos(theta);
      dealii::Tensor<1, 2> result;
      result[0] = std::abs(cosine) < 1e-15 ? 0. : cosine;
      result[1] = std::sin(theta);
      return result;
    }
  } // namespace

  dealii::Point<2> SectionMap::operator()(const double a, const double b) const
  {
    const dealii::Tensor<1, 2> to_a = direction(0), to_b = direction(angle),
                               to_corner = corner_distance * direction(corner_angle);
    const double rho                     = std::max(a, b);
    if (rho <= kite_radius)
      {
        const double u = a / kite_radius, v = b / kite_radius;
        return dealii::Point<2>(kite_radius *
                                (u * (1 - v) * to_a + v * (1 - u) * to_b + u * v * to_corner));
      }
    const double t      = std::min(a, b) / rho;
    const bool   a_side = a >= b;
    const double theta  = a_side ? corner_angle * t : angle - (angle - corner_angle) * t;
    const dealii::Tensor<1, 2> circle = direction(theta);
    if (rho >= circle_radius)
      return dealii::Point<2>(rho * circle);
    const dealii::Tensor<1, 2> kite =
      kite_radius * ((1 - t) * (a_side ? to_a : to_b) + t * to_corner);
    const double share = (rho - kite_radius) / (circle_radius - kite_radius);
    return dealii::Point<2>((1 - share) * kite + share * circle_radius * circle);
  }
} // namespace dpcontact
