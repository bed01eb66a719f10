#include "solver/output/recovery.h"

#include "meshing/boundary_ids.h"
#include "meshing/errors.h"
#include "solver/problem/unit_system.h"
#include "solver/system/contact_system.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/numerics/data_out.h>

#include <algorithm>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <utility>

namespace dpcontact
{
  namespace
  {
    /// Least-squares projection of quadrature values onto linear functions of a cell.
    template <int dim>
    dealii::FullMatrix<double> projection(const unsigned int points_per_direction)
    {
      const dealii::FE_DGQ<dim>  linear(1);
      const dealii::QGauss<dim>  quadrature(points_per_direction);
      dealii::FullMatrix<double> matrix(linear.n_dofs_per_cell(), quadrature.size());
      dealii::FETools::compute_projection_from_quadrature_points_matrix(
        linear, quadrature, quadrature, matrix);
      return matrix;
    }

    double mises(const laws::StressTensor &sigma)
    {
      const auto s = dealii::deviator(sigma);
      return std::sqrt(1.5 * (s * s));
    }

    constexpr std::size_t no_point = std::numeric_limits<std::size_t>::max();

    const char *const component_names_2d[] = {"stress_rr", "stress_yy", "stress_tt", "stress_ry"};
    const char *const component_names_3d[] =
      {"stress_xx", "stress_yy", "stress_zz", "stress_xy", "stress_xz", "stress_yz"};
  } // namespace

  namespace
  {
    /// Components of the stress, then pressure, Mises stress and plastic strain.
    template <int dim>
    constexpr unsigned int n_values = Kinematics<dim>::n_strains + 3;

    template <int dim>
    std::string value_name(const unsigned int v)
    {
      constexpr unsigned int n_strains = Kinematics<dim>::n_strains;
      if (v < n_strains)
        return dim == 2 ? component_names_2d[v] : component_names_3d[v];
      return v == n_strains ? "pressure" : v == n_strains + 1 ? "mises_stress" : "plastic_strain";
    }

    /// The v-th value at a quadrature point, in SI units.
    template <int dim>
    double value_at(const MaterialPoints<dim> &points,
                    const std::size_t          point,
                    const unsigned int         v,
                    const UnitSystem          &units)
    {
      constexpr unsigned int n_strains = Kinematics<dim>::n_strains;
      const auto            &sigma     = points.stresses()[point];
      if (v < n_strains)
        {
          const auto [i, j] = Kinematics<dim>::positions[v];
          return units.stress * sigma[i][j];
        }
      if (v == n_strains)
        return -units.stress * dealii::trace(sigma) / 3;
      if (v == n_strains + 1)
        return units.stress * mises(sigma);
      return units.strain() * points.history().accumulated_strain[point];
    }

    /// Mises stress and plastic strain, which a projection to the corners may undershoot.
    template <int dim>
    bool is_never_negative(const unsigned int v)
    {
      return v > Kinematics<dim>::n_strains;
    }

    /// Index of the first quadrature point of every cell of the mesh that this process has of a
    /// body; `no_point` of the others.
    template <int dim>
    std::vector<std::size_t> first_points(const Discretisation<dim> &space, const unsigned int body)
    {
      std::vector<std::size_t> first(space.dof_handler().get_triangulation().n_active_cells(),
                                     no_point);
      std::size_t              next = 0;
      for (const auto &cell : space.cells())
        {
          if (cell.body == body)
            first[cell.index] = next;
          next += cell.points.size();
        }
      return first;
    }

