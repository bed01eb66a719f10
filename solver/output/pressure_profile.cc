#include "solver/output/pressure_profile.h"

#include "solver/problem/unit_system.h"
#include "solver/system/contact_system.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace dpcontact
{
  namespace
  {
    /// Means over a face of the surface.
    struct Face
    {
      double radius, pressure, area;
    };

    struct TouchingFaces
    {
      std::vector<Face> faces;                ///< that touch at all of their nodes
      double            largest_pressure = 0; ///< of the mean ones, of all faces
    };

    template <int dim>
    TouchingFaces touching_faces(const ContactSystem<dim> &system)
    {
      const auto    fields = system.contact().nodal_fields(system.unknowns());
      TouchingFaces result;
      std::size_t   index = 0;
      for (const auto &face : system.discretisation().surface())
        {
          Face mean{0, 0, 0};
          bool touches = true;
          for (const auto &point : face.points)
            {
              const double p = fields.pressure[index++];
              touches        = touches && (p > 0 || point.weight <= 0);
              mean.area += point.weight;
              mean.pressure += point.weight * p;
              mean.radius += point.weight * point.radius;
            }
          mean.pressure /= mean.area;
          mean.radius /= mean.area;
          if (touches)
            result.faces.push_back(mean);
          result.largest_pressure = std::max(result.largest_pressure, mean.pressure);
        }
      return result;
    }

    using Rings = std::map<int, std::vector<Face>>;

    /// Faces by rings of one element's width, joined with the next one outwards while they hold
    /// fewer than four faces.
    Rings rings_of(const std::vector<Face> &faces)
    {
      double covered = 0;
      for (const Face &face : faces)
        covered += face.area;
      const double width = std::sqrt(covered / static_cast<double>(faces.size()));
      Rings        rings;
      for (const Face &face : faces)
        rings[static_cast<int>(face.radius / width)].push_back(face);
      constexpr std::size_t fewest = 4; // two say nothing about what differs from a straight line
      for (auto ring = rings.begin(); ring != rings.end() && std::next(ring) != rings.end();)
        if (const auto next = std::next(ring);
            ring->second.size() < fewest ||
            (std::next(next) == rings.end() && next->second.size() < fewest))
          {
            next->second.insert(next->second.end(), ring->second.begin(), ring->second.end());
            ring = rings.erase(ring);
          }
        else
          ++ring;
      return rings;
    }

    /// Adds the area of a ring's faces, and the squares of what their pressures differ by from the
    /// straight line of p² over r², weighted with it.
    void add_deviation(const std::vector<Face> &ring, double &square, double &area)
    {
      double n = 0, x = 0, y = 0, xx = 0, xy = 0;
      for (const Face &face : ring)
        {
          const double rr = face.radius * face.radius, pp = face.pressure * face.pressure;
          n += face.area, x += face.area * rr, y += face.area * pp;
          xx += face.area * rr * rr, xy += face.area * rr * pp;
        }
      const double spread = n * xx - x * x;
      const double slope  = spread > 1e-9 * n * xx ? (n * xy - x * y) / spread : 0.;
      for (const Face &face : ring)
        {
          const double pp   = (y - slope * x) / n + slope * face.radius * face.radius;
          const double left = face.pressure - std::sqrt(std::max(0., pp));
          square += face.area * left * left;
          area += face.area;
        }
    }
  } // namespace

  template <int dim>
  std::vector<PressurePoint> pressure_profile(const ContactSystem<dim> &system,
                                              const UnitSystem         &units)
  {
    std::vector<PressurePoint> result;
    for (const auto &[r, p] : system.contact().face_pressures(system.unknowns()))
      if (p > 0)
        result.push_back({r * units.length, p * units.stress});
    return result;
  }

  template <int dim>
  double axisymmetry_deviation(const ContactSystem<dim> &system)
  {
    const TouchingFaces touching = touching_faces(system);
    double              square = 0, area = 0;
    for (const auto &[position, ring] : rings_of(touching.faces))
      add_deviation(ring, square, area);
    return area > 0 ? std::sqrt(square / area) / touching.largest_pressure : 0.;
  }

  template std::vector<PressurePoint> pressure_profile(const ContactSystem<2> &,
                                                       const UnitSystem &);
  template std::vector<PressurePoint> pressure_profile(const ContactSystem<3> &,
                                                       const UnitSystem &);
  template double                     axisymmetry_deviation(const ContactSystem<2> &);
  template double                     axisymmetry_deviation(const ContactSystem<3> &);
} // namespace dpcontact
