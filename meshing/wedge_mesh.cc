#include "meshing/wedge_mesh.h"

#include "meshing/frame.h"
#include "meshing/gmsh_session.h"
#include "meshing/require.h"
#include "meshing/section_map.h"
#include "meshing/zone_halving.h"

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace dpcontact
{
  namespace
  {
    /// Elements at the radius 1 are at most this many times as long around as across.
    constexpr double longest_around = 1.6;
    /// The kite ends well within the first circle.
    constexpr double largest_kite = 0.73;
    constexpr double first_circle = 0.915;

    /// Coarse cells along the kite's side, of which 2^halvings fine ones make one.
    unsigned int
    wedge_kite_cells(const double angle, const unsigned int resolution, const unsigned int halvings)
    {
      const double fine = angle / 2 / longest_around * resolution;
      return static_cast<unsigned int>(std::ceil(fine / (1u << halvings) - 1e-9));
    }

    /// As many as leave a quarter's kite two cells wide or wider and small enough.
    unsigned int wedge_halvings(const unsigned int resolution)
    {
      for (const unsigned int halvings : {3u, 2u, 1u})
        {
          const unsigned int cells = wedge_kite_cells(M_PI / 2, resolution, halvings);
          if (cells >= 2 && cells * (1u << halvings) <= largest_kite * resolution)
            return halvings;
        }
      return 0;
    }

    /// From the frame, in which the core's cells and the shells are 1 wide, to the half-ball.
    class WedgeMap
    {
    public:
      WedgeMap(const Frame &cells,
               const double block,
               const double angle,
               const double outer,
               const double shell_growth)
        : frame(cells)
        , section{angle, angle / 2, cells.kite_side * block, first_circle}
        , cell_size(block)
        , outer_radius(outer)
        , growth(shell_growth)
      {}

      /// (radius, depth) of a point in a body of the same cells whose circles are squares still.
      std::pair<double, double> square_place(const dealii::Point<3> &p) const
      {
        const double radius = std::max(std::abs(p[0]), std::abs(p[1]));
        const double extent = std::max(radius, -p[2]);
        const double share  = outwards(extent);
        const double c      = core_radius();
        const double scale  = share > 0 ? (c + share * (outer_radius - c)) / extent : cell_size;
        return {scale * radius, -scale * p[2]};
      }

      dealii::Point<3> operator()(const dealii::Point<3> &p) const
      {
        const double extent = std::max({std::abs(p[0]), std::abs(p[1]), -p[2]});
        const double share  = outwards(extent);
        // On the ray of the frame, the point within or on the core.
        const dealii::Point<3> q =
          p * (share > 0 ? cell_size * frame.core_side() / extent : cell_size);
        dealii::Point<2> s = section(std::abs(q[0]), std::abs(q[1]));
        for (unsigned int k = 0; k < 2; ++k)
          if (q[k] < 0)
            s[k] = -s[k];
        const dealii::Point<3> core(s[0], s[1], q[2]);
        if (!(share > 0))
          return core;
        return core + share * (on_sphere(core, /*below=*/-p[2] == extent) - core);
      }

    private:
      double core_radius() const { return cell_size * frame.core_side(); }

      /// 0 up to the core's side, 1 at the far boundary; the shells' widths grow geometrically.
      double outwards(const double extent) const
      {
        const double shell = extent - frame.core_side();
        return shell <= 0 ? 0.
                          : (std::pow(growth, shell) - 1) / (std::pow(growth, frame.shells) - 1);
      }

      /// The core's side and bottom each take half of the right angle between surface and axis,
      /// evenly.
      dealii::Point<3> on_sphere(const dealii::Point<3> &core, const bool below) const
      {
        const double r = std::hypot(core[0], core[1]);
        const double half =
          M_PI / 4 * (below ? r : -core[2]) / core_radius(); // from the axis or the surface
        const double radius = outer_radius * (below ? std::sin(half) : std::cos(half));
        const double depth  = outer_radius * (below ? std::cos(half) : std::sin(half));
        if (r == 0)
          return {0, 0, -depth};
        return {radius * (core[0] / r), radius * (core[1] / r), -depth};
      }

      const Frame      frame;
      const SectionMap section;
      const double     cell_size, outer_radius, growth;
    };
  } // namespace

  void make_wedge_mesh(const Zones &zones, const double angle, dealii::Triangulation<3> &mesh)
  {
    zones.check();
    const auto is = [angle](const double value) {
      return std::isfinite(angle) && std::abs(angle - value) < 1e-12;
    };
    const char *const what  = "wedge mesh";
    const bool        whole = is(2 * M_PI);
    require(is(M_PI / 4) || is(M_PI / 2) || whole, what, "angle", angle, "pi/4, pi/2 or 2 pi");
    require(zones.resolution >= 4, what, "resolution", zones.resolution, "at least 4 in space");
    require(zones.octaves == 0, what, "octaves", zones.octaves, "0 in space");

    const double       wedge    = is(M_PI / 4) ? M_PI / 4 : M_PI / 2;
    const unsigned int halvings = wedge_halvings(zones.resolution);
    const double       block    = static_cast<double>(1u << halvings) / zones.resolution;
    const auto core_cells = static_cast<unsigned int>(std::ceil(zones.contact_zone / block - 1e-9));
    const double core     = core_cells * block;
    // Shells 1.6 times as wide as the one within are about as wide as a sixteenth of their circle.
    const double growth =
      std::min(std::max(1.6, zones.growth), std::pow(zones.growth, 40. / zones.resolution));
    const unsigned int kite  = wedge_kite_cells(wedge, zones.resolution, halvings);
    const Frame        frame = {
             kite,
             kite,
             kite,
             core_cells - kite,
             core_cells,
             static_cast<unsigned int>(number_of_rings(core, zones.domain_radius, block, growth))};
    make_frame(frame, mesh);
    if (whole)
      mirror_to_whole(mesh);

    // From the coarsest cells to the finest, as in the half plane.
    const WedgeMap                         map(frame, block, wedge, zones.domain_radius, growth);
    const double                           reach = 2.5 * std::max(core, zones.plastic_zone);
    std::vector<std::pair<double, double>> sizes = {
      {reach, reach}, {core, zones.medium_depth}, {core, zones.fine_depth}};
    sizes.resize(halvings);
    for (unsigned int k = 1; k <= zones.surface_halvings; ++k)
      sizes.emplace_back(core, zones.surface_depth / static_cast<double>(1u << k));
    halve_zones(
      sizes, 0, [&map](const dealii::Point<3> &p) { return map.square_place(p); }, mesh);
    mesh.refine_global(zones.refinements);
    // Sets hanging vertices to the midpoints of their edges and faces as well.
    dealii::GridTools::transform(map, mesh);
    if (zones.stretch != 1)
      dealii::GridTools::scale(zones.stretch, mesh);
    check_mesh(mesh, angle);
  }
} // namespace dpcontact