    /// All values, at the corners of every cell of `corners` (linear functions of each cell).
    template <int dim>
    std::vector<dealii::Vector<double>> corner_values(const ContactSystem<dim>       &system,
                                                      const UnitSystem               &units,
                                                      const dealii::DoFHandler<dim>  &corners,
                                                      const std::vector<std::size_t> &first_point)
    {
      const auto project = projection<dim>(system.discretisation().points_per_direction());
      std::vector<dealii::Vector<double>> values(n_values<dim>,
                                                 dealii::Vector<double>(corners.n_dofs()));
      dealii::Vector<double>              at_points(static_cast<unsigned int>(project.n()));
      dealii::Vector<double>              at_corners(static_cast<unsigned int>(project.m()));
      std::vector<dealii::types::global_dof_index> local(corners.get_fe().n_dofs_per_cell());
      for (const auto &cell : corners.active_cell_iterators())
        {
          const std::size_t first = first_point[cell->active_cell_index()];
          if (first == no_point)
            continue;
          cell->get_dof_indices(local);
          for (unsigned int v = 0; v < n_values<dim>; ++v)
            {
              for (unsigned int q = 0; q < at_points.size(); ++q)
                at_points[q] = value_at<dim>(system.points(), first + q, v, units);
              project.vmult(at_corners, at_points);
              for (unsigned int i = 0; i < local.size(); ++i)
                values[v][local[i]] =
                  is_never_negative<dim>(v) ? std::max(0., at_corners[i]) : at_corners[i];
            }
        }
      return values;
    }

    /// The mean of a value over the volume of every cell, which no recovery has touched.
    template <int dim>
    dealii::Vector<double> cell_means(const ContactSystem<dim>       &system,
                                      const UnitSystem               &units,
                                      const unsigned int              v,
                                      const unsigned int              body,
                                      const std::vector<std::size_t> &first_point)
    {
      dealii::Vector<double> means(static_cast<unsigned int>(first_point.size()));
      for (const auto &cell : system.discretisation().cells())
        {
          if (cell.body != body)
            continue;
          double sum = 0, volume = 0;
          for (std::size_t q = 0; q < cell.points.size(); ++q)
            {
              const double weight = cell.points[q].weight;
              sum += weight * value_at<dim>(system.points(), first_point[cell.index] + q, v, units);
              volume += weight;
            }
          means[cell.index] = sum / volume;
        }
      return means;
    }

    /// What a function writes to a stream.
    template <class Writer>
    std::string text_of(const Writer &writer)
    {
      std::ostringstream stream;
      writer(stream);
      return stream.str();
    }

    /// Every process writes its piece, and the first one the file that names them.
    template <int dim>
    void write_pieces(const dealii::DataOut<dim> &output,
                      const Communicator         &processes,
                      const std::string          &state,
                      const FieldSink            &sink)
    {
      const auto piece = [&](const unsigned int rank) {
        return state + (processes.alone() ? "" : "." + std::to_string(rank)) + ".vtu";
      };
      sink(piece(processes.rank()),
           text_of([&](std::ostream &stream) { output.write_vtu(stream); }));
      if (processes.alone() || processes.rank() != 0)
        return;
      std::vector<std::string> pieces;
      for (unsigned int rank = 0; rank < processes.size(); ++rank)
        pieces.push_back(piece(rank));
      sink(state + ".pvtu",
           text_of([&](std::ostream &stream) { output.write_pvtu_record(stream, pieces); }));
    }

    template <int dim>
    void write_body(const ContactSystem<dim> &system,
                    const unsigned int        body,
                    const UnitSystem         &units,
                    const std::string        &state,
                    const FieldSink          &sink)
    {
      const auto &space = system.discretisation();
      // DataOut takes positions from the mesh: scale a copy of it and of the nodal values.
      dealii::Triangulation<dim> mesh;
      mesh.copy_triangulation(space.dof_handler().get_triangulation());
      dealii::GridTools::scale(units.length, mesh);
      dealii::DoFHandler<dim> nodes(mesh), corners(mesh);
      nodes.distribute_dofs(space.dof_handler().get_fe());
      corners.distribute_dofs(dealii::FE_DGQ<dim>(1));
      dealii::Vector<double> displacement = space.distribute(system.unknowns().u, body);
      displacement *= units.displacement;
      const std::vector<std::size_t> first_point = first_points(space, body);
      const auto                     values = corner_values(system, units, corners, first_point);

      dealii::DataOut<dim> output;
      output.attach_dof_handler(corners);
      output.add_data_vector(
        nodes,
        displacement,
        std::vector<std::string>(dim, "displacement"),
        std::vector<dealii::DataComponentInterpretation::DataComponentInterpretation>(
          dim, dealii::DataComponentInterpretation::component_is_part_of_vector));
      std::vector<dealii::Vector<double>> means;
      for (unsigned int v = Kinematics<dim>::n_strains; v < n_values<dim>; ++v)
        means.push_back(cell_means(system, units, v, body, first_point));
      for (unsigned int v = 0; v < n_values<dim>; ++v)
        output.add_data_vector(corners, values[v], value_name<dim>(v));
      for (unsigned int i = 0; i < means.size(); ++i)
        output.add_data_vector(means[i],
                               value_name<dim>(Kinematics<dim>::n_strains + i) + "_of_cell",
                               dealii::DataOut<dim>::type_cell_data);
      // Other processes write the cells that this one does not have.
      output.set_cell_selection([&](const auto &cell) {
        return cell->is_active() && first_point[cell->active_cell_index()] != no_point;
      });
      output.build_patches(space.dof_handler().get_fe().degree);
      write_pieces(output, space.communicator(), state, sink);
    }
  } // namespace

