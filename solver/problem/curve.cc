#include "solver/problem/curve.h"

#include <iterator>
#include <tuple>

namespace dpcontact
{
  namespace
  {
    using P = CurvePoint;
    using M = CurveMeasure;

    constexpr CurveQuantity list[] = {
      {"approach", "m", "mutual approach", M::approach, &P::approach},
      {"force", "N", "normal force", M::force, &P::force},
      {"contact_radius",
       "m",
       "where the extrapolated pressure vanishes",
       M::length,
       &P::contact_radius},
      {"pressure_max", "Pa", "largest contact pressure", M::stress, &P::pressure_max},
      {"plastic_volume",
       "m3",
       "volume of one sphere that has yielded so far",
       M::volume,
       &P::plastic_volume},
      {"dissipated_energy",
       "J",
       "plastic work in both spheres so far",
       M::energy,
       &P::dissipated_energy},
      {"plastic_strain_max",
       "1",
       "largest accumulated plastic strain",
       M::strain,
       &P::plastic_strain_max},
      {"newton_iterations",
       "1",
       "Newton iterations spent on this point",
       M::count,
       &P::newton_iterations},
      {"mises_stress_max",
       "Pa",
       "largest von Mises stress in a sphere",
       M::stress,
       &P::mises_stress_max},
    };

    /// All members of a point. It does not compile any more when CurvePoint gets or loses one: then
    /// `list` needs its entry as well.
    constexpr auto members(const CurvePoint &point)
    {
      const auto &[approach,
                   force,
                   contact_radius,
                   pressure_max,
                   plastic_volume,
                   dissipated_energy,
                   plastic_strain_max,
                   mises_stress_max,
                   newton_iterations] = point;
      return std::tie(approach,
                      force,
                      contact_radius,
                      pressure_max,
                      plastic_volume,
                      dissipated_energy,
                      plastic_strain_max,
                      mises_stress_max,
                      newton_iterations);
    }
    static_assert(std::tuple_size_v<decltype(members(CurvePoint()))> == std::size(list),
                  "every member of CurvePoint has one entry in the list of curve quantities");
  } // namespace

  const std::vector<CurveQuantity> &curve_quantities()
  {
    static const std::vector<CurveQuantity> quantities(std::begin(list), std::end(list));
    return quantities;
  }

  double CurveScale::of(const CurveMeasure measure) const
  {
    switch (measure)
      {
        case CurveMeasure::approach:
          return approach;
        case CurveMeasure::force:
          return force;
        case CurveMeasure::length:
          return length;
        case CurveMeasure::stress:
          return stress;
        case CurveMeasure::volume:
          return volume;
        case CurveMeasure::energy:
          return energy;
        case CurveMeasure::strain:
          return strain;
        case CurveMeasure::count:
          break;
      }
    return 1;
  }

  void CurveScale::apply(std::vector<CurvePoint> &points) const
  {
    for (CurvePoint &point : points)
      for (const CurveQuantity &quantity : list)
        if (const auto *const member = std::get_if<double CurvePoint::*>(&quantity.member))
          point.**member *= of(quantity.measure);
  }

  void CurveScale::apply(Curve &curve) const
  {
    apply(curve.loading);
    apply(curve.unloading);
  }
} // namespace dpcontact
