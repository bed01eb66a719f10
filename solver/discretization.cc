#include "solver/discretization.h"

#include "meshing/boundary_ids.h"
#include "meshing/errors.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>

#include <algorithm>
#include <map>

namespace dpcontact
{
  using dealii::numbers::invalid_unsigned_int;

  template <int dim>
  Discretization<dim>::Discretization(const dealii::Triangulation<dim> &mesh,
                                      const BoussinesqField<dim>       &far_field,
                                      const Element                     element)
    : fe(dealii::FE_Q<dim>(element == Element::linear_full ? 1 : 2), dim)
    , quadrature_points(element == Element::quadratic_full ? 3 : 2)
    , dofs(mesh)
  {
    dofs.distribute_dofs(fe);
    constrain(far_field, element);
    free_index.assign(dofs.n_dofs(), invalid_unsigned_int);
    for (unsigned int i = 0; i < dofs.n_dofs(); ++i)
      if (!constraints.is_constrained(i))
        free_index[i] = n_free_unknowns++;
    far_index = free_index[far_index];
    build_cells();
    build_surface();
    build_exterior(far_field);
  }

  template <int dim>
  void Discretization<dim>::constrain(const BoussinesqField<dim> &far_field, const Element element)
  {
    dealii::DoFTools::make_hanging_node_constraints(dofs, constraints);

    // On the axis u_r = 0; in space the symmetry planes x = 0 and y = 0 carry the same id.
    std::map<dealii::types::global_dof_index, std::pair<unsigned int, dealii::Point<dim>>>
                                                 far_nodes;
    std::vector<dealii::types::global_dof_index> on_face(fe.n_dofs_per_face());
    for (const auto &cell : dofs.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary())
          {
            const auto id = cell->face(f)->boundary_id();
            cell->face(f)->get_dof_indices(on_face);
            for (unsigned int i = 0; i < on_face.size(); ++i)
              {
                const unsigned int component = fe.face_system_to_component_index(i, f).first;
                if (id == boundary::axis)
                  {
                    const dealii::Tensor<1, dim> n =
                      dealii::Tensor<1, dim>(cell->face(f)->center() - cell->center());
                    unsigned int across = 0;
                    for (int k = 1; k + 1 < dim; ++k)
                      if (std::abs(n[k]) > std::abs(n[across]))
                        across = static_cast<unsigned int>(k);
                    if (component == across && !constraints.is_constrained(on_face[i]))
                      constraints.add_line(on_face[i]);
                  }
                else if (id == boundary::far)
                  {
                    const unsigned int local = fe.face_to_cell_index(i, f);
                    const auto         unit  = fe.unit_support_point(local);
                    far_nodes[on_face[i]]    = {
                         component,
                         dealii::StaticMappingQ1<dim>::mapping.transform_unit_to_real_cell(cell,
                                                                                        unit)};
                  }
              }
          }
    if (far_nodes.empty())
      throw SolverError("the mesh has no boundary named 'far': check its physical groups");

    // The master: the inward displacement at the far boundary's point next to the axis.
    auto master = far_nodes.end();
    for (auto node = far_nodes.begin(); node != far_nodes.end(); ++node)
      if (node->second.first == dim - 1 &&
          (master == far_nodes.end() ||
           radius(node->second.second) < radius(master->second.second)))
        master = node;
    const double unit = far_field.displacement(master->second.second)[dim - 1];
    amplitude         = 1 / unit;
    far_index         = static_cast<unsigned int>(master->first);
    for (const auto &[index, node] : far_nodes)
      if (index != master->first && !constraints.is_constrained(index))
        {
          constraints.add_line(index);
          constraints.add_entry(
            index, master->first, far_field.displacement(node.second)[node.first] / unit);
        }

    if (element == Element::serendipity_reduced)
      {
        // The serendipity subspace: nodes inside a face or cell follow its edges and corners.
        const dealii::FE_Q<dim>                      scalar(2);
        std::vector<dealii::types::global_dof_index> local(fe.n_dofs_per_cell());
        for (const auto &cell : dofs.active_cell_iterators())
          {
            cell->get_dof_indices(local);
            for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
              {
                const auto [component, node] = fe.system_to_component_index(i);
                const auto   centre          = scalar.unit_support_point(node);
                const auto   is_middle = [](const double x) { return std::abs(x - 0.5) < 0.25; };
                unsigned int free_directions = 0;
                for (int k = 0; k < dim; ++k)
                  free_directions += is_middle(centre[k]) ? 1u : 0u;
                if (free_directions < 2 || constraints.is_constrained(local[i]))
                  continue;
                constraints.add_line(local[i]);
                for (unsigned int j = 0; j < fe.n_dofs_per_cell(); ++j)
                  {
                    const auto [other_component, other] = fe.system_to_component_index(j);
                    if (other_component != component)
                      continue;
                    const auto   point         = scalar.unit_support_point(other);
                    unsigned int other_middles = 0;
                    bool         same_entity   = true;
                    for (int k = 0; k < dim; ++k)
                      {
                        other_middles += is_middle(point[k]) ? 1u : 0u;
                        if (!is_middle(centre[k]) && std::abs(point[k] - centre[k]) > 0.25)
                          same_entity = false;
                      }
                    if (!same_entity)
                      continue;
                    const double edges   = free_directions == 2 ? 0.5 : 0.25;
                    const double corners = -0.25;
                    if (other_middles == 1)
                      constraints.add_entry(local[i], local[j], edges);
                    else if (other_middles == 0)
                      constraints.add_entry(local[i], local[j], corners);
                  }
              }
          }
      }
    constraints.close();
  }