  template <int dim>
  void write_fields(const ContactSystem<dim> &system,
                    const UnitSystem         &units,
                    const std::string        &state,
                    const FieldSink          &sink)
  {
    for (unsigned int body = 0; body < system.discretisation().n_bodies(); ++body)
      write_body(system, body, units, state + (body == 0 ? "" : "-2"), sink);
  }

  std::vector<AxisPoint> axis_profile(const ContactSystem<2> &system, const UnitSystem &units)
  {
    const auto &space   = system.discretisation();
    const auto  project = projection<2>(space.points_per_direction());
    std::map<double, std::pair<laws::StressTensor, unsigned int>> nodes; // by depth
    std::size_t                                                   first = 0;
    for (const auto &cell : space.dof_handler().active_cell_iterators())
      {
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == boundary::axis)
            for (const unsigned int corner : {0u, 1u})
              {
                const unsigned int vertex =
                  cell->reference_cell().face_to_cell_vertices(f, corner, 1);
                laws::StressTensor value;
                for (unsigned int q = 0; q < project.n(); ++q)
                  value += project(vertex, q) * system.points().stresses()[first + q];
                auto &[sum, count] = nodes[-cell->vertex(vertex)[1]];
                sum += value;
                ++count;
              }
        first += project.n();
      }
    std::vector<AxisPoint> profile;
    for (const auto &[depth, node] : nodes)
      {
        const laws::StressTensor mean = node.first / node.second;
        profile.push_back({depth * units.length,
                           mean[1][1] * units.stress,
                           (mean[0][0] + mean[2][2]) / 2 * units.stress});
      }
    return profile;
  }

  std::vector<PointState> point_states(const ContactSystem<2> &system, const UnitSystem &units)
  {
    std::vector<PointState> states;
    std::size_t             index = 0;
    for (const auto &cell : system.discretisation().cells())
      for (const auto &point : cell.points)
        {
          if (cell.body > 0)
            return states;
          const laws::StressTensor sigma = units.stress * system.points().stresses()[index];
          PointState               state;
          state.radius           = point.position[0] * units.length;
          state.depth            = -point.position[1] * units.length;
          state.volume           = point.weight * units.length * units.length * units.length;
          state.radial_stress    = sigma[0][0];
          state.axial_stress     = sigma[1][1];
          state.hoop_stress      = sigma[2][2];
          state.shear_stress     = sigma[0][1];
          state.principal_stress = dealii::eigenvalues(sigma);
          state.mises_stress     = mises(sigma);
          state.plastic_strain =
            units.strain() * system.points().history().accumulated_strain[index];
          state.branch = system.points().branches()[index];
          states.push_back(state);
          ++index;
        }
    return states;
  }

  template void write_fields<2>(const ContactSystem<2> &,
                                const UnitSystem &,
                                const std::string &,
                                const FieldSink &);
  template void write_fields<3>(const ContactSystem<3> &,
                                const UnitSystem &,
                                const std::string &,
                                const FieldSink &);
} // namespace dpcontact
