#include "meshing/errors.h"
#include "meshing/gmsh_session.h"
#include "meshing/quality.h"
#include "meshing/wedge_mesh.h"
#include "tests/support/space_meshes.h"

#include <deal.II/base/numbers.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <gmsh.h>

#include <cmath>
#include <sstream>

using namespace dpcontact;
using namespace dpcontact::tests;

namespace
{
  /// x from 0 to 4, y from 0 to 2, z from −3 to 0 in bricks of 1 × 1 × 1.5, with its boundary
  /// named.
  void make_box(Body &mesh)
  {
    dealii::GridGenerator::subdivided_hyper_rectangle(
      mesh, {4u, 2u, 2u}, dealii::Point<3>(0, 0, -3), dealii::Point<3>(4, 2, 0));
    for (const auto &cell : mesh.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          face->set_boundary_id(face->center()[0] * face->center()[1] == 0 ? boundary::axis
                                : face->center()[2] == 0                   ? boundary::surface
                                                                           : boundary::far);
  }

  TEST(CheckBricks, finds_every_boundary_face_with_a_wrong_id)
  {
    for (const double angle :
         {dealii::numbers::PI / 4, dealii::numbers::PI / 2, 2 * dealii::numbers::PI})
      {
        Zones zones;
        zones.resolution = 4;
        Body mesh;
        make_wedge_mesh(zones, angle, mesh);
        unsigned int faces = 0;
        for (const auto &cell : mesh.active_cell_iterators())
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() && faces++ % 7 == 0)
              {
                const auto id = face->boundary_id();
                for (const unsigned int wrong : {0u, id % 3 + 1, (id + 1) % 3 + 1})
                  {
                    face->set_boundary_id(wrong);
                    expect_refused<SolverError>([&] { check_mesh(mesh, angle); },
                                                "has id " + std::to_string(wrong) + ", expected " +
                                                  std::to_string(id));
                  }
                face->set_boundary_id(id);
              }
        EXPECT_GT(faces, 200u);
        EXPECT_NO_THROW(check_mesh(mesh, angle));
        // Planes of symmetry elsewhere than asked for; the whole has none.
        if (angle < dealii::numbers::PI)
          expect_refused<SolverError>(
            [&] { check_mesh(mesh, dealii::numbers::PI * 3 / 4 - angle); }, "expected");
      }
  }

  TEST(CheckBricks, finds_an_inverted_brick_by_any_of_its_corners)
  {
    for (unsigned int corner = 0; corner < 8; ++corner)
      {
        Body mesh;
        dealii::GridGenerator::hyper_rectangle(mesh, {0, 0, -1}, {1, 1, 0});
        ASSERT_NO_THROW(check_jacobians(mesh));
        // Drawn along the diagonal the corner's own Jacobian vanishes in the plane of its
        // neighbours, a third of the way: from there on it is negative.
        auto                      &vertex  = mesh.begin_active()->vertex(corner);
        const dealii::Point<3>     there   = vertex;
        const dealii::Tensor<1, 3> inwards = 2. * (mesh.begin_active()->center() - there);
        vertex                             = there + 0.3 * inwards;
        EXPECT_NO_THROW(check_jacobians(mesh));
        vertex = there + 0.36 * inwards;
        expect_refused<SolverError>([&] { check_jacobians(mesh); }, "Jacobian not positive");
      }
  }

  TEST(CheckBricks, finds_tetrahedra)
  {
    Body mesh;
    dealii::GridGenerator::subdivided_hyper_cube_with_simplices(mesh, 1);
    expect_refused<SolverError>([&] { check_mesh(mesh); }, "no brick");
    expect_refused<SolverError>([&] { assess(mesh, 1); }, "bricks");
  }

  TEST(GmshSession, refuses_tetrahedra)
  {
    Body              mesh;
    const GmshSession session;
    gmsh::model::occ::addBox(0, 0, -1, 1, 1, 1);
    gmsh::model::occ::synchronize();
    expect_refused<SolverError>([&] { session.mesh_into(mesh); }, "bricks");
  }

  TEST(BrickQuality, of_equal_boxes)
  {
    Body mesh;
    make_box(mesh);
    const MeshQuality quality = assess(mesh, 2.5);
    EXPECT_EQ(quality.n_cells, 16u);
    EXPECT_EQ(quality.n_hanging_nodes, 0u);
    EXPECT_NEAR(quality.smallest_scaled_jacobian, 1, 1e-14);
    EXPECT_NEAR(quality.largest_aspect_ratio, 1.5, 1e-14);
    EXPECT_NEAR(quality.smallest_cell_area, 1.5, 1e-14);
    EXPECT_NEAR(quality.largest_cell_area, 1.5, 1e-14);
    EXPECT_NEAR(quality.elements_across_contact, 2.5, 1e-14); // along y = 0
    EXPECT_NEAR(quality.domain_radius, 2, 1e-14);             // (0, 2, 0)
    EXPECT_THROW(assess(mesh, 4.01), InputError);
    std::ostringstream out;
    print(quality, out);
    EXPECT_NE(out.str().find("cell volume, smallest       1.5\n"), std::string::npos) << out.str();
  }

  TEST(BrickQuality, of_a_parallelepiped_is_its_volume_by_its_edges)
  {
    Body mesh;
    make_box(mesh);
    // Edges a, b, c of lengths 1, 1, 1.5 sheared: a·(b × c) / (|a| |b| |c|) at every corner.
    dealii::GridTools::transform(
      [](const dealii::Point<3> &p) {
        return dealii::Point<3>(p[0] + 0.5 * p[1] + 0.2 * p[2], p[1] - 0.4 * p[2], p[2]);
      },
      mesh);
    const double      b = std::hypot(1, 0.5), c = 1.5 * std::sqrt(1 + 0.2 * 0.2 + 0.4 * 0.4);
    const MeshQuality quality = assess(mesh, 1);
    EXPECT_NEAR(quality.smallest_scaled_jacobian, 1.5 / (b * c), 1e-14);
    EXPECT_NEAR(quality.mean_scaled_jacobian, 1.5 / (b * c), 1e-14);
    EXPECT_NEAR(quality.largest_aspect_ratio, c, 1e-14);
    EXPECT_NEAR(quality.largest_cell_area, 1.5, 1e-14);
  }

  TEST(BrickQuality, counts_hanging_vertices_once)
  {
    Body mesh;
    make_box(mesh);
    mesh.begin_active()->set_refine_flag();
    mesh.execute_coarsening_and_refinement();
    // The brick in the corner meets others with three faces: 3 middles, and their 9 edges.
    EXPECT_EQ(assess(mesh, 1).n_hanging_nodes, 3u + 9u);
  }
} // namespace
