#ifndef DPCONTACT_MESHING_ZONES_H
#define DPCONTACT_MESHING_ZONES_H

namespace dpcontact
{
  /// What a zoned mesh looks like. All lengths are in units of the contact radius that the scene
  /// will reach, so that one mesh serves every material whose load level it fits.
  ///
  /// Around the origin lies a square block of side `contact_zone`, meshed by squares. Rings graded
  /// geometrically lead from there to a circle of radius `domain_radius`. Cells are halved
  /// in four nested zones towards the contact: the square of half side `plastic_zone`, then under
  /// the contact zone down to `medium_depth`, `fine_depth` and `surface_depth` (below resolution 16
  /// the last ones are left out), and `surface_halvings` times more in ever thinner layers at the
  /// surface. Between zones stand hanging nodes. The thin zone at the surface pays most, because
  /// the edge of the contact advances node by node there. Octave k repeats the zones at 2^−k of
  /// their size with cells of 2^−k of the size, which resolve contacts that are as much smaller.
  struct Zones
  {
    unsigned int resolution   = 40;  ///< elements across the contact radius; all sizes follow it
    unsigned int refinements  = 0;   ///< uniform refinements on top
    double       contact_zone = 1.2; ///< how far the fine surface reaches at least
    double plastic_zone  = 2.4; ///< half side of the square in which the plastic zone is resolved
    double medium_depth  = 0.6;
    double fine_depth    = 0.2;
    double surface_depth = 0.1;
    unsigned int surface_halvings = 0; ///< further halvings, each to half of the depth before
    unsigned int octaves          = 0; ///< contacts down to 2^−octaves are resolved as well
    double       domain_radius    = 200;
    double       growth           = 1.4; ///< ratio of neighbouring ring widths at resolution 40
    double       stretch          = 1;   ///< multiplies every length (similarity checks)

    /// @throws InputError naming the quantity, its value and its range.
    void check() const;
  };
} // namespace dpcontact

#endif
