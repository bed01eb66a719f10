#include "meshing/errors.h"
#include "meshing/quality.h"
#include "meshing/zoned_mesh.h"
#include "tests/support/plane_meshes.h"

#include <deal.II/base/numbers.h>

#include <cmath>
#include <limits>
#include <tuple>

using namespace dpcontact;
using namespace dpcontact::tests;

namespace
{
  /// gmsh places the points of a curve to about 1e-12 of its length; a cell's side is off by up to
  /// 3e-12 of itself.
  constexpr double gmsh_placement = 1e-11;

  /// Halvings of the coarse block's cells: four, fewer where the resolution is below 16.
  int halvings(const Zones &zones)
  {
    return zones.resolution >= 16 ? 4 : zones.resolution >= 8 ? 3 : zones.resolution >= 4 ? 2 : 1;
  }

  /// Cells along the coarse block's side: as many of size 2^halvings/resolution as cover the zone.
  int block_cells(const Zones &zones)
  {
    return static_cast<int>(
      std::ceil(zones.resolution * zones.contact_zone / std::pow(2, halvings(zones)) - 1e-9));
  }

  double block_side(const Zones &zones)
  {
    return block_cells(zones) * std::pow(2, halvings(zones)) / zones.resolution;
  }

  double elements_across(const Zones &zones)
  {
    return zones.resolution * std::pow(2, zones.refinements);
  }

  class ZonedMesh : public ::testing::TestWithParam<std::tuple<unsigned int, unsigned int>>
  {
  protected:
    ZonedMesh()
    {
      std::tie(zones.resolution, zones.refinements) = GetParam();
      make_zoned_mesh(zones, mesh);
    }
    Zones zones;
    Mesh  mesh;
  };

  INSTANTIATE_TEST_SUITE_P(ResolutionAndLevel,
                           ZonedMesh,
                           ::testing::Combine(::testing::Values(4u, 12u, 20u, 40u),
                                              ::testing::Values(0u, 1u, 2u)));

  TEST_P(ZonedMesh, has_the_elements_across_the_contact_that_were_asked_for)
  {
    const double found = assess(mesh, 1).elements_across_contact;
    EXPECT_NEAR(found, elements_across(zones), gmsh_placement * found);
    EXPECT_GE(block_side(zones), zones.contact_zone);
  }

  TEST_P(ZonedMesh, has_a_uniform_fine_surface_over_the_contact_zone)
  {
    const double size = 1 / elements_across(zones);
    unsigned int fine = 0;
    for (const auto &[inner, outer] : surface_faces(mesh))
      if ((inner + outer) / 2 < block_side(zones))
        {
          ++fine;
          EXPECT_NEAR(outer - inner, size, gmsh_placement * size) << "at r = " << inner;
        }
    EXPECT_EQ(fine, std::lround(block_side(zones) / size));
  }

