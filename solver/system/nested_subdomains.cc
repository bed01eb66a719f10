#include "solver/system/nested_subdomains.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace dpcontact
{
  namespace
  {
    constexpr double growth = 1.6; ///< ratio of the radii of successive subdomains
    /// Share of a subdomain's radius that may be used before the next one is taken.
    constexpr double margin = 0.85;

    /// Radii from the first few elements at the axis to half of the body; what is larger is the
    /// whole.
    template <int dim>
    std::vector<double> growing_radii(const Discretisation<dim> &space)
    {
      double largest = 0;
      for (const auto &cell : space.cells())
        for (const auto &point : cell.points)
          largest = std::max(largest, point.position.norm());
      double first = 0;
      for (unsigned int f = 0; f < std::min<std::size_t>(3, space.surface().size()); ++f)
        for (const auto &point : space.surface()[f].points)
          first = std::max(first, point.radius);
      std::vector<double> radii;
      for (double r = 1.5 * first; r < largest / 2; r *= growth)
        radii.push_back(r);
      return radii;
    }
  } // namespace

  template <int dim>
  NestedSubdomains<dim>::NestedSubdomains(const Discretisation<dim>       &space_,
                                          std::vector<std::vector<double>> elastic_blocks_,
                                          const Condensation               condensation,
                                          const bool                       symmetric_,
                                          const LinearSolver               kind_)
    : space(space_)
    , elastic_blocks(std::move(elastic_blocks_))
    , symmetric(symmetric_)
    , kind(kind_)
  {
    if (condensation == Condensation::nested_subdomains)
      radii = growing_radii(space);
    radii.push_back(std::numeric_limits<double>::infinity());
    made.resize(radii.size());
    use_first();
    if (condensation == Condensation::none)
      elastic_blocks = {}; // no other subdomain will ask for them
  }

  template <int dim>
  void NestedSubdomains<dim>::use(const std::size_t stage_)
  {
    stage = stage_;
    if (!made[stage])
      made[stage] = std::make_unique<CondensedSubdomain<dim>>(
        space, elastic_blocks, radii[stage], symmetric, kind);
    subdomain = made[stage].get();
  }

  template <int dim>
  void NestedSubdomains<dim>::cover(const double distance)
  {
    std::size_t next = stage;
    while (distance > margin * radii[next])
      ++next;
    if (next != stage)
      use(next);
  }

  template class NestedSubdomains<2>;
  template class NestedSubdomains<3>;
} // namespace dpcontact
