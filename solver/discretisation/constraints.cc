// Which nodal displacements of a body are free: hanging nodes, planes of symmetry, the far boundary
// and the serendipity subspace.

#include "meshing/boundary_ids.h"
#include "meshing/errors.h"
#include "solver/discretisation/discretisation.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q1.h>

#include <algorithm>
#include <array>
#include <map>

namespace dpcontact
{
  template <int dim>
  void Discretisation<dim>::constrain_symmetry(dealii::AffineConstraints<double> &constraints) const
  {
    // On the axis u_r = 0; in space no displacement leaves the planes of symmetry, and none at all
    // but along it the line where they meet.
    struct Node
    {
      std::array<dealii::types::global_dof_index, dim> dofs;
      std::vector<dealii::Tensor<1, dim>>              normals;
    };
    std::map<dealii::types::global_dof_index, Node> nodes; // by the DoF of component 0
    std::vector<dealii::types::global_dof_index>    on_face(fe.n_dofs_per_face());
    for (const auto &cell : dofs.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == boundary::axis)
          {
            dealii::Tensor<1, dim> normal;
            if constexpr (dim == 2)
              normal[0] = 1;
            else
              {
                const auto face = cell->face(f);
                normal          = dealii::cross_product_3d(face->vertex(3) - face->vertex(0),
                                                  face->vertex(2) - face->vertex(1));
                normal /= normal.norm();
              }
            cell->face(f)->get_dof_indices(on_face);
            std::vector<std::array<dealii::types::global_dof_index, dim>> of(on_face.size() / dim);
            for (unsigned int i = 0; i < on_face.size(); ++i)
              {
                const auto [component, node] = fe.face_system_to_component_index(i, f);
                of[node][component]          = on_face[i];
              }
            for (const auto &node_dofs : of)
              {
                Node &node = nodes[node_dofs[0]];
                node.dofs  = node_dofs;
                if (std::none_of(node.normals.begin(), node.normals.end(), [&](const auto &n) {
                      return std::abs(std::abs(n * normal) - 1) < 1e-8;
                    }))
                  node.normals.push_back(normal);
              }
          }
    for (const auto &[first, node] : nodes)
      {
        if (node.normals.size() > 1)
          {
            for (int k = 0; k + 1 < dim; ++k)
              if (!constraints.is_constrained(node.dofs[k]))
                constraints.add_line(node.dofs[k]);
            continue;
          }
        const auto  &n      = node.normals.front();
        unsigned int across = 0;
        for (int k = 1; k + 1 < dim; ++k)
          if (std::abs(n[k]) > std::abs(n[across]))
            across = static_cast<unsigned int>(k);
        if (constraints.is_constrained(node.dofs[across]))
          continue;
        constraints.add_line(node.dofs[across]);
        for (int k = 0; k + 1 < dim; ++k)
          if (static_cast<unsigned int>(k) != across && std::abs(n[k]) > 1e-12)
            constraints.add_entry(node.dofs[across], node.dofs[k], -n[k] / n[across]);
      }
  }

  template <int dim>
  void Discretisation<dim>::constrain(const BoussinesqField<dim> &far_field,
                                      const Element               element,
                                      Body                       &body) const
  {
    dealii::AffineConstraints<double> &constraints = body.constraints;
    dealii::DoFTools::make_hanging_node_constraints(dofs, constraints);
    constrain_symmetry(constraints);

    std::map<dealii::types::global_dof_index, std::pair<unsigned int, dealii::Point<dim>>>
                                                 far_nodes;
    std::vector<dealii::types::global_dof_index> on_face(fe.n_dofs_per_face());
    for (const auto &cell : dofs.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == boundary::far)
          {
            cell->face(f)->get_dof_indices(on_face);
            for (unsigned int i = 0; i < on_face.size(); ++i)
              far_nodes[on_face[i]] = {
                fe.face_system_to_component_index(i, f).first,
                dealii::StaticMappingQ1<dim>::mapping.transform_unit_to_real_cell(
                  cell, fe.unit_support_point(fe.face_to_cell_index(i, f)))};
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
    body.amplitude    = 1 / unit;
    body.far_index    = static_cast<unsigned int>(master->first);
    for (const auto &[index, node] : far_nodes)
      if (index != master->first && !constraints.is_constrained(index))
        {
          constraints.add_line(index);
          constraints.add_entry(
            index, master->first, far_field.displacement(node.second)[node.first] / unit);
        }

    if (element == Element::serendipity_reduced)
      constrain_serendipity(constraints);
    constraints.close();
  }

  template <int dim>
  void
  Discretisation<dim>::constrain_serendipity(dealii::AffineConstraints<double> &constraints) const
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
            const auto   is_middle       = [](const double x) { return std::abs(x - 0.5) < 0.25; };
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

  template void Discretisation<2>::constrain(const BoussinesqField<2> &, Element, Body &) const;
  template void Discretisation<3>::constrain(const BoussinesqField<3> &, Element, Body &) const;
} // namespace dpcontact
