#include "meshing/errors.h"
#include "meshing/partition.h"
#include "meshing/wedge_mesh.h"
#include "tests/support/space_meshes.h"

#include <deal.II/base/numbers.h>
#include <deal.II/grid/grid_generator.h>

#include <numeric>

using namespace dpcontact;
using namespace dpcontact::tests;

namespace
{
  class Partition : public ::testing::TestWithParam<unsigned int>
  {
  protected:
    static void make(Body &mesh)
    {
      Zones zones;
      zones.resolution = 8;
      make_wedge_mesh(zones, dealii::numbers::PI / 2, mesh);
    }
    Partition() { make(mesh); }
    Body mesh;
  };

  INSTANTIATE_TEST_SUITE_P(Parts, Partition, ::testing::Values(1u, 2u, 3u, 4u, 8u));

  std::vector<unsigned int> parts_of(const Body &mesh)
  {
    std::vector<unsigned int> parts;
    for (const auto &cell : mesh.active_cell_iterators())
      parts.push_back(cell->subdomain_id());
    return parts;
  }

  TEST_P(Partition, is_balanced_and_reported_as_it_stands)
  {
    const PartitionReport report = partition(GetParam(), mesh);
    ASSERT_EQ(report.cells_of_part.size(), GetParam());
    const auto                parts = parts_of(mesh);
    std::vector<unsigned int> counts(GetParam(), 0);
    for (const unsigned int part : parts)
      ++counts.at(part);
    EXPECT_EQ(counts, report.cells_of_part);
    EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), 0u), mesh.n_active_cells());
    // METIS' own tolerance is 3 %.
    const double mean = static_cast<double>(mesh.n_active_cells()) / GetParam();
    for (const unsigned int count : counts)
      EXPECT_NEAR(count, mean, 0.03 * mean + 1);

    // Counted the other way, from the coarse side.
    unsigned int twice = 0;
    for (const auto &cell : mesh.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        {
          if (cell->at_boundary(f))
            continue;
          if (!cell->neighbor(f)->has_children() && !cell->neighbor_is_coarser(f))
            twice += cell->neighbor(f)->subdomain_id() != cell->subdomain_id() ? 1 : 0;
          for (unsigned int s = 0; s < cell->face(f)->n_children(); ++s)
            if (cell->neighbor_child_on_subface(f, s)->subdomain_id() != cell->subdomain_id())
              twice += 2;
        }
    EXPECT_EQ(2 * report.cut_faces, twice);
    EXPECT_EQ(report.cut_faces == 0, GetParam() == 1);
    // Each part but the best of shapes has fewer faces cut than a third of its own.
    EXPECT_LT(report.cut_faces, mesh.n_active_cells());
  }

  TEST_P(Partition, is_the_same_when_made_again)
  {
    Body again;
    make(again);
    partition(GetParam(), mesh);
    partition(GetParam(), again);
    EXPECT_EQ(parts_of(mesh), parts_of(again));
    partition(3, again);
    partition(GetParam(), again);
    EXPECT_EQ(parts_of(mesh), parts_of(again));
  }

  TEST(PartitionOfABar, cuts_it_across)
  {
    Body mesh;
    dealii::GridGenerator::subdivided_hyper_rectangle(
      mesh, {32u, 3u, 3u}, dealii::Point<3>(0, 0, 0), dealii::Point<3>(32, 3, 3));
    const PartitionReport report = partition(2, mesh);
    EXPECT_EQ(report.cells_of_part, (std::vector<unsigned int>{144, 144}));
    EXPECT_EQ(report.cut_faces, 9u);
  }

  TEST(PartitionOfAPlane, serves_two_dimensions)
  {
    Mesh mesh;
    dealii::GridGenerator::subdivided_hyper_rectangle(
      mesh, {32u, 3u}, dealii::Point<2>(0, 0), dealii::Point<2>(32, 3));
    EXPECT_EQ(partition(2, mesh).cut_faces, 3u);
  }

  TEST(PartitionCheck, refuses_no_parts_and_more_than_the_cells)
  {
    Body mesh;
    dealii::GridGenerator::subdivided_hyper_cube(mesh, 2);
    for (const unsigned int parts : {0u, 9u})
      expect_refused<InputError>([&] { partition(parts, mesh); },
                                 "parts = " + std::to_string(parts));
    EXPECT_EQ(partition(1, mesh).cells_of_part, std::vector<unsigned int>{8});
  }
} // namespace
