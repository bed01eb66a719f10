#include "database/tables/material_table.h"
#include "meshing/errors.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/natural_neighbor_coordinates_3.h>
#include <algorithm>
#include <cmath>
#include <map>

namespace dpcontact
{
  namespace
  {
    // A grid is as degenerate as points can be: constructions must be exact as well.
    using Kernel        = CGAL::Exact_predicates_exact_constructions_kernel;
    using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
    using Values        = std::array<double, 4>;

    /// Sibson's coordinates are those of the inside; a face is approached to this share of the box.
    constexpr double inset = 1e-7;

    /// The rows of one E.
    struct Slice
    {
      Triangulation                                  triangulation;
      std::map<Triangulation::Vertex_handle, Values> values;
    };

    class NaturalNeighbour : public MaterialMethod
    {
    public:
      explicit NaturalNeighbour(const MaterialTable &table)
      {
        low = high = table.rows.front().point;
        for (const auto &row : table.rows)
          for (double MaterialPoint::*axis : axes)
            {
              low.*axis  = std::min(low.*axis, row.point.*axis);
              high.*axis = std::max(high.*axis, row.point.*axis);
            }
        for (const auto &row : table.rows)
          {
            Slice &slice = slices[row.point.E_Pa];
            slice.values[slice.triangulation.insert(position(row.point, 0))] = row.published;
          }
        for (const auto &[E, slice] : slices)
          if (slice.triangulation.dimension() < 3)
            throw InputError(
              "natural neighbours: the rows of one E do not span nu, phi and sigma-c");
      }

      MaterialEstimate at(const MaterialPoint &point) const override
      {
        auto above = slices.lower_bound(point.E_Pa);
        if (above == slices.end())
          return in_slice(slices.rbegin()->second, point);
        if (above == slices.begin() || above->first == point.E_Pa)
          return in_slice(above->second, point);
        const auto       below  = std::prev(above);
        const double     t      = (point.E_Pa - below->first) / (above->first - below->first);
        MaterialEstimate result = in_slice(below->second, point);
        const auto       other  = in_slice(above->second, point);
        for (std::size_t c = 0; c < 4; ++c)
          {
            result.value[c] += t * (other.value[c] - result.value[c]);
            result.uncertainty[c] += t * (other.uncertainty[c] - result.uncertainty[c]);
          }
        return result;
      }

    private:
      static constexpr std::array<double MaterialPoint::*, 3> axes{&MaterialPoint::nu,
                                                                   &MaterialPoint::phi_deg,
                                                                   &MaterialPoint::sigma_c_Pa};

      /// In the unit box, at least `margin` from its faces.
      Kernel::Point_3 position(const MaterialPoint &point, const double margin) const
      {
        std::array<double, 3> x{};
        for (std::size_t i = 0; i < 3; ++i)
          if (const double width = high.*axes[i] - low.*axes[i]; width > 0)
            x[i] = std::clamp((point.*axes[i] - low.*axes[i]) / width, margin, 1 - margin);
        return {x[0], x[1], x[2]};
      }

      MaterialEstimate in_slice(const Slice &slice, const MaterialPoint &point) const
      {
        for (const double margin : {0., inset}) // exact at the nodes, which may lie on a face
          {
            std::vector<std::pair<Triangulation::Vertex_handle, Kernel::FT>> weights;
            Kernel::FT                                                       sum = 0;
            const auto found = CGAL::sibson_natural_neighbor_coordinates_3(
              slice.triangulation, position(point, margin), std::back_inserter(weights), sum);
            if (!found.third)
              continue;
            MaterialEstimate    result{};
            std::vector<double> shares;
            for (const auto &[vertex, weight] : weights)
              {
                shares.push_back(CGAL::to_double(weight / sum));
                for (std::size_t c = 0; c < 4; ++c)
                  result.value[c] += shares.back() * slice.values.at(vertex)[c];
              }
            for (std::size_t c = 0; c < 4; ++c)
              {
                double square = 0;
                for (std::size_t k = 0; k < weights.size(); ++k)
                  square +=
                    shares[k] * std::pow(slice.values.at(weights[k].first)[c] - result.value[c], 2);
                result.uncertainty[c] = std::sqrt(square) / 4;
              }
            return result;
          }
        throw InputError("natural neighbours: the point has no neighbours in the table");
      }

      MaterialPoint           low{}, high{};
      std::map<double, Slice> slices;
    };
  } // namespace

  std::unique_ptr<MaterialMethod> make_natural_neighbour(const MaterialTable &table)
  {
    return std::make_unique<NaturalNeighbour>(table);
  }
} // namespace dpcontact
