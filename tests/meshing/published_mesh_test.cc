#include "meshing/errors.h"
#include "meshing/gmsh_session.h"
#include "meshing/published_mesh.h"
#include "meshing/quality.h"
#include "tests/support/plane_meshes.h"

#include <cmath>
#include <limits>

using namespace dpcontact;
using namespace dpcontact::tests;

namespace
{
  TEST(PublishedMesh, has_the_elements_that_the_printed_counts_imply)
  {
    Mesh mesh;
    make_published_mesh({}, mesh);
    const std::size_t radial = surface_faces(mesh).size(), layers = axis_faces(mesh).size();
    EXPECT_EQ(radial, 40u + 6u + 7u);
    EXPECT_EQ(layers, 25u);
    EXPECT_EQ(mesh.n_active_cells(), radial * layers);
    EXPECT_EQ(mesh.n_used_vertices(), (radial + 1) * (layers + 1));

    // The body of which this is the section along the core's longer side: rings of 60 round a core
    // of 14 × 16 give the printed bricks and nodes.
    const std::size_t rings = radial - 16 / 2;
    EXPECT_EQ((60 * rings + 14 * 16) * layers, 73100u);
    EXPECT_EQ((60 * rings + 15 * 17) * (layers + 1), 76830u);
  }

  TEST(PublishedMesh, has_the_printed_radial_sizes_in_each_zone)
  {
    Mesh mesh;
    make_published_mesh({}, mesh);
    for (const auto &[inner, outer] : surface_faces(mesh))
      {
        const double middle = (inner + outer) / 2;
        const double size   = middle < 0.002 ? 5e-5 : middle < 0.005 ? 5e-4 : 1e-3;
        // gmsh places the points to about 1e-12 of a zone's line.
        EXPECT_NEAR(outer - inner, size, 1e-13) << "at r = " << inner;
      }
  }

  TEST(PublishedMesh, has_layers_graded_from_the_printed_thickness_to_the_other)
  {
    Mesh mesh;
    make_published_mesh({}, mesh);
    const auto   layers = axis_faces(mesh);
    const double ratio  = std::pow(10., 1. / 24);
    double       size = 2e-4, depth = 0;
    for (const auto &[upper, lower] : layers)
      {
        // gmsh integrates the grading numerically, to about 2e-9 of the line.
        EXPECT_NEAR(upper, depth, 1e-8 * PublishedMesh::depth());
        EXPECT_NEAR(lower - upper, size, 1e-6 * size);
        depth += size;
        size *= ratio;
      }
    EXPECT_NEAR(layers.front().second, 2e-4, 2e-10);
    EXPECT_NEAR(layers.back().second - layers.back().first, 2e-3, 2e-9);
    EXPECT_NEAR(depth, PublishedMesh::depth(), 1e-14);
    EXPECT_NEAR(PublishedMesh::depth(), 0.019876, 5e-7); // 2e-4 (10^(25/24) - 1) / (10^(1/24) - 1)
  }

  TEST(PublishedMesh, names_its_boundary_and_fills_its_rectangle)
  {
    for (const double outer : {0.006, 0.012, 0.024, 0.1})
      {
        SCOPED_TRACE(outer);
        PublishedMesh published;
        published.outer_radius = outer;
        Mesh mesh;
        make_published_mesh(published, mesh);
        const double depth = PublishedMesh::depth();
        expect_boundary_lengths(mesh, depth, outer, depth + outer);
        EXPECT_NEAR(total_area(mesh), outer * depth, 1e-12 * outer * depth);
        EXPECT_NO_THROW(check_mesh(mesh));
        EXPECT_EQ(surface_faces(mesh).size(), 46u + std::lround((outer - 0.005) / 1e-3));
        EXPECT_NEAR(assess(mesh, 1e-3).domain_radius, std::min(outer, depth), 1e-12);
      }
  }

  TEST(PublishedMesh, fits_zone_three_to_an_outer_radius_between_whole_elements)
  {
    PublishedMesh published;
    published.outer_radius = 0.0124;
    Mesh mesh;
    make_published_mesh(published, mesh);
    const auto faces = surface_faces(mesh);
    EXPECT_EQ(faces.size(), 46u + 7u);
    EXPECT_NEAR(faces.back().second, 0.0124, 1e-14);
    EXPECT_NEAR(faces.back().second - faces.back().first, 0.0074 / 7, 1e-14);
  }

  TEST(PublishedMesh, has_rectangles_as_slender_as_the_printed_sizes_make_them)
  {
    Mesh mesh;
    make_published_mesh({}, mesh);
    const MeshQuality quality = assess(mesh, 1e-3);
    EXPECT_NEAR(quality.smallest_scaled_jacobian, 1, 1e-12);
    // The lowest layer under zone I; gmsh's grading as above.
    EXPECT_NEAR(quality.largest_aspect_ratio, 2e-3 / 5e-5, 40 * 1e-6);
    EXPECT_NEAR(quality.smallest_cell_area, 5e-5 * 2e-4, 1e-6 * 5e-5 * 2e-4);
    EXPECT_NEAR(quality.largest_cell_area, 1e-3 * 2e-3, 1e-6 * 1e-3 * 2e-3);
    EXPECT_NEAR(quality.elements_across_contact, 1e-3 / 5e-5, 1e-10);
    EXPECT_EQ(quality.n_hanging_nodes, 0u);
  }

  TEST(PublishedMesh, measures_lengths_in_the_given_unit)
  {
    PublishedMesh published;
    Mesh          metres, scaled;
    make_published_mesh(published, metres);
    published.unit = 9e-4;
    make_published_mesh(published, scaled);
    ASSERT_EQ(scaled.n_vertices(), metres.n_vertices());
    for (unsigned int v = 0; v < metres.n_vertices(); ++v)
      for (const unsigned int d : {0u, 1u})
        EXPECT_DOUBLE_EQ(scaled.get_vertices()[v][d], metres.get_vertices()[v][d] / 9e-4);
    EXPECT_NEAR(assess(scaled, 1).elements_across_contact, 18, 1e-10);
  }

  TEST(PublishedMesh, is_the_same_bit_for_bit_when_made_again_and_quartered_by_a_level)
  {
    PublishedMesh published;
    Mesh          once, twice, fine;
    make_published_mesh(published, once);
    make_published_mesh(published, twice);
    EXPECT_EQ(fingerprint(once), fingerprint(twice));
    published.refinements = 1;
    make_published_mesh(published, fine);
    EXPECT_EQ(fine.n_active_cells(), 4 * once.n_active_cells());
  }

  TEST(PublishedMesh, refuses_each_quantity_out_of_range_and_names_it)
  {
    const double nan     = std::numeric_limits<double>::quiet_NaN();
    const double inf     = std::numeric_limits<double>::infinity();
    const auto   refused = [](const PublishedMesh &published, const char *name) {
      Mesh mesh;
      expect_refused<InputError>([&] { make_published_mesh(published, mesh); }, name);
      EXPECT_EQ(mesh.n_active_cells(), 0u);
    };
    for (const double value : {0., -1., 0.005, 0.11, nan, inf})
      refused({value, 0, 1}, "outer-radius");
    refused({0.012, 7, 1}, "level");
    for (const double value : {0., -1., nan, inf})
      refused({0.012, 0, value}, "unit");
  }
} // namespace
