#include "solver/path/load_path.h"

#include <type_traits>

namespace dpcontact
{
  namespace
  {
    /// Calls `visit` with all numbers of a path's status, real ones, counts and switches, in one
    /// order.
    template <class Status, class Visit>
    void visit_numbers(Status &status, const Visit &visit)
    {
      for (auto *const number : {&status.peak_force,
                                 &status.unloading_from,
                                 &status.approach_guess,
                                 &status.dissipated,
                                 &status.present_force,
                                 &status.last_force,
                                 &status.previous.approach})
        visit(*number);
      auto &integrals = status.last_integrals;
      for (auto *const number : {&integrals.plastic_volume,
                                 &integrals.dissipation,
                                 &integrals.mean_dissipation,
                                 &integrals.work,
                                 &integrals.elastic_energy,
                                 &integrals.mises_stress_max,
                                 &integrals.plastic_strain_max,
                                 &integrals.largest_yield_excess})
        visit(*number);
      auto &checked = status.checked;
      for (auto *const number : {&checked.residual,
                                 &checked.yield_excess,
                                 &checked.penetration,
                                 &checked.work,
                                 &checked.largest_work,
                                 &checked.elastic_energy,
                                 &checked.dissipation,
                                 &checked.mean_dissipation,
                                 &checked.energy_error})
        visit(*number);
      visit(status.unloading);
      visit(status.iterations_of_point);
      visit(integrals.apex_points);
      visit(status.has_previous);
    }

    template <class Counters, class Visit>
    void visit_counters(Counters &counters, const Visit &visit)
    {
      for (auto *const number : {&counters.steps,
                                 &counters.newton_iterations,
                                 &counters.cut_backs,
                                 &counters.augmentations,
                                 &counters.apex_points})
        visit(*number);
    }
  } // namespace

  template <int dim>
  Arrays LoadPath<dim>::save() const
  {
    Arrays saved       = system.save();
    saved["previous"]  = status.previous.u;
    auto      &numbers = saved["path"];
    const auto keep    = [&numbers](const auto &number) {
      numbers.push_back(static_cast<double>(number));
    };
    visit_numbers(status, keep);
    visit_counters(count, keep);
    return saved;
  }

  template <int dim>
  void LoadPath<dim>::restore(const Arrays &saved)
  {
    system.restore(saved);
    status.previous.u         = array(saved, "previous", {0, system.unknowns().u.size()});
    std::size_t total         = 0;
    const auto  count_numbers = [&total](const auto &) { ++total; };
    visit_numbers(status, count_numbers);
    visit_counters(count, count_numbers);
    const auto &numbers = array(saved, "path", {total});
    std::size_t next    = 0;
    const auto  take    = [&](auto &number) {
      number = static_cast<std::decay_t<decltype(number)>>(numbers[next++]);
    };
    visit_numbers(status, take);
    visit_counters(count, take);
    system.contact().set_active(true);
    if (status.present_force > 0)
      {
        system.set_control(Control::force, status.present_force, status.peak_force);
        system.residual();
      }
  }

  template Arrays LoadPath<2>::save() const;
  template Arrays LoadPath<3>::save() const;
  template void   LoadPath<2>::restore(const Arrays &);
  template void   LoadPath<3>::restore(const Arrays &);
} // namespace dpcontact
