#include "solver/system/contact_system.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dpcontact
{
  namespace
  {
    bool associated(const std::vector<laws::Law> &laws)
    {
      return std::all_of(
        laws.begin(), laws.end(), [](const laws::Law &law) { return laws::associated(law); });
    }

    /// Elastic stiffness of every cell: the upper triangle, row by row.
    template <int dim>
    std::vector<std::vector<double>> elastic_blocks(const Discretisation<dim> &space,
                                                    const MaterialPoints<dim> &material)
    {
      std::vector<std::vector<double>> blocks(space.cells().size());
      for (std::size_t c = 0; c < space.cells().size(); ++c)
        {
          const auto &cell = space.cells()[c];
          cell_stiffness<dim>(
            cell,
            [&](unsigned int) { return &material.elastic_tangent(cell.body); },
            StiffnessPart::upper_triangle,
            blocks[c]);
        }
      return blocks;
    }
  } // namespace

  template <int dim>
  ContactSystem<dim>::ContactSystem(const Discretisation<dim>    &discretisation,
                                    const std::vector<laws::Law> &laws,
                                    const UndeformedGap          &undeformed_gap,
                                    const double                  penalty_stiffness,
                                    const Condensation            condensation,
                                    const LinearSolver            kind)
    : space(discretisation)
    , symmetric(associated(laws))
    , material(discretisation, laws)
    , subdomains(discretisation,
                 elastic_blocks(discretisation, material),
                 condensation,
                 symmetric,
                 kind)
    , contact_condition(discretisation, undeformed_gap, penalty_stiffness)
    , iterate{std::vector<double>(discretisation.n_free(), 0.)}
    , rhs(discretisation.n_free())
    , approach_derivative(discretisation.n_free())
    , step(discretisation.n_free())
    , step_per_approach(discretisation.n_free())
  {
    committed_fields = contact_condition.nodal_fields(iterate);
    contact_condition.limit_to(subdomains.present().n_faces);
  }

  template <int dim>
  void ContactSystem<dim>::grow()
  {
    subdomains.use_next();
    contact_condition.limit_to(subdomains.present().n_faces);
  }

  template <int dim>
  void ContactSystem<dim>::cover(const double distance)
  {
    subdomains.cover(distance);
    contact_condition.limit_to(subdomains.present().n_faces);
  }

  template <int dim>
  bool ContactSystem<dim>::complete()
  {
    const CondensedSubdomain<dim> &subdomain = subdomains.present();
    if (subdomain.whole())
      return true;
    subdomain.recover(iterate.u);
    if (contact_condition.touches_beyond(iterate))
      return false;
    for (const unsigned int cell : subdomain.outside)
      {
        material.evaluate(cell, iterate.u);
        if (material.yields(cell))
          return false;
      }
    return true;
  }

  template <int dim>
  double ContactSystem<dim>::reach() const
  {
    double result = contact_condition.edge_radius(iterate);
    for (const unsigned int c : subdomains.present().cells)
      for (std::size_t q = 0; q < space.cells()[c].points.size(); ++q)
        if (material.branches()[material.first(c) + q] != laws::Branch::elastic)
          result = std::max(result, space.cells()[c].points[q].position.norm());
    return space.communicator().max(result);
  }

  template <int dim>
  void
  ContactSystem<dim>::set_control(const Control control_, const double target_, const double scale)
  {
    control        = control_;
    target         = target_;
    residual_scale = scale;
    contact_condition.set_active(control != Control::released);
    if (control == Control::approach)
      iterate.approach = target;
  }

  template <int dim>
  const SparseMatrix &ContactSystem<dim>::tangent()
  {
    assemble_tangent();
    return subdomains.present().matrix;
  }

  template <int dim>
  void ContactSystem<dim>::assemble_tangent()
  {
    CondensedSubdomain<dim> &subdomain = subdomains.present();
    std::vector<double>     &values    = subdomain.matrix.value;
    values                             = subdomain.elastic_values;
    std::vector<double> block;
    for (std::size_t k = 0; k < subdomain.cells.size(); ++k)
      {
        const unsigned int c = subdomain.cells[k];
        if (!material.yields(c))
          continue;
        cell_stiffness<dim>(
          space.cells()[c],
          [&](const unsigned int q) { return material.plastic_tangent(material.first(c) + q); },
          symmetric ? StiffnessPart::upper_triangle : StiffnessPart::whole,
          block);
        for (std::size_t e = 0; e < block.size(); ++e)
          values[subdomain.cell_positions[k][e]] += block[e];
      }
    for (const auto &[face, contact_values] : contact_blocks)
      for (std::size_t e = 0; e < contact_values.size(); ++e)
        values[subdomain.surface_positions[face][e]] += contact_values[e];
  }

  template <int dim>
  void ContactSystem<dim>::add_internal_forces()
  {
    constexpr unsigned int n_strains = Kinematics<dim>::n_strains;
    for (const unsigned int c : subdomains.present().cells)
      {
        material.evaluate(c, iterate.u);
        const auto &cell = space.cells()[c];
        for (std::size_t q = 0; q < cell.points.size(); ++q)
          {
            const auto                   &point  = cell.points[q];
            const auto                   &stress = material.stresses()[material.first(c) + q];
            std::array<double, n_strains> sigma;
            for (unsigned int s = 0; s < n_strains; ++s)
              {
                const auto [i, j] = Kinematics<dim>::positions[s];
                sigma[s]          = point.weight * stress[i][j];
              }
            for (std::size_t i = 0; i < cell.unknowns.size(); ++i)
              {
                double force = 0;
                for (unsigned int s = 0; s < n_strains; ++s)
                  force += point.strain[i][s] * sigma[s];
                rhs[cell.unknowns[i]] += force;
              }
          }
      }
    space.communicator().sum(rhs);
    subdomains.present().add_exterior_force(iterate.u, rhs);
  }

  template <int dim>
  void ContactSystem<dim>::add_contact()
  {
    const auto &positions = subdomains.present().surface_positions;
    contact_blocks.clear();
    contribution = contact_condition.evaluate(
      iterate,
      rhs,
      approach_derivative,
      [&](const unsigned int face, const std::vector<double> &value, const double k) {
        if (positions[face].empty())
          return; // another process adds it
        if (contact_blocks.empty() || contact_blocks.back().first != face)
          contact_blocks.emplace_back(face, std::vector<double>(positions[face].size()));
        double *entry = contact_blocks.back().second.data();
        for (std::size_t i = 0; i < value.size(); ++i)
          for (std::size_t j = symmetric ? i : 0; j < value.size(); ++j, ++entry)
            *entry += k * value[i] * value[j];
      });
  }

  template <int dim>
  double ContactSystem<dim>::residual()
  {
    std::fill(rhs.begin(), rhs.end(), 0.);
    std::fill(approach_derivative.begin(), approach_derivative.end(), 0.);
    add_internal_forces();
    add_contact();
    double square = 0;
    for (const double r : rhs)
      square += r * r;
    if (control == Control::force)
      square += (contribution.force - target) * (contribution.force - target);
    return std::sqrt(square) / residual_scale;
  }

  template <int dim>
  bool ContactSystem<dim>::correction()
  {
    // An iterate far from equilibrium may have points at the apex, or a mechanism of perfectly
    // plastic ones, that resist nothing, or (flow that is not associated) less than nothing. Then a
    // share of the elastic stiffness leads on; no converged state needs it.
    assemble_tangent();
    CondensedSubdomain<dim> &subdomain = subdomains.present();
    for (const double share : {0., 1e-4, 1e-2, 1.})
      {
        if (share > 0)
          for (std::size_t e = 0; e < subdomain.matrix.value.size(); ++e)
            subdomain.matrix.value[e] += share * subdomain.elastic_values[e];
        if (subdomain.factorize() && solve_for_step() && slope() < 0)
          return true;
      }
    return false;
  }

  template <int dim>
  bool ContactSystem<dim>::solve_for_step()
  {
    approach_step = 0;
    ++n_linear_solves;
    if (!subdomains.present().solve(rhs, -1, step))
      return false;
    if (control != Control::force)
      return true;
    // [K  r_d; r_dᵀ F_d] [Δu; Δd] = [−r; F* − F], by elimination of Δu.
    ++n_linear_solves;
    if (!subdomains.present().solve(approach_derivative, 1, step_per_approach))
      return false;
    double along = 0, stiffness = contribution.force_stiffness;
    for (std::size_t i = 0; i < step.size(); ++i)
      {
        along += approach_derivative[i] * step[i];
        stiffness -= approach_derivative[i] * step_per_approach[i];
      }
    if (!(stiffness > 0))
      return false;
    approach_step = (target - contribution.force - along) / stiffness;
    for (std::size_t i = 0; i < step.size(); ++i)
      step[i] -= approach_step * step_per_approach[i];
    return true;
  }

  template <int dim>
  double ContactSystem<dim>::slope() const
  {
    double product = control == Control::force ? approach_step * (contribution.force - target) : 0.;
    for (std::size_t i = 0; i < step.size(); ++i)
      product += step[i] * rhs[i];
    return product;
  }

  template <int dim>
  void ContactSystem<dim>::move(const double length)
  {
    for (std::size_t i = 0; i < iterate.u.size(); ++i)
      iterate.u[i] += length * step[i];
    iterate.approach += length * approach_step;
  }

  template <int dim>
  typename ContactSystem<dim>::Snapshot ContactSystem<dim>::snapshot() const
  {
    return {iterate, contact_condition.multipliers, material.history(), committed_fields};
  }

  template <int dim>
  void ContactSystem<dim>::restore(const Snapshot &saved)
  {
    iterate                       = saved.unknowns;
    contact_condition.multipliers = saved.multipliers;
    material.restore(saved.points);
    committed_fields = saved.contact_fields;
  }

  template <int dim>
  Arrays ContactSystem<dim>::save() const
  {
    return {{"displacements", iterate.u},
            {"approach", {iterate.approach}},
            {"multipliers", contact_condition.multipliers},
            {"points", material.save()},
            {"contact pressure", committed_fields.pressure},
            {"contact displacement", committed_fields.inward}};
  }

  template <int dim>
  void ContactSystem<dim>::restore(const Arrays &saved)
  {
    const std::size_t n_contact   = contact_condition.multipliers.size();
    iterate.u                     = array(saved, "displacements", {iterate.u.size()});
    iterate.approach              = array(saved, "approach", {1}).front();
    contact_condition.multipliers = array(saved, "multipliers", {n_contact});
    committed_fields.pressure     = array(saved, "contact pressure", {n_contact});
    committed_fields.inward       = array(saved, "contact displacement", {n_contact});
    material.restore(saved);
  }

  template <int dim>
  void ContactSystem<dim>::reset()
  {
    std::fill(iterate.u.begin(), iterate.u.end(), 0.);
    iterate.approach = 0;
    contact_condition.forget();
    material.reset();
    contact_condition.set_active(true);
    committed_fields = contact_condition.nodal_fields(iterate);
    subdomains.use_first();
    contact_condition.limit_to(subdomains.present().n_faces);
  }

  template <int dim>
  StepIntegrals ContactSystem<dim>::commit()
  {
    StepIntegrals result = material.commit();
    for (unsigned int b = 0; b < space.n_bodies(); ++b)
      {
        const double far = iterate.u[space.far_unknown(b)];
        result.elastic_energy += space.exterior_stiffness(b) * far * far / 2;
      }
    const auto fields = contact_condition.nodal_fields(iterate);
    result.work       = contact_condition.work(committed_fields, fields);
    committed_fields  = fields;
    return result;
  }

  template class ContactSystem<2>;
  template class ContactSystem<3>;
} // namespace dpcontact