  template <int dim>
  typename Discretization<dim>::Expansion
  Discretization<dim>::expand(const std::vector<dealii::types::global_dof_index> &nodal) const
  {
    Expansion                            expansion;
    std::map<unsigned int, unsigned int> position;
    const auto                           place = [&](const dealii::types::global_dof_index dof) {
      const auto [entry, is_new] =
        position.try_emplace(free_index[dof], static_cast<unsigned int>(expansion.unknowns.size()));
      if (is_new)
        expansion.unknowns.push_back(free_index[dof]);
      return entry->second;
    };
    expansion.terms.resize(nodal.size());
    for (unsigned int i = 0; i < nodal.size(); ++i)
      if (!constraints.is_constrained(nodal[i]))
        expansion.terms[i].emplace_back(place(nodal[i]), 1.);
      else
        for (const auto &[master, weight] : *constraints.get_constraint_entries(nodal[i]))
          expansion.terms[i].emplace_back(place(master), weight);
    return expansion;
  }

  template <int dim>
  void Discretization<dim>::build_cells()
  {
    const dealii::QGauss<dim>                    quadrature(quadrature_points);
    dealii::FEValues<dim>                        values(fe,
                                 quadrature,
                                 dealii::update_values | dealii::update_gradients |
                                   dealii::update_quadrature_points | dealii::update_JxW_values);
    std::vector<dealii::types::global_dof_index> local(fe.n_dofs_per_cell());
    all_cells.reserve(dofs.get_triangulation().n_active_cells());
    for (const auto &cell : dofs.active_cell_iterators())
      {
        values.reinit(cell);
        cell->get_dof_indices(local);
        const Expansion expansion = expand(local);
        Cell            result;
        result.unknowns = expansion.unknowns;
        for (const unsigned int q : values.quadrature_point_indices())
          {
            QuadraturePoint point;
            point.position = values.quadrature_point(q);
            point.weight   = values.JxW(q) * Kinematics<dim>::measure(point.position);
            point.strain.assign(result.unknowns.size(), StrainRow{});
            for (unsigned int i = 0; i < local.size(); ++i)
              {
                const StrainRow row = Kinematics<dim>::strain(fe.system_to_component_index(i).first,
                                                              values.shape_value(i, q),
                                                              values.shape_grad(i, q),
                                                              point.position);
                for (const auto &[k, weight] : expansion.terms[i])
                  for (unsigned int s = 0; s < n_strains; ++s)
                    point.strain[k][s] += weight * row[s];
              }
            result.points.push_back(std::move(point));
          }
        all_cells.push_back(std::move(result));
      }
  }

