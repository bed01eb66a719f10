#include "solver/recovery.h"

#include "meshing/boundary_ids.h"
#include "meshing/errors.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/numerics/data_out.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <map>

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

    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

    const char *const component_names_2d[] = {"stress_rr", "stress_yy", "stress_tt", "stress_ry"};
    const char *const component_names_3d[] =
      {"stress_xx", "stress_yy", "stress_zz", "stress_xy", "stress_xz", "stress_yz"};
  } // namespace

  namespace
  {
    template <int dim>
    void write_body(const ContactSystem<dim> &system,
                    const unsigned int        body,
                    const double              length,
                    const double              displacement_factor,
                    const double              stress_factor,
                    const std::string        &file)
    {
      const auto &space     = system.discretization();
      const auto &processes = space.communicator();

      // DataOut takes positions from the mesh: scale a copy of it and of the nodal values.
      dealii::Triangulation<dim> mesh;
      mesh.copy_triangulation(space.dof_handler().get_triangulation());
      dealii::GridTools::scale(length, mesh);
      dealii::DoFHandler<dim> nodes(mesh);
      nodes.distribute_dofs(space.dof_handler().get_fe());
      dealii::Vector<double> displacement = space.distribute(system.u, body);
      displacement *= displacement_factor;

      const dealii::FE_DGQ<dim> linear(1);
      dealii::DoFHandler<dim>   cells(mesh);
      cells.distribute_dofs(linear);
      const auto                          project  = projection<dim>(space.points_per_direction());
      const unsigned int                  n_values = Kinematics<dim>::n_strains + 3;
      std::vector<dealii::Vector<double>> fields(n_values, dealii::Vector<double>(cells.n_dofs()));
      dealii::Vector<double>              at_points(static_cast<unsigned int>(project.n()));
      dealii::Vector<double>              at_corners(static_cast<unsigned int>(project.m()));
      std::vector<dealii::types::global_dof_index> local(linear.n_dofs_per_cell());
      // Values of this process' cells stay at their place; others are not written.
      std::vector<std::size_t> first_point(mesh.n_active_cells(), none);
      std::size_t              next = 0;
      for (const auto &cell : space.cells())
        {
          if (cell.body == body)
            first_point[cell.index] = next;
          next += cell.points.size();
        }
      for (const auto &cell : cells.active_cell_iterators())
        {
          const std::size_t first = first_point[cell->active_cell_index()];
          if (first == none)
            continue;
          cell->get_dof_indices(local);
          for (unsigned int v = 0; v < n_values; ++v)
            {
              for (unsigned int q = 0; q < at_points.size(); ++q)
                {
                  const auto &sigma = system.stresses()[first + q];
                  if (v < Kinematics<dim>::n_strains)
                    {
                      const auto [i, j] = Kinematics<dim>::positions[v];
                      at_points[q]      = stress_factor * sigma[i][j];
                    }
                  else if (v == Kinematics<dim>::n_strains)
                    at_points[q] = -stress_factor * dealii::trace(sigma) / 3;
                  else if (v == Kinematics<dim>::n_strains + 1)
                    at_points[q] = stress_factor * mises(sigma);
                  else
                    at_points[q] =
                      displacement_factor / length * system.accumulated_plastic_strain()[first + q];
                }
              project.vmult(at_corners, at_points);
              for (unsigned int i = 0; i < local.size(); ++i)
                fields[v][local[i]] = at_corners[i];
            }
        }

      dealii::DataOut<dim> output;
      output.add_data_vector(
        nodes,
        displacement,
        std::vector<std::string>(dim, "displacement"),
        std::vector<dealii::DataComponentInterpretation::DataComponentInterpretation>(
          dim, dealii::DataComponentInterpretation::component_is_part_of_vector));
      for (unsigned int v = 0; v < n_values; ++v)
        {
          const unsigned int extra = v - Kinematics<dim>::n_strains;
          const std::string  name  = v < Kinematics<dim>::n_strains
                                       ? (dim == 2 ? component_names_2d[v] : component_names_3d[v])
                                     : extra == 0 ? "pressure"
                                     : extra == 1 ? "mises_stress"
                                                  : "plastic_strain";
          output.add_data_vector(cells, fields[v], name);
        }
      output.set_cell_selection([&](const auto &cell) {
        return cell->is_active() && first_point[cell->active_cell_index()] != none;
      });
      output.build_patches(space.dof_handler().get_fe().degree);
      const auto piece = [&](const unsigned int rank) {
        return file + (processes.alone() ? "" : "." + std::to_string(rank)) + ".vtu";
      };
      const auto write = [](const std::string &name, const auto &writer) {
        std::ofstream stream(name);
        writer(stream);
        stream.close();
        if (!stream)
          throw FileError("cannot write the fields to '" + name +
                          "': check that the directory exists and is writable");
      };
      write(piece(processes.rank()), [&](std::ostream &stream) { output.write_vtu(stream); });
      if (processes.alone() || processes.rank() != 0)
        return;
      std::vector<std::string> pieces;
      for (unsigned int rank = 0; rank < processes.size(); ++rank)
        pieces.push_back(std::filesystem::path(piece(rank)).filename());
      write(file + ".pvtu",
            [&](std::ostream &stream) { output.write_pvtu_record(stream, pieces); });
    }
  } // namespace

  template <int dim>
  void write_fields(const ContactSystem<dim> &system,
                    const double              length,
                    const double              displacement,
                    const double              stress,
                    const std::string        &file)
  {
    for (unsigned int body = 0; body < system.discretization().n_bodies(); ++body)
      write_body(system, body, length, displacement, stress, file + (body == 0 ? "" : "-2"));
  }

  std::vector<AxisPoint> axis_profile(const ContactSystem<2> &system)
  {
    const auto &space   = system.discretization();
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
                  value += project(vertex, q) * system.stresses()[first + q];
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
        profile.push_back({depth, mean[1][1], (mean[0][0] + mean[2][2]) / 2});
      }
    return profile;
  }

  std::vector<PointState> point_states(const ContactSystem<2> &system,
                                       const double            length,
                                       const double            displacement,
                                       const double            stress)
  {
    std::vector<PointState> states;
    std::size_t             index = 0;
    for (const auto &cell : system.discretization().cells())
      for (const auto &point : cell.points)
        {
          if (cell.body > 0)
            return states;
          const laws::StressTensor sigma = stress * system.stresses()[index];
          PointState               state;
          state.radius           = point.position[0] * length;
          state.depth            = -point.position[1] * length;
          state.volume           = point.weight * length * length * length;
          state.radial_stress    = sigma[0][0];
          state.axial_stress     = sigma[1][1];
          state.hoop_stress      = sigma[2][2];
          state.shear_stress     = sigma[0][1];
          state.principal_stress = dealii::eigenvalues(sigma);
          state.mises_stress     = mises(sigma);
          state.plastic_strain = displacement / length * system.accumulated_plastic_strain()[index];
          state.branch         = system.branches()[index];
          states.push_back(state);
          ++index;
        }
    return states;
  }

  template void
  write_fields<2>(const ContactSystem<2> &, double, double, double, const std::string &);
  template void
  write_fields<3>(const ContactSystem<3> &, double, double, double, const std::string &);
} // namespace dpcontact
