#include "meshing/errors.h"
#include "meshing/gmsh_session.h"
#include "meshing/quality.h"
#include "meshing/section_map.h"
#include "meshing/wedge_mesh.h"
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
  /// A handful of operations on radii of up to 6; fine elements are 1/48 and larger.
  constexpr double placement = 1e-13;

  /// What the header's rules make of a resolution, for a quarter.
  struct Layout
  {
    unsigned int resolution;
    unsigned int halvings;
    unsigned int core_cells; ///< along the core's radius and depth, and so half the right angle
    unsigned int most_cells; ///< a budget for the quarter
  };
  constexpr Layout       layouts[]             = {{8, 1, 5, 2500},
                                                  {12, 2, 4, 3200},
                                                  {16, 2, 5, 4800},
                                                  {24, 3, 4, 6000}};
  constexpr unsigned int coarse_around_quarter = 4;

  class WedgeMesh : public ::testing::TestWithParam<std::tuple<Layout, double>>
  {
  protected:
    WedgeMesh()
      : layout(std::get<0>(GetParam()))
      , angle(std::get<1>(GetParam()))
      , around(coarse_around_quarter * angle / (dealii::numbers::PI / 2))
      , core(layout.core_cells * std::pow(2, layout.halvings) / layout.resolution)
    {
      zones.resolution = layout.resolution;
      make_wedge_mesh(zones, angle, mesh);
    }
    const Layout layout;
    const double angle;
    const double around; ///< coarse cells around
    const double core;   ///< the core's radius and depth
    Zones        zones;
    Body         mesh;
  };

  INSTANTIATE_TEST_SUITE_P(ResolutionAndAngle,
                           WedgeMesh,
                           ::testing::Combine(::testing::ValuesIn(layouts),
                                              ::testing::Values(dealii::numbers::PI / 4,
                                                                dealii::numbers::PI / 2)));

  TEST_P(WedgeMesh, is_of_bricks_within_its_budget)
  {
    EXPECT_NO_THROW(check_mesh(mesh, angle));
    // Half a quarter has half of its rings' cells, but a kite of its own.
    EXPECT_LT(mesh.n_active_cells(), layout.most_cells * (angle < 1 ? 0.6 : 1));
    std::cout << "resolution " << layout.resolution << ", angle " << angle << ": "
              << mesh.n_active_cells() << " cells, " << mesh.n_used_vertices() << " vertices\n";
  }

  TEST_P(WedgeMesh, has_the_elements_across_the_contact_that_were_asked_for)
  {
    EXPECT_NEAR(
      assess(mesh, 1).elements_across_contact, layout.resolution, placement * layout.resolution);
  }

  TEST_P(WedgeMesh, has_circles_of_equal_steps_around_the_edge_of_the_contact)
  {
    // Vertices of each circle of radius i/resolution, by their angles.
    std::map<long, std::vector<double>> circles;
    for (const unsigned int v : boundary_vertices(mesh, boundary::surface))
      {
        const auto  &p = mesh.get_vertices()[v];
        const double r = std::hypot(p[0], p[1]);
        if (r < 0.916 || r > core - 0.5 / layout.resolution) // where the coarser begin
          continue;
        const long circle = std::lround(r * layout.resolution);
        EXPECT_NEAR(r, static_cast<double>(circle) / layout.resolution, placement);
        circles[circle].push_back(std::atan2(p[1], p[0]));
      }
    // Fine cells around; the longest allowed at the radius 1 are 1.6 times as long as across.
    const auto cells = static_cast<unsigned int>(around * std::pow(2, layout.halvings));
    EXPECT_LE(angle / cells * layout.resolution, 1.6);
    EXPECT_GE(angle / cells * layout.resolution, 1);
    EXPECT_EQ(circles.size(),
              std::ceil(core * layout.resolution - 1e-9) - std::ceil(0.916 * layout.resolution));
    EXPECT_EQ(circles.count(layout.resolution), 1u);
    for (auto &[circle, angles] : circles)
      {
        ASSERT_EQ(angles.size(), cells + 1) << circle;
        std::sort(angles.begin(), angles.end());
        for (unsigned int i = 0; i <= cells; ++i)
          EXPECT_NEAR(angles[i], angle * i / cells, placement);
      }
  }

  TEST_P(WedgeMesh, names_all_of_its_boundary)
  {
    // Polygons with vertices on the far circle: exact but for the rounding of a few hundred areas.
    const double L   = zones.domain_radius;
    const double top = around * L * L / 2 * std::sin(angle / around);
    EXPECT_NEAR(boundary_area(mesh, boundary::surface), top, 1e-11 * top);
    const double down  = 2 * layout.core_cells;
    const double plane = down * L * L / 2 * std::sin(dealii::numbers::PI / 2 / down);
    EXPECT_NEAR(boundary_area(mesh, boundary::axis), 2 * plane, 1e-11 * plane);
    for (const unsigned int v : boundary_vertices(mesh, boundary::far))
      EXPECT_NEAR(mesh.get_vertices()[v].norm(), L, 1e-12 * L);
  }

  TEST_P(WedgeMesh, fills_its_boundary_without_gap_or_overlap)
  {
    const double volume = total_volume(mesh);
    EXPECT_NEAR(volume, enclosed_volume(mesh), 1e-11 * volume);
  }

  TEST_P(WedgeMesh, fills_the_half_ball_but_for_what_its_flat_far_faces_cut_off)
  {
    // A far face is a mean of its corners, which lie within β of its middle's direction: nowhere
    // nearer to the centre than L cos β.
    double beta = 0;
    for_boundary(mesh, boundary::far, [&beta](const auto &, const auto &face) {
      const auto middle = face->center();
      for (const unsigned int v : face->vertex_indices())
        beta = std::max(
          beta, std::acos((face->vertex(v) * middle) / (face->vertex(v).norm() * middle.norm())));
    });
    const double ball = angle / 3 * std::pow(zones.domain_radius, 3);
    EXPECT_LT(total_volume(mesh), ball);
    EXPECT_GT(total_volume(mesh), ball * std::pow(std::cos(beta), 3));
  }

  TEST_P(WedgeMesh, has_hanging_vertices_in_the_middle_of_edges_and_faces)
  {
    std::set<unsigned int> hanging;
    for (const auto &cell : mesh.active_cell_iterators())
      {
        const double tolerance = 1e-14 * cell->diameter();
        for (const unsigned int l : cell->line_indices())
          if (const auto line = cell->line(l); line->has_children())
            {
              hanging.insert(line->child(0)->vertex_index(1));
              EXPECT_LT(line->child(0)->vertex(1).distance(line->center()), tolerance);
            }
        for (const auto &face : cell->face_iterators())
          if (face->has_children())
            {
              hanging.insert(face->child(0)->vertex_index(3));
              EXPECT_LT(face->child(0)->vertex(3).distance(face->center()), tolerance);
              for (unsigned int i = 0; i < 4; ++i)
                EXPECT_FALSE(face->child(i)->has_children());
            }
      }
    EXPECT_GT(hanging.size(), 60u);
    EXPECT_EQ(hanging.size(), assess(mesh, 1).n_hanging_nodes);
  }

  TEST_P(WedgeMesh, has_well_shaped_bricks)
  {
    const MeshQuality quality = assess(mesh, 1);
    // The sharpest corners stand where a diagonal meets the core's edge, 45 degrees as in the half
    // plane, and in the half quarter's kite on the axis; the slant of the rings near M leaves a few
    // per cent less.
    EXPECT_GT(quality.smallest_scaled_jacobian, 0.95 * std::sqrt(0.5));
    EXPECT_GT(quality.mean_scaled_jacobian, 0.92);
    // The kite under the axis far out, narrower than the shells are thick.
    EXPECT_LT(quality.largest_aspect_ratio, 9);
    EXPECT_LT(quality.mean_aspect_ratio, 2.6);
    std::cout << "scaled Jacobian " << quality.smallest_scaled_jacobian << ", mean "
              << quality.mean_scaled_jacobian << "; aspect ratio " << quality.largest_aspect_ratio
              << ", mean " << quality.mean_aspect_ratio << "\n";
  }

  TEST_P(WedgeMesh, is_symmetric_about_its_middle)
  {
    const double c = std::cos(angle), s = std::sin(angle);
    expect_invariant(
      mesh,
      [&](const auto &p) {
        return dealii::Point<3>(c * p[0] + s * p[1], s * p[0] - c * p[1], p[2]);
      },
      1e-14 * zones.domain_radius);
  }

  TEST_P(WedgeMesh, is_the_same_bit_for_bit_when_made_again)
  {
    Body again;
    make_wedge_mesh(zones, angle, again);
    EXPECT_EQ(fingerprint(mesh), fingerprint(again));
  }

  TEST_P(WedgeMesh, keeps_the_mesh_of_the_core_when_the_domain_doubles)
  {
    Zones wider = zones;
    wider.domain_radius *= 2;
    Body wide;
    make_wedge_mesh(wider, angle, wide);
    const auto core_vertices = [this](const Body &body) {
      std::set<std::tuple<double, double, double>> points;
      for (const auto &cell : body.active_cell_iterators())
        if (const auto m = cell->center(); std::hypot(m[0], m[1]) < core && -m[2] < core)
          for (const unsigned int v : cell->vertex_indices())
            points.emplace(cell->vertex(v)[0], cell->vertex(v)[1], cell->vertex(v)[2]);
      return points;
    };
    const auto points = core_vertices(mesh);
    EXPECT_GT(points.size(), mesh.n_used_vertices() / 4);
    EXPECT_EQ(points, core_vertices(wide));
  }

  double core_volume(const Body &mesh, const double core)
  {
    double volume = 0;
    for (const auto &cell : mesh.active_cell_iterators())
      if (const auto m = cell->center(); std::hypot(m[0], m[1]) < core && -m[2] < core)
        volume += cell->measure();
    return volume;
  }

  TEST(WedgeMeshes, of_an_eighth_a_quarter_and_the_whole_agree)
  {
    Zones zones;
    zones.resolution  = 8;
    const double core = 1.25;
    Body         eighth, quarter, whole;
    make_wedge_mesh(zones, dealii::numbers::PI / 4, eighth);
    make_wedge_mesh(zones, dealii::numbers::PI / 2, quarter);
    make_wedge_mesh(zones, 2 * dealii::numbers::PI, whole);

    EXPECT_EQ(whole.n_active_cells(), 4 * quarter.n_active_cells());
    EXPECT_NO_THROW(check_mesh(whole, 2 * dealii::numbers::PI));
    const double volume = total_volume(whole);
    EXPECT_NEAR(4 * total_volume(quarter), volume, 1e-11 * volume);
    EXPECT_NEAR(enclosed_volume(whole), volume, 1e-11 * volume);
    EXPECT_EQ(boundary_area(whole, boundary::axis), 0);

    // The core's sections are the same polygons, and so is the surface; the kites under the axis
    // meet the far boundary in faces of their own, whose flatness cuts off 1e-4 of the half-ball
    // more or less.
    const double inner = core_volume(whole, core), top = boundary_area(whole, boundary::surface);
    EXPECT_NEAR(4 * core_volume(quarter, core), inner, 1e-11 * inner);
    EXPECT_NEAR(8 * core_volume(eighth, core), inner, 1e-11 * inner);
    EXPECT_NEAR(8 * boundary_area(eighth, boundary::surface), top, 1e-11 * top);
    EXPECT_NEAR(8 * total_volume(eighth), volume, 2e-4 * volume);
  }

  TEST(WedgeMeshes, the_whole_has_the_symmetries_of_its_quarter)
  {
    Zones zones;
    zones.resolution = 8;
    Body whole;
    make_wedge_mesh(zones, 2 * dealii::numbers::PI, whole);
    const double rounding = 1e-14 * zones.domain_radius;
    expect_invariant(
      whole, [](const auto &p) { return dealii::Point<3>(-p[1], p[0], p[2]); }, rounding);
    expect_invariant(
      whole, [](const auto &p) { return dealii::Point<3>(-p[0], p[1], p[2]); }, rounding);
    EXPECT_NEAR(assess(whole, 1).elements_across_contact, 8, 8 * placement);
  }

  TEST(WedgeMeshes, each_level_makes_eight_cells_of_one_and_rounds_the_body)
  {
    Zones zones;
    zones.resolution = 4;
    Body coarse, fine;
    make_wedge_mesh(zones, dealii::numbers::PI / 2, coarse);
    zones.refinements = 1;
    make_wedge_mesh(zones, dealii::numbers::PI / 2, fine);
    EXPECT_EQ(fine.n_active_cells(), 8 * coarse.n_active_cells());
    EXPECT_NEAR(assess(fine, 1).elements_across_contact, 8, 8 * placement);
    // What chords cut off is of second order; 22.5 degrees leave the next orders 10 %.
    const double ball = dealii::numbers::PI / 6 * std::pow(zones.domain_radius, 3);
    EXPECT_NEAR((ball - total_volume(coarse)) / (ball - total_volume(fine)), 4, 0.4);
    for (const unsigned int v : boundary_vertices(fine, boundary::far))
      EXPECT_NEAR(fine.get_vertices()[v].norm(), zones.domain_radius, 1e-12 * zones.domain_radius);
  }

  TEST(WedgeMeshes, surface_halvings_halve_the_cells_at_the_surface)
  {
    Zones zones;
    zones.resolution       = 8;
    zones.surface_halvings = 1;
    Body mesh;
    make_wedge_mesh(zones, dealii::numbers::PI / 2, mesh);
    EXPECT_NEAR(assess(mesh, 1).elements_across_contact, 16, 16 * placement);
    EXPECT_NEAR(total_volume(mesh), enclosed_volume(mesh), 1e-11 * total_volume(mesh));
  }

  TEST(WedgeMeshes, stretch_multiplies_every_length)
  {
    Zones zones;
    zones.resolution = 6;
    Body mesh, stretched;
    make_wedge_mesh(zones, dealii::numbers::PI / 4, mesh);
    zones.stretch = 1.37;
    make_wedge_mesh(zones, dealii::numbers::PI / 4, stretched);
    ASSERT_EQ(stretched.n_vertices(), mesh.n_vertices());
    for (unsigned int v = 0; v < mesh.n_vertices(); ++v)
      for (unsigned int d = 0; d < 3; ++d)
        EXPECT_DOUBLE_EQ(stretched.get_vertices()[v][d], 1.37 * mesh.get_vertices()[v][d]);
  }

  TEST(WedgeMeshes, are_valid_at_every_resolution)
  {
    for (unsigned int resolution = 4; resolution <= 26; ++resolution)
      for (const double angle : {dealii::numbers::PI / 4, dealii::numbers::PI / 2})
        {
          SCOPED_TRACE(resolution);
          Zones zones;
          zones.resolution = resolution;
          Body mesh;
          make_wedge_mesh(zones, angle, mesh);
          const MeshQuality quality = assess(mesh, 1);
          EXPECT_NEAR(quality.elements_across_contact, resolution, placement * resolution);
          EXPECT_GT(quality.smallest_scaled_jacobian, 0.65);
        }
  }

  TEST(WedgeMeshes, refuse_what_is_out_of_range_and_name_it)
  {
    const auto refused = [](const Zones &zones, const double angle, const char *name) {
      Body mesh;
      expect_refused<InputError>([&] { make_wedge_mesh(zones, angle, mesh); }, name);
      EXPECT_EQ(mesh.n_active_cells(), 0u);
    };
    for (const double angle : {0.,
                               -dealii::numbers::PI / 2,
                               dealii::numbers::PI,
                               1.,
                               3 * dealii::numbers::PI,
                               std::numeric_limits<double>::quiet_NaN()})
      refused({}, angle, "angle");
    Zones zones;
    zones.resolution = 3;
    refused(zones, dealii::numbers::PI / 2, "resolution");
    zones         = {};
    zones.octaves = 1;
    refused(zones, dealii::numbers::PI / 2, "octaves");
    zones        = {};
    zones.growth = 0.5;
    refused(zones, dealii::numbers::PI / 2, "growth");
  }

  TEST(SectionMap, makes_a_kite_within_and_circles_without)
  {
    for (const double angle : {dealii::numbers::PI / 4, dealii::numbers::PI / 2})
      {
        const SectionMap map{angle, 0.4 * angle, 0.5, 0.9};
        EXPECT_EQ(map(0, 0).norm(), 0);
        for (const double a : {0.25, 0.5, 0.7, 0.9, 3.})
          {
            EXPECT_NEAR(map(a, 0).distance({a, 0}), 0, 1e-15);
            EXPECT_NEAR(map(0, a).distance({a * std::cos(angle), a * std::sin(angle)}), 0, 1e-15);
          }
        const auto m = map(0.5, 0.5);
        EXPECT_NEAR(m.norm(), 1.15 * 0.5, 1e-15);
        EXPECT_NEAR(std::atan2(m[1], m[0]), 0.4 * angle, 1e-15);
        for (const double t : {0., 0.3, 1.})
          for (const double rho : {0.9, 1., 7.})
            {
              const auto p = map(rho, t * rho), q = map(t * rho, rho);
              EXPECT_NEAR(p.norm(), rho, 1e-14);
              EXPECT_NEAR(std::atan2(p[1], p[0]), 0.4 * angle * t, 1e-14);
              EXPECT_NEAR(std::atan2(q[1], q[0]), angle - 0.6 * angle * t, 1e-14);
            }
        // Continuous across the kite's sides, the diagonal and the first circle.
        for (const double t : {0.1, 0.5, 0.9})
          for (const double rho : {0.5, 0.9})
            {
              const double next = rho * (1 + 1e-12);
              EXPECT_LT(map(rho, t * rho).distance(map(next, t * next)), 1e-11);
              EXPECT_LT(map(t * rho, rho).distance(map(t * next, next)), 1e-11);
            }
        EXPECT_LT(map(0.7, 0.7 * (1 + 1e-12)).distance(map(0.7 * (1 + 1e-12), 0.7)), 1e-11);
      }
  }
} // namespace
