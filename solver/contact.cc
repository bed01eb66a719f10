#include "solver/contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dpcontact
{
  template <int dim>
  Contact<dim>::Contact(const Discretization<dim> &discretization_,
                        const double               radius,
                        const double               stiffness_)
    : discretization(discretization_)
    , sphere_radius(radius)
    , stiffness(stiffness_)
  {
    std::size_t n = 0;
    for (const auto &face : discretization.surface())
      n += face.points.size();
    multipliers.assign(n, 0.);
  }

  template <int dim>
  double Contact<dim>::augment(const std::vector<double> &u, const double approach)
  {
    double       violation = 0;
    unsigned int index     = 0;
    for (const auto &face : discretization.surface())
      for (const auto &point : face.points)
        {
          const double gap = point.radius * point.radius / (2 * sphere_radius) +
                             inward(face, point, u) - approach;
          double &multiplier = multipliers[index++];
          const double p     = std::max(0., multiplier - stiffness * gap);
          if (p > 0 || multiplier > 0)
            violation = std::max(violation, std::abs(p > 0 ? gap : multiplier / stiffness));
          multiplier = p;
        }
    return violation;
  }

  template <int dim>
  std::vector<std::pair<double, double>> Contact<dim>::profile(const std::vector<double> &u,
                                                               const double approach) const
  {
    std::vector<std::pair<double, double>> points;
    unsigned int                           index = 0;
    for (const auto &face : discretization.surface())
      for (const auto &point : face.points)
        {
          const double gap = point.radius * point.radius / (2 * sphere_radius) +
                             inward(face, point, u) - approach;
          points.emplace_back(point.radius,
                              enabled ? std::max(0., multipliers[index] - stiffness * gap) : 0.);
          ++index;
        }
    std::sort(points.begin(), points.end());
    return points;
  }

  template <int dim>
  double Contact<dim>::touching_approach(const std::vector<double> &u) const
  {
    double lowest = std::numeric_limits<double>::infinity();
    for (const auto &face : discretization.surface())
      for (const auto &point : face.points)
        lowest = std::min(lowest,
                          point.radius * point.radius / (2 * sphere_radius) +
                            inward(face, point, u));
    return lowest;
  }

  template class Contact<2>;
  template class Contact<3>;
} // namespace dpcontact
