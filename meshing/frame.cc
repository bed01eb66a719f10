#include "meshing/frame.h"

#include "meshing/boundary_ids.h"
#include "meshing/gmsh_session.h"

#include <deal.II/grid/grid_tools.h>

#include <gmsh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace dpcontact
{
  namespace
  {
    namespace geo = gmsh::model::geo;

    using Corner = dealii::Point<3>;

    /// Transfinite blocks of the open gmsh model that share their points, lines and faces.
    class FrameBlocks
    {
    public:
      /// @param corners numbered lexicographically, as deal.II's; @param cells along each direction.
      void add(const std::array<Corner, 8> &corners, const std::array<unsigned int, 3> &cells)
      {
        std::vector<int> faces;
        for (unsigned int k = 0; k < 3; ++k)
          for (const unsigned int side : {0u, 1u << k})
            {
              const unsigned int i = 1u << (k + 1) % 3, j = 1u << (k + 2) % 3;
              faces.push_back(
                face({corners[side], corners[side + i], corners[side + i + j], corners[side + j]},
                     cells[(k + 1) % 3],
                     cells[(k + 2) % 3]));
            }
        volumes.push_back(geo::addVolume({geo::addSurfaceLoop(faces)}));
        geo::mesh::setTransfiniteVolume(volumes.back());
      }

      /// Names the faces of one block alone by where they lie, and all volumes.
      void name() const
      {
        geo::synchronize();
        std::map<unsigned int, std::vector<int>> groups;
        for (const auto &[key, face] : faces_of)
          if (face.blocks == 1)
            groups[face.boundary].push_back(face.tag);
        for (const auto &[id, tags] : groups)
          gmsh::model::addPhysicalGroup(2, tags, static_cast<int>(id));
        gmsh::model::addPhysicalGroup(3, volumes, 1);
        gmsh::model::setPhysicalName(2, boundary::axis, "axis");
        gmsh::model::setPhysicalName(2, boundary::surface, "surface");
        gmsh::model::setPhysicalName(2, boundary::far, "far");
      }

    private:
      struct Face
      {
        int          tag;
        unsigned int boundary;
        unsigned int blocks;
      };

      int point(const Corner &p)
      {
        const auto [entry, is_new] = points.try_emplace({p[0], p[1], p[2]}, 0);
        if (is_new)
          entry->second = geo::addPoint(p[0], p[1], p[2]);
        return entry->second;
      }

      /// Negative where the line runs from q to p.
      int line(const int p, const int q, const unsigned int cells)
      {
        const auto [entry, is_new] = lines.try_emplace(std::minmax(p, q), 0);
        if (is_new)
          {
            entry->second = geo::addLine(std::min(p, q), std::max(p, q));
            geo::mesh::setTransfiniteCurve(entry->second, static_cast<int>(cells) + 1);
          }
        return p < q ? entry->second : -entry->second;
      }

      /// @param corners once around; the first edge has `cells` cells, the second `others`.
      int face(const std::array<Corner, 4> &corners,
               const unsigned int           cells,
               const unsigned int           others)
      {
        std::array<int, 4> p;
        for (unsigned int i = 0; i < 4; ++i)
          p[i] = point(corners[i]);
        auto key = p;
        std::sort(key.begin(), key.end());
        const auto [entry, is_new] = faces_of.try_emplace(key, Face{0, boundary::far, 0});
        Face &result               = entry->second;
        ++result.blocks;
        if (!is_new)
          return result.tag;
        std::vector<int> loop;
        for (unsigned int i = 0; i < 4; ++i)
          loop.push_back(line(p[i], p[(i + 1) % 4], i % 2 == 0 ? cells : others));
        result.tag = geo::addPlaneSurface({geo::addCurveLoop(loop)});
        geo::mesh::setTransfiniteSurface(result.tag);
        geo::mesh::setRecombine(2, result.tag);
        for (unsigned int k = 0; k < 3; ++k)
          if (std::all_of(
                corners.begin(), corners.end(), [k](const Corner &c) { return c[k] == 0; }))
            result.boundary = k < 2 ? boundary::axis : boundary::surface;
        return result.tag;
      }

      std::map<std::tuple<double, double, double>, int> points;
      std::map<std::pair<int, int>, int>                lines;
      std::map<std::array<int, 4>, Face>                faces_of;
      std::vector<int>                                  volumes;
    };
    /// gmsh places points to about 1e-12 of a line: the point of the frame's lattice that `p` is
    /// near, so that planes of symmetry are exact and mirror images agree.
    dealii::Point<3> settled(const Frame &frame, const dealii::Point<3> &p)
    {
      const double side = frame.kite_side;
      // A shell is the core's surface blown up.
      const double extent = std::round(std::max({p[0], p[1], -p[2]}));
      const double scale  = frame.shells > 0 ? std::max(1., extent / frame.core_side()) : 1.;
      const double a = p[0] / scale, b = p[1] / scale, w = std::round(p[2] / scale);
      const double ring = std::round(std::max(a, b));
      // The larger of a and b is the ring, the other a share of it.
      const double reach  = std::max(ring, side);
      const auto   placed = [&](const double value, const unsigned int cells) {
        return reach * std::round(value / reach * cells) / cells;
      };
      const bool   outside = ring > side;
      const double on_a    = outside && a >= b - 1e-6 ? ring : placed(a, frame.kite_cells_a);
      const double on_b    = outside && b >= a - 1e-6 ? ring : placed(b, frame.kite_cells_b);
      return {scale * on_a, scale * on_b, scale * w};
    }
  } // namespace

  void make_frame(const Frame &frame, dealii::Triangulation<3> &mesh)
  {
    const double k = frame.kite_side, c = frame.core_side(), depth = frame.layers;
    const double outwards = (c + frame.shells) / c;

    // Section: the kite O–A–M–B and the rings' two parts between it and the core's side.
    const dealii::Point<2> o(0, 0), a(k, 0), b(0, k), m(k, k), a2(c, 0), b2(0, c), m2(c, c);
    struct Part
    {
      std::array<dealii::Point<2>, 4> corners; // lexicographic
      unsigned int                    cells, others;
    };
    const Part parts[] = {{{o, a, b, m}, frame.kite_cells_a, frame.kite_cells_b},
                          {{a, a2, m, m2}, frame.rings, frame.kite_cells_b},
                          {{b, m, b2, m2}, frame.kite_cells_a, frame.rings}};

    const auto at = [](const dealii::Point<2> &p, const double w, const double scale = 1) {
      return Corner(scale * p[0], scale * p[1], scale * w);
    };
    {
      const GmshSession gmsh_session;
      FrameBlocks       blocks;
      for (const auto &[p, cells, others] : parts)
        {
          std::array<Corner, 8> core, floor;
          for (unsigned int i = 0; i < 4; ++i)
            {
              core[i]      = at(p[i], -depth);
              core[i + 4]  = at(p[i], 0);
              floor[i]     = at(p[i], -depth, outwards);
              floor[i + 4] = core[i];
            }
          blocks.add(core, {{cells, others, frame.layers}});
          if (frame.shells > 0)
            blocks.add(floor, {{cells, others, frame.shells}});
        }
      if (frame.shells > 0)
        {
          std::array<Corner, 8> side_a, side_b;
          for (unsigned int i = 0; i < 8; ++i)
            {
              const double w = i < 4 ? -depth : 0;
              side_a[i]      = at(i & 2 ? m2 : a2, w, i & 1 ? outwards : 1);
              side_b[i]      = at(i & 1 ? m2 : b2, w, i & 2 ? outwards : 1);
            }
          blocks.add(side_a, {{frame.shells, frame.kite_cells_b, frame.layers}});
          blocks.add(side_b, {{frame.kite_cells_a, frame.shells, frame.layers}});
        }
      blocks.name();
      gmsh_session.mesh_into(mesh);
    }
    dealii::GridTools::transform([&frame](const dealii::Point<3> &p) { return settled(frame, p); },
                                 mesh);
  }

  void mirror_to_whole(dealii::Triangulation<3> &mesh)
  {
    const auto [vertices, cells, subcells] = dealii::GridTools::get_coarse_mesh_description(mesh);

    std::vector<dealii::Point<3>>    all_vertices;
    std::vector<dealii::CellData<3>> all_cells;
    dealii::SubCellData              boundaries;
    for (const double sign_a : {1., -1.})
      for (const double sign_b : {1., -1.})
        {
          const auto first = static_cast<unsigned int>(all_vertices.size());
          for (const auto &p : vertices)
            all_vertices.emplace_back(sign_a * p[0], sign_b * p[1], p[2]);
          for (auto cell : cells)
            {
              // A mirror image is left-handed until one of its directions is turned.
              if (sign_a * sign_b < 0)
                for (unsigned int v = 0; v < 8; v += 2)
                  std::swap(cell.vertices[v], cell.vertices[v + 1]);
              for (auto &v : cell.vertices)
                v += first;
              all_cells.push_back(cell);
            }
          for (auto quad : subcells.boundary_quads)
            if (quad.boundary_id != boundary::axis)
              {
                for (auto &v : quad.vertices)
                  v += first;
                boundaries.boundary_quads.push_back(quad);
              }
        }
    std::vector<unsigned int> considered;
    dealii::GridTools::delete_duplicated_vertices(
      all_vertices, all_cells, boundaries, considered, 1e-9);
    mesh.clear();
    mesh.create_triangulation(all_vertices, all_cells, boundaries);
  }
} // namespace dpcontact