  TEST_P(ZonedMesh, has_square_cells_down_to_the_depth_of_the_finest_zone)
  {
    const double size = 1 / elements_across(zones);
    // The zone ends at the row of medium cells that is nearest to its depth.
    const double row      = 2 * size * std::pow(2, zones.refinements);
    const double depths[] = {
      zones.plastic_zone, zones.medium_depth, zones.fine_depth, zones.surface_depth};
    const double depth = row * std::ceil(depths[halvings(zones) - 1] / row - 0.5);
    EXPECT_GE(depth, row);
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->center()[0] < block_side(zones) && -cell->center()[1] < depth)
        {
          EXPECT_NEAR(cell->extent_in_direction(0), size, gmsh_placement * size);
          EXPECT_NEAR(cell->extent_in_direction(1), size, gmsh_placement * size);
        }
  }

  TEST_P(ZonedMesh, names_all_of_its_boundary)
  {
    const double segments = 2 * block_cells(zones), L = zones.domain_radius;
    const double chord = 2 * L * std::sin(dealii::numbers::PI / 4 / segments);
    expect_boundary_lengths(mesh, L, L, segments * chord);
  }

  TEST_P(ZonedMesh, fills_the_quarter_polygon_and_no_more_than_the_quarter_circle)
  {
    const double pi       = dealii::numbers::PI;
    const double segments = 2 * block_cells(zones), L = zones.domain_radius;
    const double polygon = segments / 2 * L * L * std::sin(pi / 2 / segments);
    // The rounding of at most 5,000 areas, each from coordinates of up to 200.
    EXPECT_NEAR(total_area(mesh), polygon, 1e-11 * polygon);
    const double circle = pi * L * L / 4;
    EXPECT_LT(total_area(mesh), circle);
    // sin x / x > 1 - x²/6 with x = pi / (2 segments).
    EXPECT_GT(total_area(mesh), circle * (1 - std::pow(pi / 2 / segments, 2) / 6));
  }

  TEST_P(ZonedMesh, has_well_shaped_quadrilaterals)
  {
    EXPECT_TRUE(mesh.all_reference_cells_are_hyper_cube());
    const MeshQuality quality = assess(mesh, 1);
    // The sharpest corner stands where the diagonal meets the block's corner: 45 degrees.
    EXPECT_GE(quality.smallest_scaled_jacobian, std::sqrt(0.5) - 1e-12);
    // Far out a ring's width is (growth - 1) ρ and its inner chord 2 ρ sin(pi / (8 block cells));
    // further in the ratio is smaller. The squares of the block are the other kind of cell.
    const double growth = std::min(2., std::pow(zones.growth, 40. / zones.resolution));
    EXPECT_LE(quality.largest_aspect_ratio,
              (growth - 1) / (2 * std::sin(dealii::numbers::PI / 8 / block_cells(zones))));
    EXPECT_GE(quality.mean_aspect_ratio, 1);
    const double square = std::pow(1 / elements_across(zones), 2);
    EXPECT_NEAR(quality.smallest_cell_area, square, 2 * gmsh_placement * square);
  }

  TEST_P(ZonedMesh, keeps_the_mesh_of_the_contact_zone_when_the_domain_doubles)
  {
    Zones wider = zones;
    wider.domain_radius *= 2;
    Mesh wide_mesh;
    make_zoned_mesh(wider, wide_mesh);
    const auto inner_vertices = [this](const Mesh &m) {
      std::vector<std::pair<double, double>> points;
      for (const auto &cell : m.active_cell_iterators())
        if (cell->center()[0] < zones.contact_zone && -cell->center()[1] < zones.contact_zone)
          for (const unsigned int v : cell->vertex_indices())
            points.emplace_back(cell->vertex(v)[0], cell->vertex(v)[1]);
      std::sort(points.begin(), points.end());
      return points;
    };
    const auto points = inner_vertices(mesh);
    EXPECT_GE(points.size(), 40u);
    EXPECT_EQ(points, inner_vertices(wide_mesh));
    EXPECT_NEAR(total_area(wide_mesh), 4 * total_area(mesh), 1e-11 * total_area(wide_mesh));
  }

  TEST_P(ZonedMesh, is_the_same_bit_for_bit_when_made_again)
  {
    Mesh again;
    make_zoned_mesh(zones, again);
    EXPECT_EQ(fingerprint(mesh), fingerprint(again));
  }

  TEST_P(ZonedMesh, multiplies_every_length_by_the_stretch)
  {
    Zones stretched   = zones;
    stretched.stretch = 1.37;
    Mesh stretched_mesh;
    make_zoned_mesh(stretched, stretched_mesh);
    ASSERT_EQ(stretched_mesh.n_vertices(), mesh.n_vertices());
    for (unsigned int v = 0; v < mesh.n_vertices(); ++v)
      for (const unsigned int d : {0u, 1u})
        EXPECT_DOUBLE_EQ(stretched_mesh.get_vertices()[v][d], 1.37 * mesh.get_vertices()[v][d]);
    EXPECT_NEAR(assess(stretched_mesh, 1.37).elements_across_contact,
                elements_across(zones),
                1e-11 * elements_across(zones));
  }

  TEST(ZonedMeshRefinement, each_level_quarters_every_cell)
  {
    Zones zones;
    Mesh  coarse, fine;
    make_zoned_mesh(zones, coarse);
    zones.refinements = 1;
    make_zoned_mesh(zones, fine);
    EXPECT_EQ(fine.n_active_cells(), 4 * coarse.n_active_cells());
    EXPECT_NEAR(total_area(fine), total_area(coarse), 1e-12 * total_area(coarse));
  }

  TEST(ZonedMeshRefinement, meets_the_resolution_where_a_zone_is_shallower_than_half_a_cell)
  {
    Zones zones; // resolution 40
    zones.fine_depth = zones.surface_depth = 0.01;
    Mesh shallow;
    make_zoned_mesh(zones, shallow);
    EXPECT_NEAR(assess(shallow, 1).elements_across_contact, 40, 1e-10);

    Zones wide;
    wide.resolution   = 2;
    wide.contact_zone = wide.plastic_zone = 5;
    Mesh coarse;
    make_zoned_mesh(wide, coarse);
    EXPECT_NEAR(assess(coarse, 1).elements_across_contact, elements_across(wide), 1e-10);
  }

  struct BadZones
  {
    const char *name;
    void (*spoil)(Zones &, double);
    std::vector<double> values;
  };

  TEST(ZonesCheck, refuses_each_quantity_out_of_range_and_names_it)
  {
    const double   nan     = std::numeric_limits<double>::quiet_NaN();
    const double   inf     = std::numeric_limits<double>::infinity();
    const BadZones cases[] = {
      {"resolution",
       [](Zones &z, double v) { z.resolution = static_cast<unsigned int>(v); },
       {0, 1, 1025}},
      {"refinements",
       [](Zones &z, double v) { z.refinements = static_cast<unsigned int>(v); },
       {7, 100}},
      {"contact_zone", [](Zones &z, double v) { z.contact_zone = v; }, {1, 0, -1, 10, nan, inf}},
      {"plastic_zone", [](Zones &z, double v) { z.plastic_zone = v; }, {1.1, -1, nan, inf, -inf}},
      {"fine_depth", [](Zones &z, double v) { z.fine_depth = v; }, {0, -1, 0.7, nan, inf}},
      {"surface_depth", [](Zones &z, double v) { z.surface_depth = v; }, {0, -1, 0.3, nan, inf}},
      {"medium_depth", [](Zones &z, double v) { z.medium_depth = v; }, {0.1, 1.3, nan, inf}},
      {"domain_radius", [](Zones &z, double v) { z.domain_radius = v; }, {4.7, -200, nan, inf}},
      {"growth", [](Zones &z, double v) { z.growth = v; }, {1, 0.9, 3.1, nan, inf}},
      {"stretch", [](Zones &z, double v) { z.stretch = v; }, {0, -1, nan, inf}}};
    for (const BadZones &bad : cases)
      for (const double value : bad.values)
        {
          SCOPED_TRACE(std::string(bad.name) + " = " + std::to_string(value));
          Zones zones;
          bad.spoil(zones, value);
          Mesh mesh;
          expect_refused<InputError>([&] { make_zoned_mesh(zones, mesh); }, bad.name);
          EXPECT_EQ(mesh.n_active_cells(), 0u);
        }
  }

  TEST(ZonesCheck, accepts_the_ends_of_the_ranges)
  {
    Zones zones;
    zones.resolution   = 1024;
    zones.refinements  = 6;
    zones.contact_zone = zones.plastic_zone = zones.medium_depth = zones.fine_depth = 1.5;
    zones.domain_radius                                                             = 3;
    zones.growth                                                                    = 3;
    EXPECT_NO_THROW(zones.check());
    zones.resolution = 2;
    EXPECT_NO_THROW(zones.check());
  }
} // namespace
