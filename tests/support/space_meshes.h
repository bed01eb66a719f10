#ifndef DPCONTACT_TESTS_SUPPORT_SPACE_MESHES_H
#define DPCONTACT_TESTS_SUPPORT_SPACE_MESHES_H

#include "tests/support/plane_meshes.h"

#include <cmath>
#include <set>

namespace dpcontact::tests
{
  using Body = dealii::Triangulation<3>;

  inline double total_volume(const Body &mesh)
  {
    double volume = 0;
    for (const auto &cell : mesh.active_cell_iterators())
      volume += cell->measure();
    return volume;
  }

  /// Calls `action(cell, face)` for the boundary faces of one id.
  template <typename Action>
  void for_boundary(const Body &mesh, const unsigned int id, const Action &action)
  {
    for (const auto &cell : mesh.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && face->boundary_id() == id)
          action(cell, face);
  }

  /// Area of all faces of one id, which must be plane.
  inline double boundary_area(const Body &mesh, const unsigned int id)
  {
    double area = 0;
    for_boundary(mesh, id, [&area](const auto &, const auto &face) {
      area += 0.5 * dealii::cross_product_3d(face->vertex(3) - face->vertex(0),
                                             face->vertex(2) - face->vertex(1))
                      .norm();
    });
    return area;
  }

  /// Volume within the boundary faces by the divergence theorem: ∮ x·n dA / 3 over the bilinear
  /// faces, quadratic in either parameter, so that two Gauss points each are exact.
  inline double enclosed_volume(const Body &mesh)
  {
    double volume = 0;
    for (const unsigned int id : {boundary::axis, boundary::surface, boundary::far})
      for_boundary(mesh, id, [&volume](const auto &cell, const auto &face) {
        const double gauss[] = {0.5 - std::sqrt(1. / 12), 0.5 + std::sqrt(1. / 12)};
        const auto   a = face->vertex(0), b = face->vertex(1), c = face->vertex(2),
                   d = face->vertex(3);
        double flux  = 0;
        for (const double u : gauss)
          for (const double v : gauss)
            {
              const dealii::Tensor<1, 3> along = (1 - v) * (b - a) + v * (d - c);
              const dealii::Tensor<1, 3> other = (1 - u) * (c - a) + u * (d - b);
              const dealii::Tensor<1, 3> x((1 - v) * ((1 - u) * a + u * b) +
                                           v * ((1 - u) * c + u * d));
              dealii::Tensor<1, 3>       normal = dealii::cross_product_3d(along, other);
              if (normal * (face->center() - cell->center()) < 0)
                normal *= -1;
              flux += x * normal / 4;
            }
        volume += flux / 3;
      });
    return volume;
  }

  /// Indices of the vertices of one id's faces.
  inline std::set<unsigned int> boundary_vertices(const Body &mesh, const unsigned int id)
  {
    std::set<unsigned int> vertices;
    for_boundary(mesh, id, [&vertices](const auto &, const auto &face) {
      for (const unsigned int v : face->vertex_indices())
        vertices.insert(face->vertex_index(v));
    });
    return vertices;
  }

  /// Every vertex in use has a partner at its image, to `tolerance`.
  template <typename Map>
  void expect_invariant(const Body &mesh, const Map &image, const double tolerance)
  {
    std::vector<dealii::Point<3>> points;
    for (unsigned int v = 0; v < mesh.n_vertices(); ++v)
      if (mesh.vertex_used(v))
        points.push_back(mesh.get_vertices()[v]);
    const auto before = [](const auto &p, const auto &q) { return p[0] < q[0]; };
    std::sort(points.begin(), points.end(), before);
    unsigned int alone = 0;
    for (const auto &p : points)
      {
        const dealii::Point<3> q         = image(p);
        auto                   candidate = std::lower_bound(
          points.begin(), points.end(), dealii::Point<3>(q[0] - tolerance, 0, 0), before);
        while (candidate != points.end() && (*candidate)[0] <= q[0] + tolerance &&
               candidate->distance(q) > tolerance)
          ++candidate;
        if (candidate == points.end() || candidate->distance(q) > tolerance)
          ++alone;
      }
    EXPECT_EQ(alone, 0u);
  }
} // namespace dpcontact::tests

#endif
