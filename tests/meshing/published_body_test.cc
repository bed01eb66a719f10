#include "meshing/errors.h"
#include "meshing/gmsh_session.h"
#include "meshing/published_mesh.h"
#include "meshing/quality.h"
#include "tests/support/space_meshes.h"

#include <deal.II/base/numbers.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <map>
#include <set>
#include <tuple>

using namespace dpcontact;
using namespace dpcontact::tests;

namespace
{
  /// A handful of operations, and sums of up to 18,275 volumes or areas.
  constexpr double rounding_of_body = 1e-13;

  class PublishedBody : public ::testing::Test
  {
  protected:
    PublishedBody() { make_published_mesh({}, dealii::numbers::PI / 2, quarter); }
    Body quarter;
  };

  /// Radii of the surface's vertices on the plane where coordinate `across` is 0, outwards.
  std::vector<double> radii_on_plane(const Body &mesh, const unsigned int across)
  {
    std::vector<double> radii;
    for (const unsigned int v : boundary_vertices(mesh, boundary::surface))
      if (mesh.get_vertices()[v][across] == 0)
        radii.push_back(mesh.get_vertices()[v][1 - across]);
    std::sort(radii.begin(), radii.end());
    return radii;
  }

  TEST_F(PublishedBody, has_the_printed_bricks_and_nodes)
  {
    Body whole;
    make_published_mesh({}, 2 * dealii::numbers::PI, whole);
    EXPECT_EQ(whole.n_active_cells(), 73100u);
    EXPECT_EQ(whole.n_used_vertices(), 76830u);
    EXPECT_NO_THROW(check_mesh(whole, 2 * dealii::numbers::PI));
    EXPECT_EQ(quarter.n_active_cells(), 18275u);
    // Quarter planes: 8 × 9 nodes of the core, 45 rings of 16.
    EXPECT_EQ(quarter.n_used_vertices(), 26u * (8 * 9 + 45 * 16));

    // The quarter's vertices are the whole's in the quadrant, to the last bit.
    const auto points_of = [](const Body &mesh) {
      std::set<std::tuple<double, double, double>> points;
      for (const auto &p : mesh.get_vertices())
        if (p[0] >= 0 && p[1] >= 0)
          points.emplace(p[0], p[1], p[2]);
      return points;
    };
    EXPECT_EQ(points_of(whole), points_of(quarter));
    expect_invariant(
      whole, [](const auto &p) { return dealii::Point<3>(-p[0], p[1], p[2]); }, 1e-15);
    expect_invariant(
      whole, [](const auto &p) { return dealii::Point<3>(p[0], -p[1], p[2]); }, 1e-15);
  }

  TEST_F(PublishedBody, has_the_printed_radial_sizes_in_each_zone)
  {
    // Along x the core's half side is 8 elements, along y 7 as long together.
    for (const unsigned int across : {1u, 0u})
      {
        const unsigned int core  = across == 1 ? 8 : 7;
        const auto         radii = radii_on_plane(quarter, across);
        ASSERT_EQ(radii.size(), core + 45u + 1u);
        for (unsigned int i = 0; i + 1 < radii.size(); ++i)
          {
            const double middle = (radii[i] + radii[i + 1]) / 2;
            const double size   = i < core         ? 4e-4 / core
                                  : middle < 0.002 ? 5e-5
                                  : middle < 0.005 ? 5e-4
                                                   : 1e-3;
            EXPECT_NEAR(radii[i + 1] - radii[i], size, rounding_of_body * 0.012) << radii[i];
          }
        EXPECT_NEAR(radii.back(), 0.012, rounding_of_body * 0.012);
      }
  }

  TEST_F(PublishedBody, has_circles_of_sixty_equal_segments_outside_the_core)
  {
    std::map<long, std::vector<double>> circles;
    for (const unsigned int v : boundary_vertices(quarter, boundary::surface))
      {
        const auto  &p = quarter.get_vertices()[v];
        const double r = std::hypot(p[0], p[1]);
        if (r > 8e-4 - 1e-12)
          {
            EXPECT_NEAR(
              r, 5e-5 * static_cast<double>(std::lround(r / 5e-5)), rounding_of_body * 0.012);
            circles[std::lround(r / 5e-5)].push_back(std::atan2(p[1], p[0]));
          }
      }
    EXPECT_EQ(circles.size(), 53u - 15u); // elements 16 to 53 end on circles
    for (auto &[circle, angles] : circles)
      {
        ASSERT_EQ(angles.size(), 16u);
        std::sort(angles.begin(), angles.end());
        for (unsigned int i = 0; i < 16; ++i)
          EXPECT_NEAR(angles[i], i * dealii::numbers::PI / 30, rounding_of_body);
      }
  }

  TEST_F(PublishedBody, has_layers_graded_from_the_printed_thickness_to_the_other)
  {
    std::set<double> depths; // rounded, to count planes
    for (const auto &p : quarter.get_vertices())
      depths.insert(std::round(-p[2] * 1e12) * 1e-12);
    ASSERT_EQ(depths.size(), 26u);
    double size = 2e-4, depth = 0;
    for (const double found : depths)
      {
        EXPECT_NEAR(found, depth, 2e-12);
        depth += size;
        size *= std::pow(10., 1. / 24);
      }
  }

