#include "solver/contact_system.h"

#include <algorithm>
#include <cmath>

namespace dpcontact
{
  using laws::Branch;

  template <int dim>
  void ContactSystem<dim>::restore(const Snapshot &saved)
  {
    u                             = saved.u;
    approach                      = saved.approach;
    contact_condition.multipliers = saved.multipliers;
    history                       = saved.history;
    accumulated                   = saved.accumulated;
    committed_stress              = saved.stress;
    committed_surface             = saved.surface;
  }

  template <int dim>
  void ContactSystem<dim>::reset()
  {
    std::fill(u.begin(), u.end(), 0.);
    approach = 0;
    contact_condition.forget();
    std::fill(history.begin(), history.end(), State());
    std::fill(accumulated.begin(), accumulated.end(), 0.);
    std::fill(committed_stress.begin(), committed_stress.end(), laws::StressTensor());
    contact_condition.set_active(true);
    committed_surface = contact_condition.state(u, approach);
    use_core(0);
  }

  template <int dim>
  typename ContactSystem<dim>::Integrals ContactSystem<dim>::commit()
  {
    Integrals   result;
    std::size_t index = 0;
    for (const auto &cell : space.cells())
      for (const auto &point : cell.points)
        {
          const laws::Law &law   = laws[cell.body];
          const double     shear = laws::shear_modulus(law), bulk = laws::bulk_modulus(law);
          const auto      &sigma = stress[index];
          const auto       flow  = trial[index].plastic_strain - history[index].plastic_strain;
          result.dissipation += point.weight * (sigma * flow);
          result.mean_dissipation +=
            point.weight * ((committed_stress[index] * flow + sigma * flow) / 2);
          const auto   deviator = dealii::deviator(sigma);
          const double mean     = dealii::trace(sigma) / 3;
          result.elastic_energy +=
            point.weight * ((deviator * deviator) / (4 * shear) + mean * mean / (2 * bulk));
          result.mises_stress_max =
            std::max(result.mises_stress_max, std::sqrt(1.5) * deviator.norm());
          accumulated[index] += std::sqrt(2. / 3) * flow.norm();
          if (accumulated[index] > 0)
            result.plastic_volume += point.weight;
          result.plastic_strain_max = std::max(result.plastic_strain_max, accumulated[index]);
          if (branch[index] == Branch::apex || branch[index] == Branch::cutoff_apex)
            ++result.apex_points;
          result.largest_yield_excess =
            std::max(result.largest_yield_excess,
                     laws::yield_excess(law, sigma, trial[index].hardening_variable));
          ++index;
        }
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
    for (unsigned int b = 0; b < space.n_bodies(); ++b)
      {
        const double far = u[space.far_unknown(b)];
        result.elastic_energy += space.exterior_stiffness(b) * far * far / 2;
      }
    const auto surface = contact_condition.state(u, approach);
    result.work        = contact_condition.work(committed_surface, surface);
    committed_surface  = surface;
    committed_stress   = stress;
    history            = trial;
    return result;
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
  Arrays ContactSystem<dim>::save() const
  {
    // Every process' cells, then sorted by their place in the bodies.
    std::vector<double> places, numbers;
    std::size_t         point = 0, per_cell = 0;
    const std::size_t   n_cells = space.dof_handler().get_triangulation().n_active_cells();
    for (const auto &cell : space.cells())
      {
        places.push_back(static_cast<double>(cell.body * n_cells + cell.index));
        for (std::size_t q = 0; q < cell.points.size(); ++q, ++point)
          {
            append(history[point].plastic_strain, numbers);
            numbers.push_back(history[point].hardening_variable);
            numbers.push_back(accumulated[point]);
            append(committed_stress[point], numbers);
          }
        per_cell = cell.points.size() * numbers_per_point;
      }
    const auto all_places  = space.communicator().gather(places);
    const auto all_numbers = space.communicator().gather(numbers);
    per_cell               = all_numbers.size() / all_places.size();
    std::vector<double> sorted(all_numbers.size());
    for (std::size_t c = 0; c < all_places.size(); ++c)
      std::copy_n(all_numbers.begin() + static_cast<std::ptrdiff_t>(c * per_cell),
                  per_cell,
                  sorted.begin() + static_cast<std::ptrdiff_t>(all_places[c]) *
                                     static_cast<std::ptrdiff_t>(per_cell));
    return {{"displacements", u},
            {"approach", {approach}},
            {"multipliers", contact_condition.multipliers},
            {"points", sorted},
            {"contact pressure", committed_surface.pressure},
            {"contact displacement", committed_surface.inward}};
  }

  template <int dim>
  void ContactSystem<dim>::restore(const Arrays &saved)
  {
    const std::size_t n_cells     = space.dof_handler().get_triangulation().n_active_cells();
    const std::size_t per_cell    = space.cells().front().points.size() * numbers_per_point;
    const std::size_t n_contact   = contact_condition.multipliers.size();
    const auto       &numbers     = array(saved, "points", {space.n_bodies() * n_cells * per_cell});
    u                             = array(saved, "displacements", {u.size()});
    approach                      = array(saved, "approach", {1}).front();
    contact_condition.multipliers = array(saved, "multipliers", {n_contact});
    committed_surface.pressure    = array(saved, "contact pressure", {n_contact});
    committed_surface.inward      = array(saved, "contact displacement", {n_contact});
    std::size_t point             = 0;
    for (const auto &cell : space.cells())
      {
        const double *number = numbers.data() + (cell.body * n_cells + cell.index) * per_cell;
        for (std::size_t q = 0; q < cell.points.size(); ++q, ++point)
          {
            number                            = take(number, history[point].plastic_strain);
            history[point].hardening_variable = *number++;
            accumulated[point]                = *number++;
            number                            = take(number, committed_stress[point]);
          }
      }
  }

  template void                                 ContactSystem<2>::restore(const Snapshot &);
  template void                                 ContactSystem<3>::restore(const Snapshot &);
  template void                                 ContactSystem<2>::restore(const Arrays &);
  template void                                 ContactSystem<3>::restore(const Arrays &);
  template void                                 ContactSystem<2>::reset();
  template void                                 ContactSystem<3>::reset();
  template Arrays                               ContactSystem<2>::save() const;
  template Arrays                               ContactSystem<3>::save() const;
  template typename ContactSystem<2>::Integrals ContactSystem<2>::commit();
  template typename ContactSystem<3>::Integrals ContactSystem<3>::commit();
} // namespace dpcontact
