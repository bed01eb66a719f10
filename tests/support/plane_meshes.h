#ifndef DPCONTACT_TESTS_SUPPORT_PLANE_MESHES_H
#define DPCONTACT_TESTS_SUPPORT_PLANE_MESHES_H

#include "meshing/boundary_ids.h"

#include <deal.II/grid/tria.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace dpcontact::tests
{
  using Mesh = dealii::Triangulation<2>;

  /// Summed lengths of the boundary faces of each id.
  inline std::map<unsigned int, double> boundary_lengths(const Mesh &mesh)
  {
    std::map<unsigned int, double> lengths;
    for (const auto &cell : mesh.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          lengths[face->boundary_id()] += face->vertex(0).distance(face->vertex(1));
    return lengths;
  }

  /// All of the boundary is named, and each part is as long as said. Sums of at most a few hundred
  /// lengths, from coordinates that gmsh writes with 16 digits: 1e-12 leaves three orders to spare.
  inline void expect_boundary_lengths(const Mesh  &mesh,
                                      const double axis,
                                      const double surface,
                                      const double far)
  {
    const auto lengths = boundary_lengths(mesh);
    ASSERT_EQ(lengths.size(), 3u);
    EXPECT_NEAR(lengths.at(boundary::axis), axis, 1e-12 * axis);
    EXPECT_NEAR(lengths.at(boundary::surface), surface, 1e-12 * surface);
    EXPECT_NEAR(lengths.at(boundary::far), far, 1e-12 * far);
  }

  inline double total_area(const Mesh &mesh)
  {
    double area = 0;
    for (const auto &cell : mesh.active_cell_iterators())
      area += cell->measure();
    return area;
  }

  /// (inner, outer) radius of the surface faces, outwards from the axis.
  inline std::vector<std::pair<double, double>> surface_faces(const Mesh &mesh)
  {
    std::vector<std::pair<double, double>> faces;
    for (const auto &cell : mesh.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && face->boundary_id() == boundary::surface)
          faces.push_back(std::minmax({face->vertex(0)[0], face->vertex(1)[0]}));
    std::sort(faces.begin(), faces.end());
    return faces;
  }

  /// (upper, lower) depth of the axis faces, downwards from the surface.
  inline std::vector<std::pair<double, double>> axis_faces(const Mesh &mesh)
  {
    std::vector<std::pair<double, double>> faces;
    for (const auto &cell : mesh.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && face->boundary_id() == boundary::axis)
          faces.push_back(std::minmax({-face->vertex(0)[1], -face->vertex(1)[1]}));
    std::sort(faces.begin(), faces.end());
    return faces;
  }

  /// Every active cell's vertices, face ids and level, in order: equal means the same bit for bit.
  template <int dim>
  std::vector<double> fingerprint(const dealii::Triangulation<dim> &mesh)
  {
    std::vector<double> numbers;
    for (const auto &cell : mesh.active_cell_iterators())
      {
        numbers.push_back(cell->level());
        for (const unsigned int v : cell->vertex_indices())
          {
            numbers.push_back(cell->vertex_index(v));
            for (unsigned int d = 0; d < dim; ++d)
              numbers.push_back(cell->vertex(v)[d]);
          }
        for (const auto &face : cell->face_iterators())
          numbers.push_back(face->boundary_id());
      }
    return numbers;
  }

  /// Runs `action`, which must throw an `Exception` whose message contains `text`.
  template <typename Exception, typename Action>
  void expect_refused(const Action &action, const std::string &text)
  {
    try
      {
        action();
        ADD_FAILURE() << "accepted; expected a refusal that says '" << text << "'";
      }
    catch (const Exception &exception)
      {
        EXPECT_NE(std::string(exception.what()).find(text), std::string::npos) << exception.what();
      }
  }
} // namespace dpcontact::tests

#endif
