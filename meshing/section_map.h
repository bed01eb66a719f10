#ifndef DPCONTACT_MESHING_SECTION_MAP_H
#define DPCONTACT_MESHING_SECTION_MAP_H

#include <deal.II/base/point.h>

namespace dpcontact
{
  /// The o-grid of a wedge 0 ≤ θ ≤ angle, as the map of a square frame a, b ≥ 0 onto it.
  ///
  /// The square a, b ≤ kite_radius becomes the kite O–A–M–B with A on θ = 0, B on θ = angle, both
  /// at kite_radius, and M between. Each larger square, of half side ρ = max(a, b), becomes the
  /// circle of radius ρ from circle_radius on, its perimeter spread evenly over the angle on either
  /// side of M; between kite and circle every line of equal min(a, b)/ρ is straight.
  struct SectionMap
  {
    double angle;         ///< of the wedge
    double corner_angle;  ///< θ of M and of the frame's diagonal a = b
    double kite_radius;   ///< distance of A and B from O
    double circle_radius; ///< of the first circle; larger than corner_distance × kite_radius

    /// |OM| / |OA|. At M three cells meet: 1.15 gives the kite an angle of 116 to 119 degrees there
    /// for wedges of 90 and 45 degrees, so that all three are nearly equal, and at A and B 77
    /// to 98.
    static constexpr double corner_distance = 1.15;

    /// (x, y) of the point (a, b), a, b ≥ 0; lengths in the map's unit.
    dealii::Point<2> operator()(double a, double b) const;
  };
} // namespace dpcontact

#endif
