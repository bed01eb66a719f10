#include "database/tables/universal_uncertainty.h"

#include "database/contact_law/contact_law.h"

#include <algorithm>
#include <cmath>

namespace dpcontact
{
  namespace
  {
    // The stated uncertainty of each outcome, by runs/studies/calibrate. It adds
    // - shares of the roughness. Along Λ it is scatter of the rows, which the loading curve, one
    //   through many of them, smooths: of a next to nothing counts;
    constexpr Outcome rough_share{0.3, 0.38, 0.31, 0.28, 0.12, 0.13}; // along ν and along φ
    constexpr Outcome rough_level_share{9.1e-4, 0.064, 0.21, 0.17, 0.046, 0.33};
    // - a share of what the nodes state, times powers of φ/30° up to 1 and of Λ from 1 to 200. They
    //   state the errors of loading by the plastic excess of the approach, which low friction makes
    //   large without making the loading curve less accurate;
    constexpr Outcome numerical_share{0.084, 0.56, 0.0064, 9.1e-4, 0.72, 0.1};
    constexpr Outcome numerical_phi_exponent{1.4, 1.8, 0.096, 2, 0.41, 0.26};
    constexpr Outcome numerical_level_exponent{0.3, -0.095, -0.13, -0.3, -0.016, 0.25};
    constexpr double  lowest_weighted_level = 1, highest_weighted_level = 200;
    // - a floor, of some falling with Λ: just past first yield next to nothing is left of the
    //   approach.
    constexpr Outcome floor_error{1e-4, 6.1e-6, 1.2e-4, 2.3e-4, 2.9e-5, 6.1e-6};
    constexpr Outcome floor_exponent{0.6, 0, 0, 0.066, 0, 0.6};
  } // namespace

  void add_scaled(Outcome &sum, const double factor, const Outcome &added)
  {
    for (std::size_t c = 0; c < n_outcomes; ++c)
      sum[c] += factor * added[c];
  }

  std::vector<Outcome> roughness(const std::vector<double> &x, const std::vector<Outcome> &y)
  {
    const std::size_t n = x.size();
    if (n < 3)
      {
        Outcome apart = y.back();
        add_scaled(apart, -1, y.front());
        for (double &value : apart)
          value = std::abs(value);
        return std::vector<Outcome>(n, apart);
      }
    const std::size_t    reach = n < 5 ? 1 : 2;
    std::vector<Outcome> result;
    for (std::size_t k = 0; k < n; ++k)
      {
        const std::size_t        at = std::clamp(k, reach, n - 1 - reach);
        std::vector<double>      neighbours;
        std::vector<std::size_t> places;
        for (std::size_t i = at - reach; i <= at + reach; ++i)
          if (i != at)
            {
              neighbours.push_back(x[i]);
              places.push_back(i);
            }
        const auto weights = contact_law_detail::lagrange(neighbours, 0, places.size(), x[at]);
        Outcome    apart{};
        add_scaled(apart, -1, y[at]);
        for (std::size_t i = 0; i < places.size(); ++i)
          add_scaled(apart, weights[i], y[places[i]]);
        for (double &value : apart)
          value = std::abs(value);
        result.push_back(apart);
      }
    return result;
  }

  Outcome numerical_of(const UniversalNode &node)
  {
    return {node.a_error / node.a,
            node.b_error,
            node.m_error / node.m,
            node.n_error,
            node.approach_error,
            node.residual_approach_error / node.approach};
  }

  double stated_interpolation_error(const std::size_t c, const std::array<Outcome, n_parts> &parts)
  {
    return rough_share[c] * (parts[rough_along_nu][c] + parts[rough_along_phi][c]) +
           rough_level_share[c] * parts[rough_along_level][c];
  }

  double stated_numerical_error(const std::size_t                   c,
                                const std::array<Outcome, n_parts> &parts,
                                const double                        phi_deg,
                                const double                        load_level)
  {
    const double level = std::max(load_level, lowest_weighted_level);
    return floor_error[c] * std::pow(level, -floor_exponent[c]) +
           numerical_share[c] * parts[stated_by_nodes][c] *
             std::pow(std::min(phi_deg / 30, 1.), numerical_phi_exponent[c]) *
             std::pow(std::min(level, highest_weighted_level), numerical_level_exponent[c]);
  }
} // namespace dpcontact
