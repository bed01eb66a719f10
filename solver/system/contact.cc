#include "solver/system/contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dpcontact
{
  template <int dim>
  Contact<dim>::Contact(const Discretisation<dim> &discretisation_,
                        const UndeformedGap       &undeformed_gap,
                        const double               stiffness_)
    : discretisation(discretisation_)
    , undeformed(undeformed_gap)
    , stiffness(stiffness_)
    , n_evaluated(static_cast<unsigned int>(discretisation_.surface().size()))
  {
    std::size_t n = 0;
    for (const auto &face : discretisation.surface())
      n += face.points.size();
    multipliers.assign(n, 0.);
  }

  template <int dim>
  void Contact<dim>::augment(const Unknowns &at)
  {
    unsigned int index = 0;
    for (const auto &face : discretisation.surface())
      for (const auto &point : face.points)
        {
          const double gap   = gap_at(face, point, at);
          multipliers[index] = std::max(0., multipliers[index] - stiffness * gap);
          ++index;
        }
  }

  template <int dim>
  typename Contact<dim>::NodalFields Contact<dim>::nodal_fields(const Unknowns &at) const
  {
    NodalFields  fields;
    unsigned int index = 0;
    for (const auto &face : discretisation.surface())
      for (const auto &point : face.points)
        {
          const double p = multipliers[index++] - stiffness * gap_at(face, point, at);
          fields.pressure.push_back(enabled && point.weight > 0 ? std::max(0., p) : 0.);
          fields.inward.push_back(inward(face, point, at.u));
        }
    return fields;
  }

  template <int dim>
  double Contact<dim>::work(const NodalFields &from, const NodalFields &to) const
  {
    double       sum   = 0;
    unsigned int index = 0;
    for (const auto &face : discretisation.surface())
      for (const auto &point : face.points)
        {
          sum += point.weight * (from.pressure[index] + to.pressure[index]) / 2 *
                 (to.inward[index] - from.inward[index]);
          ++index;
        }
    return sum;
  }

  template <int dim>
  bool Contact<dim>::touches_beyond(const Unknowns &at) const
  {
    if (!enabled)
      return false;
    const auto  &faces = discretisation.surface();
    unsigned int index = 0;
    for (unsigned int f = 0; f < faces.size(); ++f)
      for (const auto &point : faces[f].points)
        {
          const double gap = gap_at(faces[f], point, at);
          if (multipliers[index++] - stiffness * gap > 0 && f >= n_evaluated)
            return true;
        }
    return false;
  }

  template <int dim>
  std::vector<std::pair<double, double>> Contact<dim>::face_pressures(const Unknowns &at) const
  {
    std::vector<std::pair<double, double>> means;
    unsigned int                           index = 0;
    for (const auto &face : discretisation.surface())
      {
        double area = 0, force = 0, moment = 0;
        for (const auto &point : face.points)
          {
            const double gap = gap_at(face, point, at);
            const double p   = enabled ? std::max(0., multipliers[index] - stiffness * gap) : 0.;
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
  double Contact<dim>::edge_radius(const Unknowns &at) const
  {
    if (!enabled)
      return 0;
    double last_touching = 0;
    std::vector<std::pair<double, double>>
                 whole; // (mean radius, mean pressure) of faces that touch
    double       element = 0;
    unsigned int index   = 0;
    for (const auto &face : discretisation.surface())
      {
        double area = 0, force = 0, moment = 0, inner = face.points.front().radius, outer = inner;
        bool   touches = true;
        for (const auto &point : face.points)
          {
            const double gap = gap_at(face, point, at);
            const double p   = multipliers[index++] - stiffness * gap;
            inner            = std::min(inner, point.radius);
            outer            = std::max(outer, point.radius);
            if (point.weight <= 0)
              continue;
            area += point.weight;
            force += point.weight * p;
            moment += point.weight * point.radius;
            if (p > 0)
              last_touching = std::max(last_touching, point.radius);
            touches = touches && p > 0;
          }
        if (touches)
          whole.emplace_back(moment / area, force / area);
        if (last_touching >= inner)
          element = outer - inner;
      }
    std::sort(whole.begin(), whole.end());
    constexpr std::size_t n_faces = 4;
    if (whole.size() < 2)
      return last_touching;
    // Least squares of p² against r² over the outermost faces.
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (std::size_t i = whole.size() - std::min(n_faces, whole.size()); i < whole.size(); ++i)
      {
        const double rr = whole[i].first * whole[i].first, pp = whole[i].second * whole[i].second;
        n += 1, x += rr, y += pp, xx += rr * rr, xy += rr * pp;
      }
    const double slope = (n * xy - x * y) / (n * xx - x * x);
    const double edge  = slope < 0 ? std::sqrt((x - y / slope) / n) : last_touching + element;
    return std::clamp(edge, last_touching, last_touching + element);
  }

  template <int dim>
  double Contact<dim>::lowest(const std::vector<double> &u, const double least_weight) const
  {
    double result = std::numeric_limits<double>::infinity();
    for (const auto &face : discretisation.surface())
      for (const auto &point : face.points)
        if (point.weight >= least_weight)
          result = std::min(result, gap_without_approach(face, point, u));
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
