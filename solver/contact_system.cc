#include "solver/contact_system.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dpcontact
{
  using laws::Branch;

  namespace
  {
    constexpr double core_growth = 1.6; ///< ratio of the radii of successive cores
    constexpr double core_margin =
      0.85; ///< share of a core's radius that may be used before it grows
  }         // namespace

  template <int dim>
  ContactSystem<dim>::ContactSystem(const Discretization<dim>    &discretization,
                                    const std::vector<laws::Law> &laws_,
                                    const Profile                &profile,
                                    const double                  penalty_stiffness,
                                    const bool                    condensed,
                                    const LinearSolver            kind_)
    : u(discretization.n_free(), 0.)
    , space(discretization)
    , laws(laws_)
    , kind(kind_)
    , symmetric(std::all_of(laws_.begin(),
                            laws_.end(),
                            [](const laws::Law &law) { return laws::associated(law); }))
    , contact_condition(discretization, profile, penalty_stiffness)
    , rhs(discretization.n_free())
    , approach_derivative(discretization.n_free())
    , step(discretization.n_free())
    , step_per_approach(discretization.n_free())
  {
    std::size_t n_points = 0;
    double      largest  = 0;
    for (const auto &cell : space.cells())
      {
        first_point.push_back(static_cast<unsigned int>(n_points));
        n_points += cell.points.size();
        for (const auto &point : cell.points)
          largest = std::max(largest, point.position.norm());
      }
    history.resize(n_points);
    trial.resize(n_points);
    accumulated.resize(n_points, 0.);
    branch.resize(n_points, Branch::elastic);
    stress.resize(n_points);
    committed_stress.resize(n_points);
    committed_surface = contact_condition.state(u, approach);
    tangents.resize(n_points);
    build_elastic_stiffness();

    if (condensed)
      {
        // From the first few elements at the axis to half of the body; what is larger is the whole.
        double first = 0;
        for (unsigned int f = 0; f < std::min<std::size_t>(3, space.surface().size()); ++f)
          for (const auto &point : space.surface()[f].points)
            first = std::max(first, point.radius);
        for (double r = 1.5 * first; r < largest / 2; r *= core_growth)
          core_radii.push_back(r);
      }
    core_radii.push_back(std::numeric_limits<double>::infinity());
    cores.resize(core_radii.size());
    use_core(0);
    if (!condensed)
      elastic_blocks = {}; // no other core will ask for them
  }

  template <int dim>
  void ContactSystem<dim>::use_core(const std::size_t stage_)
  {
    stage = stage_;
    if (!cores[stage])
      cores[stage] =
        std::make_unique<Core<dim>>(space, elastic_blocks, core_radii[stage], symmetric, kind);
    core = cores[stage].get();
    contact_condition.limit_to(core->n_faces);
  }

  template <int dim>
  void ContactSystem<dim>::grow()
  {
    use_core(stage + 1);
  }

  template <int dim>
  bool ContactSystem<dim>::complete()
  {
    if (core->whole())
      return true;
    core->recover(u);
    if (contact_condition.touches_beyond(u, approach))
      return false;
    for (const unsigned int c : core->outside)
      {
        evaluate_points(c);
        for (std::size_t q = 0; q < space.cells()[c].points.size(); ++q)
          if (branch[first_point[c] + q] != Branch::elastic)
            return false;
      }
    return true;
  }

  template <int dim>
  double ContactSystem<dim>::reach() const
  {
    double result = contact_condition.edge_radius(u, approach);
    for (const unsigned int c : core->cells)
      for (std::size_t q = 0; q < space.cells()[c].points.size(); ++q)
        if (branch[first_point[c] + q] != Branch::elastic)
          result = std::max(result, space.cells()[c].points[q].position.norm());
    return space.communicator().max(result);
  }

  template <int dim>
  void ContactSystem<dim>::cover(const double distance)
  {
    std::size_t next = stage;
    while (distance > core_margin * core_radii[next])
      ++next;
    if (next != stage)
      use_core(next);
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
      approach = target;
  }

  template <int dim>
  template <class TangentOfPoint>
  void ContactSystem<dim>::cell_block(const typename Discretization<dim>::Cell &cell,
                                      const TangentOfPoint                     &tangent,
                                      const bool                                upper_triangle,
                                      std::vector<double>                      &block) const
  {
    constexpr unsigned int n_strains = Kinematics<dim>::n_strains;
    const auto             n         = cell.unknowns.size();
    block.assign(upper_triangle ? n * (n + 1) / 2 : n * n, 0.);
    std::vector<std::array<double, n_strains>> stress_of(n);
    for (unsigned int q = 0; q < cell.points.size(); ++q)
      {
        const auto          &point = cell.points[q];
        const TangentMatrix *D     = tangent(q);
        if (D == nullptr)
          continue;
        for (std::size_t i = 0; i < n; ++i)
          for (unsigned int s = 0; s < n_strains; ++s)
            {
              double product = 0;
              for (unsigned int t = 0; t < n_strains; ++t)
                product += (*D)[s][t] * point.strain[i][t];
              stress_of[i][s] = point.weight * product;
            }
        double *entry = block.data();
        for (std::size_t i = 0; i < n; ++i)
          {
            const auto b = point.strain[i];
            for (std::size_t j = upper_triangle ? i : 0; j < n; ++j, ++entry)
              {
                double product = 0;
                for (unsigned int s = 0; s < n_strains; ++s)
                  product += b[s] * stress_of[j][s];
                *entry += product;
              }
          }
      }
  }

  namespace
  {
    /// The entries of a spatial tangent that act on the strain vector.
    template <int dim, class Matrix>
    void restrict_tangent(const laws::Tangent &tangent, Matrix &matrix)
    {
      for (unsigned int s = 0; s < Kinematics<dim>::n_strains; ++s)
        for (unsigned int t = 0; t < Kinematics<dim>::n_strains; ++t)
          {
            const auto [i, j] = Kinematics<dim>::positions[s];
            const auto [k, l] = Kinematics<dim>::positions[t];
            matrix[s][t]      = tangent[i][j][k][l];
          }
    }
  } // namespace

  template <int dim>
  void ContactSystem<dim>::build_elastic_stiffness()
  {
    elastic_tangent.resize(laws.size());
    for (std::size_t b = 0; b < laws.size(); ++b)
      restrict_tangent<dim>(laws::evaluate(laws[b], State(), laws::StressTensor()).tangent,
                            elastic_tangent[b]);
    elastic_blocks.resize(space.cells().size());
    for (std::size_t c = 0; c < space.cells().size(); ++c)
      {
        const auto &cell = space.cells()[c];
        cell_block(
          cell,
          [this, &cell](unsigned int) { return &elastic_tangent[cell.body]; },
          true,
          elastic_blocks[c]);
      }
  }

  template <int dim>
  void ContactSystem<dim>::assemble_tangent()
  {
    std::vector<double> &values = core->matrix.value;
    values                      = core->elastic_values;
    std::vector<double> block;
    for (std::size_t k = 0; k < core->cells.size(); ++k)
      {
        const unsigned int c          = core->cells[k];
        const auto        &cell       = space.cells()[c];
        const std::size_t  first      = first_point[c];
        const auto         is_plastic = [&](const std::size_t q) {
          return branch[first + q] != Branch::elastic;
        };
        bool plastic = false;
        for (std::size_t q = 0; q < cell.points.size(); ++q)
          plastic = plastic || is_plastic(q);
        if (!plastic)
          continue;
        cell_block(
          cell,
          [&](const unsigned int q) { return is_plastic(q) ? &tangents[first + q] : nullptr; },
          symmetric,
          block);
        for (std::size_t e = 0; e < block.size(); ++e)
          values[core->cell_positions[k][e]] += block[e];
      }
    for (const auto &[face, contact_values] : contact_blocks)
      for (std::size_t e = 0; e < contact_values.size(); ++e)
        values[core->surface_positions[face][e]] += contact_values[e];
  }

  template <int dim>
  void ContactSystem<dim>::evaluate_points(const unsigned int c)
  {
    constexpr unsigned int n_strains = Kinematics<dim>::n_strains;
    const auto            &cell      = space.cells()[c];
    std::size_t            index     = first_point[c];
    for (const auto &point : cell.points)
      {
        std::array<double, n_strains> strain{};
        for (std::size_t i = 0; i < cell.unknowns.size(); ++i)
          {
            const double value = u[cell.unknowns[i]];
            for (unsigned int s = 0; s < n_strains; ++s)
              strain[s] += value * point.strain[i][s];
          }
        const auto response =
          laws::evaluate(laws[cell.body], history[index], strain_tensor<dim>(strain));
        trial[index]  = response.state;
        branch[index] = response.branch;
        stress[index] = response.stress;
        if (response.branch != Branch::elastic)
          {
            restrict_tangent<dim>(response.tangent, tangents[index]);
            for (unsigned int s = 0; s < n_strains; ++s)
              for (unsigned int t = 0; t < n_strains; ++t)
                tangents[index][s][t] -= elastic_tangent[cell.body][s][t];
          }
        ++index;
      }
  }

  template <int dim>
  double ContactSystem<dim>::residual()
  {
    constexpr unsigned int n_strains = Kinematics<dim>::n_strains;
    std::fill(rhs.begin(), rhs.end(), 0.);
    std::fill(approach_derivative.begin(), approach_derivative.end(), 0.);

    for (const unsigned int c : core->cells)
      {
        evaluate_points(c);
        const auto &cell = space.cells()[c];
        for (std::size_t q = 0; q < cell.points.size(); ++q)
          {
            const auto                   &point = cell.points[q];
            std::array<double, n_strains> sigma;
            for (unsigned int s = 0; s < n_strains; ++s)
              {
                const auto [i, j] = Kinematics<dim>::positions[s];
                sigma[s]          = point.weight * stress[first_point[c] + q][i][j];
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
    core->add_exterior_force(u, rhs);

    contact_blocks.clear();
    contact_response = contact_condition.evaluate(
      u,
      approach,
      rhs,
      approach_derivative,
      [this](const unsigned int face, const std::vector<double> &value, const double k) {
        if (core->surface_positions[face].empty())
          return; // another process adds it
        if (contact_blocks.empty() || contact_blocks.back().first != face)
          contact_blocks.emplace_back(face,
                                      std::vector<double>(core->surface_positions[face].size()));
        double *entry = contact_blocks.back().second.data();
        for (std::size_t i = 0; i < value.size(); ++i)
          for (std::size_t j = symmetric ? i : 0; j < value.size(); ++j, ++entry)
            *entry += k * value[i] * value[j];
      });

    double square = 0;
    for (const double r : rhs)
      square += r * r;
    if (control == Control::force)
      square += (contact_response.force - target) * (contact_response.force - target);
    return std::sqrt(square) / residual_scale;
  }

  template <int dim>
  bool ContactSystem<dim>::correction()
  {
    // An iterate far from equilibrium may have points at the apex, or a mechanism of perfectly
    // plastic ones, that resist nothing, or (flow that is not associated) less than nothing. Then a
    // share of the elastic stiffness leads on; no converged state needs it.
    assemble_tangent();
    for (const double share : {0., 1e-4, 1e-2, 1.})
      {
        if (share > 0)
          for (std::size_t e = 0; e < core->matrix.value.size(); ++e)
            core->matrix.value[e] += share * core->elastic_values[e];
        if (core->factorize() && solve_for_step() && slope() < 0)
          return true;
      }
    return false;
  }

  template <int dim>
  bool ContactSystem<dim>::solve_for_step()
  {
    approach_step = 0;
    ++n_linear_solves;
    if (!core->solve(rhs, -1, step))
      return false;
    if (control != Control::force)
      return true;
    // [K  r_d; r_dᵀ F_d] [Δu; Δd] = [−r; F* − F], by elimination of Δu.
    ++n_linear_solves;
    if (!core->solve(approach_derivative, 1, step_per_approach))
      return false;
    double along = 0, stiffness = contact_response.force_stiffness;
    for (std::size_t i = 0; i < step.size(); ++i)
      {
        along += approach_derivative[i] * step[i];
        stiffness -= approach_derivative[i] * step_per_approach[i];
      }
    if (!(stiffness > 0))
      return false;
    approach_step = (target - contact_response.force - along) / stiffness;
    for (std::size_t i = 0; i < step.size(); ++i)
      step[i] -= approach_step * step_per_approach[i];
    return true;
  }

  template <int dim>
  double ContactSystem<dim>::slope() const
  {
    double product =
      control == Control::force ? approach_step * (contact_response.force - target) : 0.;
    for (std::size_t i = 0; i < step.size(); ++i)
      product += step[i] * rhs[i];
    return product;
  }

  template <int dim>
  void ContactSystem<dim>::move(const double length)
  {
    for (std::size_t i = 0; i < u.size(); ++i)
      u[i] += length * step[i];
    approach += length * approach_step;
  }

  template class ContactSystem<2>;
  template class ContactSystem<3>;
} // namespace dpcontact
