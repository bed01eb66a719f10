#include "solver/system/material_points.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dpcontact
{
  using laws::Branch;

  template <int dim>
  MaterialPoints<dim>::MaterialPoints(const Discretisation<dim>    &space_,
                                      const std::vector<laws::Law> &laws)
    : space(space_)
    , material_laws(laws)
    , elastic(laws.size())
  {
    std::size_t n_points = 0;
    for (const auto &cell : space.cells())
      {
        first_point.push_back(static_cast<unsigned int>(n_points));
        n_points += cell.points.size();
      }
    committed.states.resize(n_points);
    committed.accumulated_strain.resize(n_points, 0.);
    committed.stresses.resize(n_points);
    trial.resize(n_points);
    branch.resize(n_points, Branch::elastic);
    stress.resize(n_points);
    tangents.resize(n_points);
    for (std::size_t b = 0; b < laws.size(); ++b)
      restrict_tangent<dim>(laws::evaluate(laws[b], laws::State(), laws::StressTensor()).tangent,
                            elastic[b]);
  }

  template <int dim>
  void MaterialPoints<dim>::evaluate(const unsigned int c, const std::vector<double> &u)
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
        const auto response = laws::evaluate(
          material_laws[cell.body], committed.states[index], strain_tensor<dim>(strain));
        trial[index]  = response.state;
        branch[index] = response.branch;
        stress[index] = response.stress;
        if (response.branch != Branch::elastic)
          {
            restrict_tangent<dim>(response.tangent, tangents[index]);
            for (unsigned int s = 0; s < n_strains; ++s)
              for (unsigned int t = 0; t < n_strains; ++t)
                tangents[index][s][t] -= elastic[cell.body][s][t];
          }
        ++index;
      }
  }

  template <int dim>
  bool MaterialPoints<dim>::yields(const unsigned int cell) const
  {
    for (std::size_t q = 0; q < space.cells()[cell].points.size(); ++q)
      if (branch[first_point[cell] + q] != Branch::elastic)
        return true;
    return false;
  }

  template <int dim>
  void MaterialPoints<dim>::add_point(const std::size_t                                    index,
                                      const laws::Law                                     &law,
                                      const typename Discretisation<dim>::QuadraturePoint &point,
                                      StepIntegrals &integrals)
  {
    const double shear = laws::shear_modulus(law), bulk = laws::bulk_modulus(law);
    const auto  &sigma       = stress[index];
    const auto   flow        = trial[index].plastic_strain - committed.states[index].plastic_strain;
    double      &accumulated = committed.accumulated_strain[index];
    integrals.dissipation += point.weight * (sigma * flow);
    integrals.mean_dissipation +=
      point.weight * ((committed.stresses[index] * flow + sigma * flow) / 2);
    const auto   deviator = dealii::deviator(sigma);
    const double mean     = dealii::trace(sigma) / 3;
    integrals.elastic_energy +=
      point.weight * ((deviator * deviator) / (4 * shear) + mean * mean / (2 * bulk));
    integrals.mises_stress_max =
      std::max(integrals.mises_stress_max, std::sqrt(1.5) * deviator.norm());
    accumulated += std::sqrt(2. / 3) * flow.norm();
    if (accumulated > 0)
      integrals.plastic_volume += point.weight;
    integrals.plastic_strain_max = std::max(integrals.plastic_strain_max, accumulated);
    if (branch[index] == Branch::apex || branch[index] == Branch::cutoff_apex)
      ++integrals.apex_points;
    integrals.largest_yield_excess =
      std::max(integrals.largest_yield_excess,
               laws::yield_excess(law, sigma, trial[index].hardening_variable));
  }

  template <int dim>
  StepIntegrals MaterialPoints<dim>::commit()
  {
    StepIntegrals result;
    std::size_t   index = 0;
    for (const auto &cell : space.cells())
      for (const auto &point : cell.points)
        add_point(index++, material_laws[cell.body], point, result);
    const Communicator &processes = space.communicator();
    double              apex      = result.apex_points;
    for (double *const total : {&result.dissipation,
                                &result.mean_dissipation,
                                &result.elastic_energy,
                                &result.plastic_volume,
                                &apex})
      *total = processes.sum(*total);
    for (double *const largest :
         {&result.mises_stress_max, &result.plastic_strain_max, &result.largest_yield_excess})
      *largest = processes.max(*largest);
    result.apex_points = static_cast<unsigned int>(apex);
    committed.stresses = stress;
    committed.states   = trial;
    return result;
  }

  template <int dim>
  void MaterialPoints<dim>::reset()
  {
    std::fill(committed.states.begin(), committed.states.end(), laws::State());
    std::fill(committed.accumulated_strain.begin(), committed.accumulated_strain.end(), 0.);
    std::fill(committed.stresses.begin(), committed.stresses.end(), laws::StressTensor());
  }

  namespace
  {
    /// Numbers that a quadrature point remembers: εᵖ, ε̄ᵖ, ∫ √(2/3) |dεᵖ| and σ.
    constexpr std::size_t numbers_per_point = 14;

    void append(const laws::StressTensor &tensor, std::vector<double> &numbers)
    {
      for (unsigned int c = 0; c < 6; ++c)
        numbers.push_back(tensor.access_raw_entry(c));
    }

    const double *take(const double *number, laws::StressTensor &tensor)
    {
      for (unsigned int c = 0; c < 6; ++c)
        tensor.access_raw_entry(c) = *number++;
      return number;
    }
  } // namespace

  template <int dim>
  std::vector<double> MaterialPoints<dim>::save() const
  {
    // Every process' cells, then sorted by their place in the bodies.
    std::vector<double> places, numbers;
    std::size_t         point   = 0;
    const std::size_t   n_cells = space.dof_handler().get_triangulation().n_active_cells();
    for (const auto &cell : space.cells())
      {
        places.push_back(static_cast<double>(cell.body * n_cells + cell.index));
        for (std::size_t q = 0; q < cell.points.size(); ++q, ++point)
          {
            append(committed.states[point].plastic_strain, numbers);
            numbers.push_back(committed.states[point].hardening_variable);
            numbers.push_back(committed.accumulated_strain[point]);
            append(committed.stresses[point], numbers);
          }
      }
    const auto          all_places  = space.communicator().gather(places);
    const auto          all_numbers = space.communicator().gather(numbers);
    const std::size_t   per_cell    = all_numbers.size() / all_places.size();
    std::vector<double> sorted(all_numbers.size());
    for (std::size_t c = 0; c < all_places.size(); ++c)
      std::copy_n(all_numbers.begin() + static_cast<std::ptrdiff_t>(c * per_cell),
                  per_cell,
                  sorted.begin() + static_cast<std::ptrdiff_t>(all_places[c]) *
                                     static_cast<std::ptrdiff_t>(per_cell));
    return sorted;
  }

  template <int dim>
  void MaterialPoints<dim>::restore(const Arrays &saved)
  {
    const std::size_t n_cells  = space.dof_handler().get_triangulation().n_active_cells();
    const std::size_t per_cell = space.cells().front().points.size() * numbers_per_point;
    const auto       &numbers  = array(saved, "points", {space.n_bodies() * n_cells * per_cell});
    std::size_t       point    = 0;
    for (const auto &cell : space.cells())
      {
        const double *number = numbers.data() + (cell.body * n_cells + cell.index) * per_cell;
        for (std::size_t q = 0; q < cell.points.size(); ++q, ++point)
          {
            number = take(number, committed.states[point].plastic_strain);
            committed.states[point].hardening_variable = *number++;
            committed.accumulated_strain[point]        = *number++;
            number                                     = take(number, committed.stresses[point]);
          }
      }
  }

  template class MaterialPoints<2>;
  template class MaterialPoints<3>;
} // namespace dpcontact
