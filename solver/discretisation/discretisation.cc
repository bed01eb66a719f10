#include "solver/discretisation/discretisation.h"

#include "meshing/boundary_ids.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>

#include <algorithm>
#include <map>

namespace dpcontact
{
  using dealii::numbers::invalid_unsigned_int;

  template <int dim>
  Discretisation<dim>::Discretisation(const dealii::Triangulation<dim>        &mesh,
                                      const std::vector<BoussinesqField<dim>> &far_fields,
                                      const Element                            element,
                                      const Communicator                      &communicator)
    : fe(dealii::FE_Q<dim>(is_linear(element) ? 1 : 2), dim)
    , quadrature_points(element == Element::quadratic_full ? 3 : 2)
    , dofs(mesh)
    , processes(communicator)
    , bodies(far_fields.size())
  {
    dofs.distribute_dofs(fe);
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        Body &body = bodies[b];
        constrain(far_fields[b], element, body);
        body.free_index.assign(dofs.n_dofs(), invalid_unsigned_int);
        for (unsigned int i = 0; i < dofs.n_dofs(); ++i)
          if (!body.constraints.is_constrained(i))
            body.free_index[i] = n_free_unknowns++;
        body.far_index = body.free_index[body.far_index];
        build_cells(b, element);
        build_exterior(far_fields[b], body);
      }
    build_surface();
  }

  template <int dim>
  typename Discretisation<dim>::Expansion
  Discretisation<dim>::expand(const Body                                         &body,
                              const std::vector<dealii::types::global_dof_index> &nodal)
  {
    Expansion                            expansion;
    std::map<unsigned int, unsigned int> position;
    const auto                           place = [&](const dealii::types::global_dof_index dof) {
      const auto [entry, is_new] = position.try_emplace(
        body.free_index[dof], static_cast<unsigned int>(expansion.unknowns.size()));
      if (is_new)
        expansion.unknowns.push_back(body.free_index[dof]);
      return entry->second;
    };
    expansion.terms.resize(nodal.size());
    for (unsigned int i = 0; i < nodal.size(); ++i)
      if (!body.constraints.is_constrained(nodal[i]))
        expansion.terms[i].emplace_back(place(nodal[i]), 1.);
      else
        for (const auto &[master, weight] : *body.constraints.get_constraint_entries(nodal[i]))
          expansion.terms[i].emplace_back(place(master), weight);
    return expansion;
  }

  namespace
  {
    /// Gives every point the mean dilatation of the element instead of its own (B̄).
    template <class Cell>
    void average_dilatation(Cell &cell)
    {
      constexpr unsigned int n_normal = 3; // the normal strains come first
      for (std::size_t i = 0; i < cell.unknowns.size(); ++i)
        {
          double     mean = 0, volume = 0;
          const auto dilatation = [i](const auto &point) {
            return point.strain[i][0] + point.strain[i][1] + point.strain[i][2];
          };
          for (const auto &point : cell.points)
            {
              mean += point.weight * dilatation(point);
              volume += point.weight;
            }
          mean /= volume;
          for (auto &point : cell.points)
            {
              const double change = (mean - dilatation(point)) / n_normal;
              for (unsigned int s = 0; s < n_normal; ++s)
                point.strain[i][s] += change;
            }
        }
    }
  } // namespace

  template <int dim>
  void Discretisation<dim>::build_cells(const unsigned int body, const Element element)
  {
    const dealii::QGauss<dim>                    quadrature(quadrature_points);
    dealii::FEValues<dim>                        values(fe,
                                 quadrature,
                                 dealii::update_values | dealii::update_gradients |
                                   dealii::update_quadrature_points | dealii::update_JxW_values);
    std::vector<dealii::types::global_dof_index> local(fe.n_dofs_per_cell());
    if (processes.alone())
      all_cells.reserve(bodies.size() * dofs.get_triangulation().n_active_cells());
    for (const auto &cell : dofs.active_cell_iterators())
      {
        if (!own(cell))
          continue;
        values.reinit(cell);
        cell->get_dof_indices(local);
        const Expansion expansion = expand(bodies[body], local);
        Cell            result;
        result.body     = body;
        result.index    = cell->active_cell_index();
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
        if (element == Element::linear_mean_dilatation)
          average_dilatation(result);
        all_cells.push_back(std::move(result));
      }
  }

  template <int dim>
  void Discretisation<dim>::build_surface()
  {
    const dealii::QGaussLobatto<dim - 1>         quadrature(fe.degree + 1);
    dealii::FEFaceValues<dim>                    values(fe,
                                     quadrature,
                                     dealii::update_values | dealii::update_quadrature_points |
                                       dealii::update_JxW_values | dealii::update_normal_vectors);
    std::vector<dealii::types::global_dof_index> local(fe.n_dofs_per_cell());
    unsigned int                                 own_cells = 0;
    for (const auto &cell : dofs.active_cell_iterators())
      {
        const unsigned int cell_index = own(cell) ? own_cells++ : invalid_unsigned_int;
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
            SurfaceFace face;
            face.cell = cell_index;
            for (const unsigned int q : values.quadrature_point_indices())
              {
                const auto  &position = values.quadrature_point(q);
                SurfacePoint point;
                point.radius = radius(position);
                point.weight = values.JxW(q) * values.normal_vector(q)[dim - 1] *
                               Kinematics<dim>::measure(position);
                face.points.push_back(std::move(point));
              }
            for (const Body &body : bodies)
              {
                const Expansion   expansion = expand(body, normal_dofs);
                const std::size_t first     = face.unknowns.size();
                face.unknowns.insert(
                  face.unknowns.end(), expansion.unknowns.begin(), expansion.unknowns.end());
                for (const unsigned int q : values.quadrature_point_indices())
                  {
                    auto &value = face.points[q].value;
                    value.resize(face.unknowns.size(), 0.);
                    for (unsigned int i = 0; i < normal_local.size(); ++i)
                      for (const auto &[k, weight] : expansion.terms[i])
                        value[first + k] += weight * values.shape_value(normal_local[i], q);
                  }
              }
            surface_faces.push_back(std::move(face));
          }
      }
    // From the axis outwards: the contact is the beginning of the list.
    std::sort(surface_faces.begin(), surface_faces.end(), [](const auto &a, const auto &b) {
      return a.points.front().radius < b.points.front().radius;
    });
  }

  template <int dim>
  void Discretisation<dim>::build_exterior(const BoussinesqField<dim> &far_field, Body &body) const
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
    body.exterior = -work * body.amplitude * body.amplitude;
  }

  template <int dim>
  dealii::Vector<double> Discretisation<dim>::distribute(const std::vector<double> &free_values,
                                                         const unsigned int         body) const
  {
    const auto            &free_index = bodies[body].free_index;
    dealii::Vector<double> nodal(dofs.n_dofs());
    for (unsigned int i = 0; i < dofs.n_dofs(); ++i)
      if (free_index[i] != invalid_unsigned_int)
        nodal[i] = free_values[free_index[i]];
    bodies[body].constraints.distribute(nodal);
    return nodal;
  }

  template <int dim>
  std::vector<typename Discretisation<dim>::Unknown> Discretisation<dim>::unknowns() const
  {
    std::vector<Unknown> result(n_free_unknowns);
    for (auto &unknown : result)
      unknown.owner = invalid_unsigned_int;
    std::vector<dealii::types::global_dof_index> local(fe.n_dofs_per_cell());
    for (const auto &cell : dofs.active_cell_iterators())
      {
        cell->get_dof_indices(local);
        const unsigned int rank = processes.alone() ? 0 : cell->subdomain_id();
        std::vector<dealii::types::global_dof_index> first(local.size() / dim); // of each node
        for (unsigned int i = 0; i < local.size(); ++i)
          if (const auto [component, node] = fe.system_to_component_index(i); component == 0)
            first[node] = local[i];
        for (unsigned int i = 0; i < local.size(); ++i)
          for (unsigned int b = 0; b < bodies.size(); ++b)
            {
              const unsigned int free = bodies[b].free_index[local[i]];
              if (free == invalid_unsigned_int)
                continue;
              const auto [component, node] = fe.system_to_component_index(i);
              Unknown &unknown             = result[free];
              unknown.component            = component;
              unknown.node                 = static_cast<unsigned int>(first[node]);
              unknown.body                 = b;
              unknown.owner                = std::min(unknown.owner, rank);
              unknown.position = dealii::StaticMappingQ1<dim>::mapping.transform_unit_to_real_cell(
                cell, fe.unit_support_point(i));
            }
      }
    return result;
  }

  template class Discretisation<2>;
  template class Discretisation<3>;
} // namespace dpcontact