  template <int dim>
  void Discretization<dim>::build_surface()
  {
    const dealii::QGaussLobatto<dim - 1>         quadrature(fe.degree + 1);
    dealii::FEFaceValues<dim>                    values(fe,
                                     quadrature,
                                     dealii::update_values | dealii::update_quadrature_points |
                                       dealii::update_JxW_values | dealii::update_normal_vectors);
    std::vector<dealii::types::global_dof_index> local(fe.n_dofs_per_cell());
    for (const auto &cell : dofs.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        {
          if (!cell->face(f)->at_boundary() || cell->face(f)->boundary_id() != boundary::surface)
            continue;
          values.reinit(cell, f);
          cell->get_dof_indices(local);
          // Only the normal displacement of the face's own nodes matters.
          std::vector<dealii::types::global_dof_index> normal_dofs;
          std::vector<unsigned int>                    normal_local;
          for (unsigned int i = 0; i < local.size(); ++i)
            if (fe.system_to_component_index(i).first == dim - 1 && fe.has_support_on_face(i, f))
              {
                normal_dofs.push_back(local[i]);
                normal_local.push_back(i);
              }
          const Expansion expansion = expand(normal_dofs);
          SurfaceFace     face;
          face.cell     = cell->active_cell_index();
          face.unknowns = expansion.unknowns;
          for (const unsigned int q : values.quadrature_point_indices())
            {
              SurfacePoint point;
              point.radius = radius(values.quadrature_point(q));
              point.weight = values.JxW(q) * values.normal_vector(q)[dim - 1] *
                             Kinematics<dim>::measure(values.quadrature_point(q));
              point.value.assign(face.unknowns.size(), 0.);
              for (unsigned int i = 0; i < normal_local.size(); ++i)
                for (const auto &[k, weight] : expansion.terms[i])
                  point.value[k] += weight * values.shape_value(normal_local[i], q);
              face.points.push_back(std::move(point));
            }
          surface_faces.push_back(std::move(face));
        }
    // From the axis outwards: the contact is the beginning of the list.
    std::sort(surface_faces.begin(), surface_faces.end(), [](const auto &a, const auto &b) {
      return a.points.front().radius < b.points.front().radius;
    });
  }

  template <int dim>
  void Discretization<dim>::build_exterior(const BoussinesqField<dim> &far_field)
  {
    // Work of the exterior's traction on its own displacement at unit force; negative on the body.
    double                        work = 0;
    const dealii::QGauss<dim - 1> quadrature(4);
    dealii::FEFaceValues<dim>     values(fe,
                                     quadrature,
                                     dealii::update_quadrature_points | dealii::update_JxW_values |
                                       dealii::update_normal_vectors);
    for (const auto &cell : dofs.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == boundary::far)
          {
            values.reinit(cell, f);
            for (const unsigned int q : values.quadrature_point_indices())
              {
                const auto &p = values.quadrature_point(q);
                work +=
                  values.JxW(q) * Kinematics<dim>::measure(p) *
                  (far_field.displacement(p) * far_field.traction(p, values.normal_vector(q)));
              }
          }
    exterior = -work * amplitude * amplitude;
  }

  template <int dim>
  dealii::Vector<double>
  Discretization<dim>::distribute(const std::vector<double> &free_values) const
  {
    dealii::Vector<double> nodal(dofs.n_dofs());
    for (unsigned int i = 0; i < dofs.n_dofs(); ++i)
      if (free_index[i] != invalid_unsigned_int)
        nodal[i] = free_values[free_index[i]];
    constraints.distribute(nodal);
    return nodal;
  }

  template class Discretization<2>;
  template class Discretization<3>;
} // namespace dpcontact
