#include "meshing/errors.h"
#include "meshing/quality.h"
#include "meshing/sphere_cap.h"
#include "meshing/zoned_mesh.h"
#include "tests/support/plane_meshes.h"

#include <cmath>
#include <sstream>

namespace
{
  using namespace dpcontact;
  using namespace dpcontact::tests;

  /// κ = a/R; the far boundary lies at a distance of R.
  class SphereCap : public ::testing::TestWithParam<double>
  {
  protected:
    SphereCap()
    {
      Zones zones;
      zones.resolution    = 40;
      zones.domain_radius = R;
      make_zoned_mesh(zones, mesh);
      make_zoned_mesh(zones, flat);
      map_to_sphere(R, mesh);
    }

    const double R = 1 / GetParam();
    Mesh         mesh, flat;
  };

  TEST_P(SphereCap, surface_vertices_lie_on_the_sphere_and_the_axis_stays)
  {
    unsigned int surface = 0, axis = 0, far = 0;
    for (const auto &cell : mesh.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          for (const unsigned int v : {0u, 1u})
            {
              const double r = face->vertex(v)[0], y = face->vertex(v)[1];
              if (face->boundary_id() == boundary::surface)
                {
                  ++surface;
                  EXPECT_NEAR((r * r + (y + R) * (y + R)) / (R * R), 1, 1e-14);
                }
              else if (face->boundary_id() == boundary::axis)
                {
                  ++axis;
                  EXPECT_NEAR(r, 0, 1e-14 * R);
                }
              else
                {
                  ++far;
                  EXPECT_NEAR(std::hypot(r, y) / R, 1, 1e-12);
                }
            }
    EXPECT_GT(surface, 20u);
    EXPECT_GT(axis, 20u);
    EXPECT_GE(far, 8u);
  }

  TEST_P(SphereCap, every_jacobian_stays_positive_and_far_from_zero)
  {
    EXPECT_GT(assess(mesh, 1).smallest_scaled_jacobian, 0.5);
  }

  TEST_P(SphereCap, hanging_nodes_stay_in_the_middle_of_their_edges)
  {
    unsigned int hanging = 0;
    for (const auto &cell : mesh.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->has_children())
          {
            ++hanging;
            const auto middle = (face->vertex(0) + face->vertex(1)) / 2.;
            EXPECT_LT(face->child(0)->vertex(1).distance(middle), 1e-14 * R);
          }
    EXPECT_GT(hanging, 50u);
  }

  TEST_P(SphereCap, the_cells_fill_their_boundary_without_gap_or_overlap)
  {
    // Area of the polygon by Green's theorem over the boundary faces.
    double enclosed = 0;
    for (const auto &cell : mesh.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          {
            const auto             along = face->vertex(1) - face->vertex(0);
            dealii::Tensor<1, 2>   normal({along[1], -along[0]});
            const dealii::Point<2> middle = face->center();
            if (normal * (middle - cell->center()) < 0)
              normal *= -1;
            enclosed += 0.5 * (normal * dealii::Tensor<1, 2>(middle));
          }
    EXPECT_NEAR(total_area(mesh) / enclosed, 1, 1e-12);
    EXPECT_LT(total_area(mesh), total_area(flat));
  }

  INSTANTIATE_TEST_SUITE_P(CurvedLittleAndMuch, SphereCap, ::testing::Values(0.005, 0.02, 0.1));

  TEST(SphereCapMesh, a_point_of_the_surface_keeps_its_distance_from_the_contact)
  {
    const auto p = to_sphere({0.7, 0}, 2.);
    EXPECT_NEAR(p.norm(), 0.7, 1e-15);
    EXPECT_NEAR(p[1], -0.7 * 0.7 / 4, 1e-15);
    EXPECT_EQ(to_sphere({0, 0}, 2.).norm(), 0.);
  }

  TEST(SphereCapMesh, a_far_boundary_beyond_the_radius_is_refused_by_name)
  {
    Zones zones;
    zones.resolution    = 8;
    zones.domain_radius = 30;
    Mesh mesh;
    make_zoned_mesh(zones, mesh);
    const auto before = fingerprint(mesh);
    expect_refused<InputError>([&] { map_to_sphere(29.9, mesh); }, "domain-radius");
    EXPECT_EQ(fingerprint(mesh), before);
    EXPECT_NO_THROW(map_to_sphere(30, mesh));
  }
} // namespace