  TEST_F(PublishedBody, names_its_boundary_and_fills_its_prism)
  {
    for (const double outer : {0.006, 0.012, 0.024})
      {
        SCOPED_TRACE(outer);
        PublishedMesh published;
        published.outer_radius = outer;
        Body mesh;
        make_published_mesh(published, dealii::numbers::PI / 2, mesh);
        EXPECT_NO_THROW(check_mesh(mesh, dealii::numbers::PI / 2));
        EXPECT_EQ(mesh.n_active_cells(),
                  25u * (7 * 8 + 15 * (38 + std::lround((outer - 0.005) / 1e-3))));
        // A sixty-sided prism; sums of tens of thousands of volumes from coordinates as above.
        const double depth   = PublishedMesh::depth();
        const double section = 7.5 * outer * outer * std::sin(dealii::numbers::PI / 30);
        const double sides   = 15 * 2 * outer * std::sin(dealii::numbers::PI / 60) * depth;
        EXPECT_NEAR(total_volume(mesh), section * depth, rounding_of_body * section * depth);
        EXPECT_NEAR(boundary_area(mesh, boundary::surface), section, rounding_of_body * section);
        EXPECT_NEAR(boundary_area(mesh, boundary::axis),
                    2 * outer * depth,
                    rounding_of_body * 2 * outer * depth);
        EXPECT_NEAR(boundary_area(mesh, boundary::far),
                    section + sides,
                    rounding_of_body * (section + sides));
      }
  }

  TEST_F(PublishedBody, has_bricks_as_slender_as_the_printed_sizes_make_them)
  {
    const MeshQuality quality = assess(quarter, 1e-3);
    // Prisms over the section's quadrilaterals. Three cells meet at M: at best at 120 degrees,
    // whose sine is 0.87. The worst has 123, sine 0.84.
    EXPECT_GT(quality.smallest_scaled_jacobian, 0.83);
    EXPECT_LT(quality.smallest_scaled_jacobian, std::sin(dealii::numbers::PI * 2 / 3));
    EXPECT_GT(quality.mean_scaled_jacobian, 0.99);
    EXPECT_EQ(quality.n_hanging_nodes, 0u);
    EXPECT_NEAR(quality.elements_across_contact, 20, 1e-9);
    std::cout << "scaled Jacobian " << quality.smallest_scaled_jacobian << "; aspect ratio "
              << quality.largest_aspect_ratio << "\n";
  }

  TEST_F(PublishedBody, measures_lengths_in_the_given_unit)
  {
    PublishedMesh published;
    published.unit = 9e-4;
    Body scaled;
    make_published_mesh(published, dealii::numbers::PI / 2, scaled);
    ASSERT_EQ(scaled.n_vertices(), quarter.n_vertices());
    for (unsigned int v = 0; v < quarter.n_vertices(); ++v)
      for (unsigned int d = 0; d < 3; ++d)
        EXPECT_DOUBLE_EQ(scaled.get_vertices()[v][d], quarter.get_vertices()[v][d] / 9e-4);
    EXPECT_NEAR(assess(scaled, 1).elements_across_contact, 18, 1e-9);
  }

  TEST_F(PublishedBody, is_the_same_bit_for_bit_when_made_again)
  {
    Body again;
    make_published_mesh({}, dealii::numbers::PI / 2, again);
    EXPECT_EQ(fingerprint(quarter), fingerprint(again));
  }

  TEST(PublishedBodyLevel, makes_eight_bricks_of_one_and_keeps_the_grading)
  {
    PublishedMesh published;
    published.outer_radius = 0.006;
    published.refinements  = 1;
    Body fine;
    make_published_mesh(published, dealii::numbers::PI / 2, fine);
    EXPECT_EQ(fine.n_active_cells(), 8 * 25u * (7 * 8 + 15 * 39));
    const auto radii = radii_on_plane(fine, 1);
    EXPECT_NEAR(radii[1], 2.5e-5, rounding_of_body * 0.006);
    EXPECT_EQ(radii.size(), 2 * 47u + 1u);
    // One hundred and twenty sides: halved segments end on the circle.
    const double section = 15 * std::pow(0.006, 2) * std::sin(dealii::numbers::PI / 60);
    EXPECT_NEAR(boundary_area(fine, boundary::surface), section, rounding_of_body * section);
  }

  TEST(PublishedBodyCheck, refuses_what_is_out_of_range_and_names_it)
  {
    const auto refused = [](const PublishedMesh &published, const double angle, const char *name) {
      Body mesh;
      expect_refused<InputError>([&] { make_published_mesh(published, angle, mesh); }, name);
      EXPECT_EQ(mesh.n_active_cells(), 0u);
    };
    for (const double angle : {0.,
                               dealii::numbers::PI / 4,
                               dealii::numbers::PI,
                               -2 * dealii::numbers::PI,
                               std::numeric_limits<double>::quiet_NaN()})
      refused({}, angle, "angle");
    refused({0.001, 0, 1}, dealii::numbers::PI / 2, "outer-radius");
  }
} // namespace
