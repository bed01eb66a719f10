#include "solver/contact_system.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace dpcontact
{
  using laws::DruckerPrager;

  template <int dim>
  ContactSystem<dim>::ContactSystem(const Discretization<dim> &discretization,
                                    const DruckerPrager       &law_,
                                    const Profile             &profile,
                                    const double               penalty_stiffness)
    : u(discretization.n_free(), 0.)
    , space(discretization)
    , law(law_)
    , contact_condition(discretization, profile, penalty_stiffness)
    , rhs(discretization.n_free())
    , approach_derivative(discretization.n_free())
  {
    std::size_t n_points = 0;
    for (const auto &cell : space.cells())
      n_points += cell.points.size();
    history.resize(n_points);
    trial.resize(n_points);
    accumulated.resize(n_points, 0.);
    branch.resize(n_points, DruckerPrager::Branch::elastic);
    stress.resize(n_points);
    tangents.resize(n_points);
    build_pattern();
    build_elastic_stiffness();
    solver = std::make_unique<CholeskySolver>(matrix);
  }

  template <int dim>
  void ContactSystem<dim>::build_pattern()
  {
    std::vector<std::set<int>> columns(space.n_free());
    const auto couple = [&columns](const std::vector<unsigned int> &unknowns) {
      for (const unsigned int i : unknowns)
        for (const unsigned int j : unknowns)
          if (i <= j)
            columns[j].insert(static_cast<int>(i));
    };
    for (const auto &cell : space.cells())
      couple(cell.unknowns);
    for (const auto &face : space.surface())
      couple(face.unknowns);
    columns[space.far_unknown()].insert(static_cast<int>(space.far_unknown()));

    matrix.column_start.assign(1, 0);
    for (const auto &column : columns)
      {
        matrix.row.insert(matrix.row.end(), column.begin(), column.end());
        matrix.column_start.push_back(static_cast<int>(matrix.row.size()));
      }
    matrix.value.assign(matrix.row.size(), 0.);

    const auto positions = [this](const std::vector<unsigned int> &unknowns) {
      std::vector<int> result;
      for (unsigned int i = 0; i < unknowns.size(); ++i)
        for (unsigned int j = i; j < unknowns.size(); ++j)
          result.push_back(matrix.position(unknowns[i], unknowns[j]));
      return result;
    };
    for (const auto &cell : space.cells())
      cell_positions.push_back(positions(cell.unknowns));
    for (const auto &face : space.surface())
      surface_positions.push_back(positions(face.unknowns));
    far_position = matrix.position(space.far_unknown(), space.far_unknown());
  }

  template <int dim>
  void ContactSystem<dim>::set_control(const Control control_, const double target_, const double scale)
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
                                      std::vector<double>                      &block) const
  {
    constexpr unsigned int n_strains = Kinematics<dim>::n_strains;
    const auto             n         = cell.unknowns.size();
    block.assign(n * (n + 1) / 2, 0.);
    std::vector<std::array<double, n_strains>> stress_of(n);
    for (unsigned int q = 0; q < cell.points.size(); ++q)
      {
        const auto          &point = cell.points[q];
        const TangentMatrix &D     = tangent(q);
        for (std::size_t i = 0; i < n; ++i)
          for (unsigned int s = 0; s < n_strains; ++s)
            {
              double product = 0;
              for (unsigned int t = 0; t < n_strains; ++t)
                product += D[s][t] * point.strain[i][t];
              stress_of[i][s] = point.weight * product;
            }
        double *entry = block.data();
        for (std::size_t i = 0; i < n; ++i)
          {
            const auto b = point.strain[i];
            for (std::size_t j = i; j < n; ++j, ++entry)
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
    TangentMatrix elastic;
    restrict_tangent<dim>(law.evaluate(State(), laws::StressTensor()).tangent, elastic);
    elastic_blocks.resize(space.cells().size());
    for (std::size_t c = 0; c < space.cells().size(); ++c)
      {
        cell_block(
          space.cells()[c],
          [&elastic](unsigned int) -> const TangentMatrix & { return elastic; },
          elastic_blocks[c]);
        for (std::size_t k = 0; k < elastic_blocks[c].size(); ++k)
          matrix.value[cell_positions[c][k]] += elastic_blocks[c][k];
      }
    matrix.value[far_position] += space.exterior_stiffness();
    elastic_values = matrix.value;
    elastic_tangent = elastic;
  }

  template <int dim>
  void ContactSystem<dim>::assemble_tangent()
  {
    matrix.value = elastic_values;
    std::vector<double> block;
    std::size_t         first = 0;
    for (std::size_t c = 0; c < space.cells().size(); ++c)
      {
        const auto &cell     = space.cells()[c];
        const auto  is_plastic = [&](const std::size_t q) {
          return branch[first + q] != DruckerPrager::Branch::elastic;
        };
        bool plastic = false;
        for (std::size_t q = 0; q < cell.points.size(); ++q)
          plastic = plastic || is_plastic(q);
        if (plastic)
          {
            cell_block(
              cell,
              [&](const unsigned int q) -> const TangentMatrix & {
                return is_plastic(q) ? tangents[first + q] : elastic_tangent;
              },
              block);
            for (std::size_t k = 0; k < block.size(); ++k)
              matrix.value[cell_positions[c][k]] += block[k] - elastic_blocks[c][k];
          }
        first += cell.points.size();
      }
    for (const auto &[face, values] : contact_blocks)
      for (std::size_t k = 0; k < values.size(); ++k)
        matrix.value[surface_positions[face][k]] += values[k];
  }

  template <int dim>
  double ContactSystem<dim>::residual()
  {
    constexpr unsigned int n_strains = Kinematics<dim>::n_strains;
    std::fill(rhs.begin(), rhs.end(), 0.);
    std::fill(approach_derivative.begin(), approach_derivative.end(), 0.);

    std::vector<double> local, force;
    std::size_t         index = 0;
    for (const auto &cell : space.cells())
      {
        const std::size_t n = cell.unknowns.size();
        local.resize(n);
        force.assign(n, 0.);
        for (std::size_t i = 0; i < n; ++i)
          local[i] = u[cell.unknowns[i]];
        for (const auto &point : cell.points)
          {
            std::array<double, n_strains> strain{}, sigma;
            for (std::size_t i = 0; i < n; ++i)
              for (unsigned int s = 0; s < n_strains; ++s)
                strain[s] += local[i] * point.strain[i][s];
            const auto response = law.evaluate(history[index], strain_tensor<dim>(strain));
            trial[index]        = response.state;
            branch[index]       = response.branch;
            stress[index]       = response.stress;
            if (response.branch != DruckerPrager::Branch::elastic)
              restrict_tangent<dim>(response.tangent, tangents[index]);
            ++index;

            for (unsigned int s = 0; s < n_strains; ++s)
              {
                const auto [i, j] = Kinematics<dim>::positions[s];
                sigma[s]          = point.weight * response.stress[i][j];
              }
            for (std::size_t i = 0; i < n; ++i)
              for (unsigned int s = 0; s < n_strains; ++s)
                force[i] += point.strain[i][s] * sigma[s];
          }
        for (std::size_t i = 0; i < n; ++i)
          rhs[cell.unknowns[i]] += force[i];
      }

    contact_blocks.clear();
    contact_response = contact_condition.evaluate(
      u,
      approach,
      rhs,
      approach_derivative,
      [this](const unsigned int face, const std::vector<double> &value, const double k) {
        if (contact_blocks.empty() || contact_blocks.back().first != face)
          contact_blocks.emplace_back(face, std::vector<double>(surface_positions[face].size()));
        double *entry = contact_blocks.back().second.data();
        for (std::size_t i = 0; i < value.size(); ++i)
          for (std::size_t j = i; j < value.size(); ++j, ++entry)
            *entry += k * value[i] * value[j];
      });
    rhs[space.far_unknown()] += space.exterior_stiffness() * u[space.far_unknown()];

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
    assemble_tangent();
    if (!solver->factorize(matrix))
      return false;
    std::vector<double> negative(rhs.size());
    std::transform(rhs.begin(), rhs.end(), negative.begin(), [](const double r) { return -r; });
    solver->solve(negative, step);
    approach_step = 0;
    if (control == Control::force)
      {
        // [K  r_d; r_dᵀ F_d] [Δu; Δd] = [−r; F* − F], by elimination of Δu.
        solver->solve(approach_derivative, step_per_approach);
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
      }
    return true;
  }

  template <int dim>
  double ContactSystem<dim>::slope() const
  {
    double product = control == Control::force ?
                       approach_step * (contact_response.force - target) :
                       0.;
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

  template <int dim>
  void ContactSystem<dim>::restore(const Snapshot &saved)
  {
    u                             = saved.u;
    approach                      = saved.approach;
    contact_condition.multipliers = saved.multipliers;
    history                       = saved.history;
    accumulated                   = saved.accumulated;
  }

  template <int dim>
  void ContactSystem<dim>::reset()
  {
    std::fill(u.begin(), u.end(), 0.);
    approach = 0;
    std::fill(contact_condition.multipliers.begin(), contact_condition.multipliers.end(), 0.);
    std::fill(history.begin(), history.end(), State());
    std::fill(accumulated.begin(), accumulated.end(), 0.);
  }

  template <int dim>
  typename ContactSystem<dim>::Integrals ContactSystem<dim>::commit()
  {
    Integrals   result;
    std::size_t index = 0;
    const double shear = law.shear_modulus, bulk = law.bulk_modulus;
    for (const auto &cell : space.cells())
      for (const auto &point : cell.points)
        {
          const auto &sigma = stress[index];
          const auto  flow  = trial[index].plastic_strain - history[index].plastic_strain;
          result.dissipation += point.weight * (sigma * flow);
          const auto   deviator = dealii::deviator(sigma);
          const double mean     = dealii::trace(sigma) / 3;
          result.elastic_energy +=
            point.weight * ((deviator * deviator) / (4 * shear) + mean * mean / (2 * bulk));
          accumulated[index] += std::sqrt(2. / 3) * flow.norm();
          if (accumulated[index] > 0)
            result.plastic_volume += point.weight;
          result.plastic_strain_max = std::max(result.plastic_strain_max, accumulated[index]);
          if (branch[index] == DruckerPrager::Branch::apex)
            ++result.apex_points;
          result.largest_yield_excess =
            std::max(result.largest_yield_excess,
                     law.yield_function(sigma, trial[index].hardening_variable) / law.strength);
          ++index;
        }
    history = trial;
    return result;
  }

  template class ContactSystem<2>;
  template class ContactSystem<3>;
} // namespace dpcontact
