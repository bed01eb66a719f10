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
    std::vector<std::pair<double, double>> means;
    unsigned int                           index = 0;
    for (const auto &face : discretization.surface())
      {
        double area = 0, force = 0, moment = 0;
        for (const auto &point : face.points)
          {
            const double gap = point.radius * point.radius / (2 * sphere_radius) +
                               inward(face, point, u) - approach;
            const double p = enabled ? std::max(0., multipliers[index] - stiffness * gap) : 0.;
            ++index;
            area += point.weight;
            force += point.weight * p;
            moment += point.weight * point.radius;
          }
        means.emplace_back(moment / area, force / area);
      }
    std::sort(means.begin(), means.end());
    return means;
  }

  template <int dim>
  double Contact<dim>::edge_radius(const std::vector<double> &u, const double approach) const
  {
    if (!enabled)
      return 0;
    double                                 last_touching = 0;
    std::vector<std::pair<double, double>> open; // (radius, gap)
    unsigned int                           index = 0;
    for (const auto &face : discretization.surface())
      for (const auto &point : face.points)
        {
          const double gap = point.radius * point.radius / (2 * sphere_radius) +
                             inward(face, point, u) - approach;
          if (multipliers[index++] - stiffness * gap > 0)
            last_touching = std::max(last_touching, point.radius);
          else
            open.emplace_back(point.radius, std::max(0., gap));
        }
    if (last_touching == 0)
      return 0;
    std::sort(open.begin(), open.end());
    auto first = std::find_if(open.begin(), open.end(), [last_touching](const auto &node) {
      return node.first > last_touching * (1 + 1e-9);
    });
    const auto second = std::find_if(first, open.end(), [first](const auto &node) {
      return node.first > first->first * (1 + 1e-9);
    });
    if (second == open.end())
      return last_touching;
    const double g1 = std::pow(first->second, 2. / 3), g2 = std::pow(second->second, 2. / 3);
    if (!(g2 > g1))
      return last_touching;
    return std::clamp(first->first - g1 * (second->first - first->first) / (g2 - g1),
                      last_touching,
                      first->first);
  }

  template <int dim>
  double Contact<dim>::lowest(const std::vector<double> &u, const double least_weight) const
  {
    double result = std::numeric_limits<double>::infinity();
    for (const auto &face : discretization.surface())
      for (const auto &point : face.points)
        if (point.weight >= least_weight)
          result = std::min(result,
                            point.radius * point.radius / (2 * sphere_radius) +
                              inward(face, point, u));
    return result;
  }

  template <int dim>
  double Contact<dim>::touching_approach(const std::vector<double> &u) const
  {
    return lowest(u, 0.);
  }

  template <int dim>
  double Contact<dim>::bearing_approach(const std::vector<double> &u) const
  {
    return lowest(u, std::numeric_limits<double>::min());
  }

  template class Contact<2>;
  template class Contact<3>;
} // namespace dpcontact
