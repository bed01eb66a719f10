#include "meshing/errors.h"
#include "meshing/quality.h"
#include "tests/support/plane_meshes.h"

#include <deal.II/grid/grid_generator.h>

#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

using namespace dpcontact;
using namespace dpcontact::tests;

namespace
{
  /// width × depth in columns × rows of rectangles, with its boundary named.
  void make_rectangle(Mesh              &mesh,
                      const unsigned int columns,
                      const unsigned int rows,
                      const double       width,
                      const double       depth)
  {
    dealii::GridGenerator::subdivided_hyper_rectangle(
      mesh, {columns, rows}, dealii::Point<2>(0, -depth), dealii::Point<2>(width, 0));
    for (const auto &cell : mesh.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          face->set_boundary_id(face->center()[0] == 0   ? boundary::axis
                                : face->center()[1] == 0 ? boundary::surface
                                                         : boundary::far);
  }

  /// Each expected value is a closed form of a handful of operations.
  constexpr double rounding_of_quality = 1e-14;

  TEST(Quality, of_equal_rectangles)
  {
    Mesh mesh;
    make_rectangle(mesh, 4, 3, 8, 3);
    const MeshQuality quality = assess(mesh, 5);
    EXPECT_EQ(quality.n_cells, 12u);
    EXPECT_EQ(quality.n_hanging_nodes, 0u);
    EXPECT_NEAR(quality.smallest_scaled_jacobian, 1, rounding_of_quality);
    EXPECT_NEAR(quality.mean_scaled_jacobian, 1, rounding_of_quality);
    EXPECT_NEAR(quality.largest_aspect_ratio, 2, rounding_of_quality);
    EXPECT_NEAR(quality.mean_aspect_ratio, 2, rounding_of_quality);
    EXPECT_NEAR(quality.smallest_cell_area, 2, rounding_of_quality);
    EXPECT_NEAR(quality.largest_cell_area, 2, rounding_of_quality);
    EXPECT_NEAR(quality.elements_across_contact, 2.5, rounding_of_quality);
    EXPECT_NEAR(quality.domain_radius, 3, rounding_of_quality); // the bottom, not the outer side
  }

  TEST(Quality, of_a_parallelogram_is_the_sine_of_its_angle)
  {
    for (const double angle : {0.1, 0.5, 1.0, 1.5, 2.5})
      {
        Mesh mesh;
        make_rectangle(mesh, 1, 1, 1, 1);
        const auto cell = mesh.begin_active();
        cell->vertex(0) =
          cell->vertex(2) - dealii::Point<2>(3 * std::cos(angle), 3 * std::sin(angle));
        cell->vertex(1)           = cell->vertex(0) + dealii::Point<2>(1, 0);
        const MeshQuality quality = assess(mesh, 1);
        EXPECT_NEAR(quality.smallest_scaled_jacobian, std::sin(angle), rounding_of_quality);
        EXPECT_NEAR(quality.largest_aspect_ratio, 3, 10 * rounding_of_quality);
        EXPECT_NEAR(quality.smallest_cell_area, 3 * std::sin(angle), rounding_of_quality);
      }
  }

  TEST(Quality, of_an_inverted_cell_is_negative)
  {
    for (const unsigned int corner : {0u, 1u})
      {
        Mesh mesh;
        make_rectangle(mesh, 1, 1, 1, 1);
        const auto cell = mesh.begin_active();
        // The corner at three quarters of the diagonal: (0.75, 0.75) of the unit square. There the
        // edges (-0.75, 0.25) and (0.25, -0.75) meet at a sine of -(0.75² - 0.25²)/(0.75² + 0.25²)
        // = -0.8.
        cell->vertex(corner) += 1.5 * (cell->center() - cell->vertex(corner));
        EXPECT_NEAR(assess(mesh, 1).smallest_scaled_jacobian, -0.8, rounding_of_quality);
      }
  }

  TEST(Quality, averages_over_the_cells_and_counts_hanging_nodes)
  {
    Mesh mesh;
    make_rectangle(mesh, 3, 3, 3, 6);
    // The middle cell: each of its four sides gets a hanging node.
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->center().distance(dealii::Point<2>(1.5, -3)) < 0.1)
        cell->set_refine_flag();
    mesh.execute_coarsening_and_refinement();
    MeshQuality quality = assess(mesh, 1);
    EXPECT_EQ(quality.n_cells, 12u);
    EXPECT_EQ(quality.n_hanging_nodes, 4u);
    EXPECT_NEAR(quality.smallest_cell_area, 0.5, rounding_of_quality);
    EXPECT_NEAR(quality.largest_cell_area, 2, rounding_of_quality);
    EXPECT_NEAR(quality.mean_aspect_ratio, 2, rounding_of_quality);

    // Along the surface 2 halved cells and 1 whole one; below, 2 + 2 new hanging nodes replace 1.
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->level() == 0 && cell->center()[1] > -2 && cell->center()[0] < 2)
        cell->set_refine_flag();
    mesh.execute_coarsening_and_refinement();
    quality = assess(mesh, 2.5);
    EXPECT_EQ(quality.n_hanging_nodes, 3u + 1u + 1u);
    EXPECT_NEAR(quality.elements_across_contact, 4.5, rounding_of_quality);
  }

  TEST(Quality, counts_the_cut_face_by_its_fraction)
  {
    Mesh mesh;
    make_rectangle(mesh, 10, 1, 1, 1);
    for (const double radius : {0.01, 0.1, 0.25, 0.999, 1.})
      EXPECT_NEAR(assess(mesh, radius).elements_across_contact, 10 * radius, 1e-13);
  }

  TEST(Quality, refuses_what_it_cannot_judge)
  {
    Mesh mesh;
    make_rectangle(mesh, 2, 2, 1, 1);
    for (const double radius : {0.,
                                -1.,
                                1.01,
                                std::numeric_limits<double>::infinity(),
                                std::numeric_limits<double>::quiet_NaN()})
      expect_refused<InputError>([&] { assess(mesh, radius); }, "contact_radius");
    expect_refused<SolverError>([] { assess(Mesh(), 1); }, "no cells");
    Mesh triangles;
    dealii::GridGenerator::subdivided_hyper_cube_with_simplices(triangles, 1);
    expect_refused<SolverError>([&] { assess(triangles, 1); }, "quadrilaterals");
  }

  TEST(Quality, prints_each_figure_on_a_line_and_leaves_the_stream_as_it_was)
  {
    MeshQuality quality;
    quality.n_cells                  = 309;
    quality.n_hanging_nodes          = 32;
    quality.smallest_scaled_jacobian = 0.7071;
    quality.mean_scaled_jacobian     = 0.97594;
    quality.largest_aspect_ratio     = 1.5282;
    quality.mean_aspect_ratio        = 1.1642;
    quality.smallest_cell_area       = 0.0025;
    quality.largest_cell_area        = 2532.7;
    quality.elements_across_contact  = 20;
    quality.domain_radius            = 200;
    std::ostringstream out;
    out << std::setprecision(3);
    print(quality, out);
    EXPECT_EQ(out.str(),
              "mesh quality\n"
              "  cells                       309\n"
              "  hanging nodes               32\n"
              "  scaled Jacobian, smallest   0.7071\n"
              "  scaled Jacobian, mean       0.97594\n"
              "  aspect ratio, largest       1.5282\n"
              "  aspect ratio, mean          1.1642\n"
              "  cell area, smallest         0.0025\n"
              "  cell area, largest          2532.7\n"
              "  elements across the contact 20\n"
              "  domain radius               200\n");
    EXPECT_EQ(out.precision(), 3);
  }
} // namespace
