#include "meshing/errors.h"
#include "meshing/gmsh_session.h"
#include "meshing/mesh_kind.h"
#include "meshing/zoned_mesh.h"
#include "tests/support/plane_meshes.h"

#include <deal.II/grid/grid_generator.h>

#include <gmsh.h>

using namespace dpcontact;
using namespace dpcontact::tests;

namespace
{
  void make_small_mesh(Mesh &mesh)
  {
    Zones zones;
    zones.resolution = 4;
    make_zoned_mesh(zones, mesh);
  }

  TEST(CheckMesh, finds_every_boundary_face_with_a_wrong_id)
  {
    Mesh mesh;
    make_small_mesh(mesh);
    unsigned int faces = 0;
    for (const auto &cell : mesh.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          {
            const auto id = face->boundary_id();
            for (const unsigned int wrong : {0u, id % 3 + 1, (id + 1) % 3 + 1})
              {
                face->set_boundary_id(wrong);
                expect_refused<SolverError>([&] { check_mesh(mesh); },
                                            "has id " + std::to_string(wrong) + ", expected " +
                                              std::to_string(id));
              }
            face->set_boundary_id(id);
            ++faces;
          }
    EXPECT_GT(faces, 3u);
    EXPECT_NO_THROW(check_mesh(mesh));
  }

  TEST(CheckMesh, finds_an_inverted_cell_by_any_of_its_corners)
  {
    for (const unsigned int corner : {0u, 1u, 2u, 3u})
      {
        Mesh mesh;
        dealii::GridGenerator::hyper_rectangle(mesh, {0, -1}, {1, 0});
        for (const auto &face : mesh.begin_active()->face_iterators())
          face->set_boundary_id(face->center()[0] == 0   ? boundary::axis
                                : face->center()[1] == 0 ? boundary::surface
                                                         : boundary::far);
        ASSERT_NO_THROW(check_mesh(mesh));
        // Drawn past the diagonal, the corner turns concave; the boundary's names play no part yet.
        auto &vertex = mesh.begin_active()->vertex(corner);
        vertex       = vertex + 1.2 * (mesh.begin_active()->center() - vertex);
        expect_refused<SolverError>([&] { check_mesh(mesh); }, "Jacobian not positive");
      }
  }

  TEST(CheckMesh, finds_triangles)
  {
    Mesh mesh;
    dealii::GridGenerator::subdivided_hyper_cube_with_simplices(mesh, 1);
    expect_refused<SolverError>([&] { check_mesh(mesh); }, "no quadrilateral");
  }

  TEST(GmshSession, refuses_triangles_and_leaves_gmsh_usable)
  {
    Mesh triangles;
    {
      const GmshSession session;
      gmsh::model::occ::addRectangle(0, -1, 0, 1, 1);
      gmsh::model::occ::synchronize();
      expect_refused<SolverError>([&] { session.mesh_into(triangles); }, "triangles");
    }
    Mesh mesh;
    EXPECT_NO_THROW(make_small_mesh(mesh));
  }

  TEST(MeshKind, is_parsed_from_its_own_names_only)
  {
    for (const MeshKind kind : {MeshKind::fitted, MeshKind::published})
      EXPECT_EQ(parse_enum<MeshKind>(to_string(kind)), kind);
    EXPECT_EQ(parse_enum<MeshKind>("published"), MeshKind::published);
    for (const char *const name : {"", "Fitted", "fitted ", "wang"})
      expect_refused<InputError>([&] { parse_enum<MeshKind>(name); },
                                 "'" + std::string(name) + "'");
  }
} // namespace
