#ifndef DPCONTACT_SOLVER_OUTPUT_PLASTIC_ZONE_H
#define DPCONTACT_SOLVER_OUTPUT_PLASTIC_ZONE_H

#include <limits>
#include <optional>

namespace dpcontact
{
  template <int dim>
  class ContactSystem;

  /// Extent of a part of a sphere that has yielded, of whole cells. Radii from the axis, depths
  /// from the surface, in m.
  struct PlasticRegion
  {
    double       radius_min = std::numeric_limits<double>::infinity();
    double       radius_max = 0;
    double       depth_min  = std::numeric_limits<double>::infinity();
    double       depth_max  = 0;
    double       volume     = 0; ///< m³
    unsigned int cells      = 0;
    /// Radii between which it lies at the surface. Unset: it is buried.
    struct SurfaceExtent
    {
      double radius_min = std::numeric_limits<double>::infinity();
      double radius_max = 0;
    };
    std::optional<SurfaceExtent> surface;
  };

  /// Where a sphere has yielded so far.
  ///
  /// A cell is plastic where at least half of its quadrature points are (ZoneRule); plastic cells
  /// that share a face belong together. The **core** is the largest such region among those with a
  /// face on the axis; the **ring** is all other regions that lie at the surface (it yields at the
  /// contact's edge, and the edge leaves it behind under the contact as it moves outwards). A ring
  /// that has grown together with the core is part of the core.
  struct PlasticZone
  {
    double contact_radius = 0; ///< of the contact's edge, m
    double cell_size = 0; ///< of the smallest cell at the surface, m: how well extents are known

    std::optional<PlasticRegion> core;
    std::optional<PlasticRegion> ring;
    unsigned int                 ring_parts    = 0; ///< regions that the ring consists of
    unsigned int                 other_regions = 0; ///< neither core nor at the surface

    /// Depths on the axis between which the core lies, m; 0 without a core.
    double axis_depth_min = 0;
    double axis_depth_max = 0;

    /// Whether the core lies at the surface outside the contact's edge, on its own or grown
    /// together with the ring: a face whose middle lies outside the edge belongs to one of its
    /// cells.
    bool core_reaches_free_surface = false;
    /// Whether there is elastic material on the axis between the contact and the core (also where
    /// nothing is plastic).
    bool elastic_cap = true;
  };

  /// Which points count as plastic.
  enum class ZoneRule
  {
    yielded, ///< those with accumulated plastic strain, however long ago
    flowing  ///< those that yield in the present load step
  };

  /// A body's zone at the state last committed to the system.
  /// @param length factor from the system's unit of length to m.
  /// @param body 0, or 1 where two bodies deform.
  PlasticZone plastic_zone(const ContactSystem<2> &system,
                           double                  length,
                           ZoneRule                rule = ZoneRule::yielded,
                           unsigned int            body = 0);
} // namespace dpcontact

#endif
