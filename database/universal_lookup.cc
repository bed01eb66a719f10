#include "database/universal_lookup.h"

#include "database/contact_law.h"
#include "database/text.h"
#include "meshing/errors.h"
#include "solver/first_yield.h"

#include <gsl/gsl_interp.h>
#include <gsl/gsl_spline.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace dpcontact
{
  namespace
  {
    /// Logarithms and exponents that are smooth over ν, φ and ln Λ.
    enum Smooth
    {
      ln_approach,
      ln_recovered,
      loading_exponent,
      unloading_exponent,
      ln_loading_at_peak,
      ln_unloading_at_peak,
      n_smooth
    };
    using SmoothValues = std::array<double, n_smooth>;

    SmoothValues smooth_of(const UniversalNode &node)
    {
      const double level = node.load_level, hertz = std::pow(level, 2. / 3);
      const double recovered = node.approach - node.residual_approach;
      return {std::log(node.approach / hertz),
              std::log(recovered / hertz),
              node.b,
              node.n,
              std::log(node.a * std::pow(node.approach, node.b) / level),
              std::log(node.m * std::pow(recovered, node.n) / level)};
    }

    /// What a lookup states an uncertainty of: ln a, b, ln m, n, ln(δ/δ_y), δ_res/δ.
    constexpr std::size_t n_outcomes = 6;
    using Outcome                    = std::array<double, n_outcomes>;

    Outcome outcome_of(const SmoothValues &value, const double level)
    {
      const double ln_level = std::log(level), ln_hertz = 2. / 3 * ln_level;
      const double b = value[loading_exponent], n = value[unloading_exponent];
      return {ln_level + value[ln_loading_at_peak] - b * (value[ln_approach] + ln_hertz),
              b,
              ln_level + value[ln_unloading_at_peak] - n * (value[ln_recovered] + ln_hertz),
              n,
              value[ln_approach] + ln_hertz,
              1 - std::exp(value[ln_recovered] - value[ln_approach])};
    }

    Outcome difference(const Outcome &p, const Outcome &q)
    {
      Outcome result{};
      for (std::size_t c = 0; c < n_outcomes; ++c)
        result[c] = std::abs(p[c] - q[c]);
      return result;
    }

    /// At every level, how far it is from the cubic through the two before and the two behind; next
    /// to the ends that of the nearest with such neighbours.
    std::vector<Outcome> roughness(const std::vector<double> &x, const std::vector<Outcome> &y)
    {
      const std::size_t    n = x.size();
      std::vector<Outcome> result(n, Outcome{});
      for (std::size_t k = 0; n > 4 && k < n; ++k)
        {
          const std::size_t         at = std::clamp<std::size_t>(k, 2, n - 3);
          const std::vector<double> neighbours{x[at - 2], x[at - 1], x[at + 1], x[at + 2]};
          const auto                weights = contact_law_detail::lagrange(neighbours, 0, 4, x[at]);
          for (std::size_t c = 0; c < n_outcomes; ++c)
            result[k][c] =
              std::abs(weights[0] * y[at - 2][c] + weights[1] * y[at - 1][c] +
                       weights[2] * y[at + 1][c] + weights[3] * y[at + 2][c] - y[at][c]);
        }
      return result;
    }

    /// The largest at a level and its two neighbours: an estimate that passes through zero
    /// between them says nothing.
    double
    largest_around(const std::vector<Outcome> &list, const std::size_t k, const std::size_t outcome)
    {
      double result = list[k][outcome];
      if (k > 0)
        result = std::max(result, list[k - 1][outcome]);
      if (k + 1 < list.size())
        result = std::max(result, list[k + 1][outcome]);
      return result;
    }

    /// What a node states as numerical error of each outcome.
    Outcome numerical_of(const UniversalNode &node)
    {
      return {node.a_error / node.a,
              node.b_error,
              node.m_error / node.m,
              node.n_error,
              node.approach_error,
              node.residual_approach_error / node.approach};
    }

    // The stated uncertainty of each outcome, calibrated on runs/held_out_calibration.json and
    // runs/held_out_first.json. Its parts:
    // - a floor, for m and n falling with Λ: just past first yield next to nothing is left of the
    //   approach, and the fit of the unloading is least certain;
    constexpr Outcome floor_error{3e-5, 3e-5, 1e-4, 3e-4, 3e-5, 3e-5};
    constexpr Outcome floor_exponent{0, 0, .25, .25, 0, 0};
    // - shares of the differences to a lower order, and of the roughness over ln Λ (nodes of a, b
    //   and the approach are smoothed along the loading curve, those of m, n and the residual are
    //   not);
    constexpr Outcome share_along_nu{.7, .5, .5, .5, .5, .5};
    constexpr double  share_along_phi = .5;
    constexpr Outcome share_along_level{.03, .06, .2, .2, .06, .2};
    // - a share of what the nodes state, times powers of φ/30° up to 1 and of Λ from 1 on. They
    //   state the errors of loading by the plastic excess of the approach, which low friction makes
    //   large without making the loading curve less accurate.
    constexpr Outcome numerical_share{.086, .215, .09, .065, .77, .13};
    constexpr Outcome numerical_phi_exponent{2, 2, 0, 0, 1, 0};
    constexpr Outcome numerical_level_exponent{.35, .25, 0, 0, 0, 0};

    double interpolation_error(const std::size_t c,
                               const double      along_nu,
                               const double      along_phi,
                               const double      along_level)
    {
      return share_along_nu[c] * along_nu + share_along_phi * along_phi +
             share_along_level[c] * along_level;
    }

    double numerical_error(const std::size_t c,
                           const double      stated,
                           const double      phi_deg,
                           const double      load_level)
    {
      const double level = std::max(load_level, 1.);
      return floor_error[c] * std::pow(level, -floor_exponent[c]) +
             numerical_share[c] * stated *
               std::pow(std::min(phi_deg / 30, 1.), numerical_phi_exponent[c]) *
               std::pow(level, numerical_level_exponent[c]);
    }

    constexpr std::array<double UniversalNode::*, 4> misfit_members{&UniversalNode::a_misfit,
                                                                    &UniversalNode::b_misfit,
                                                                    &UniversalNode::m_misfit,
                                                                    &UniversalNode::n_misfit};

    /// The cubic through the four nodes around x: of lower order than contact_law_detail::weights.
    std::vector<double> cubic_weights(const std::vector<double> &nodes, const double x)
    {
      const std::size_t n = nodes.size(), count = std::min<std::size_t>(n, 4);
      const auto        above =
        static_cast<std::size_t>(std::lower_bound(nodes.begin(), nodes.end(), x) - nodes.begin());
      const std::size_t   first = std::min(above < 2 ? 0 : above - 2, n - count);
      const auto          local = contact_law_detail::lagrange(nodes, first, count, x);
      std::vector<double> weights(n, 0.);
      std::copy(local.begin(), local.end(), weights.begin() + static_cast<std::ptrdiff_t>(first));
      return weights;
    }

    /// The polynomial through every second node, from the first on, and the last.
    std::vector<double> sparse_weights(const std::vector<double> &nodes, const double x)
    {
      std::vector<std::size_t> kept;
      std::vector<double>      positions;
      for (std::size_t i = 0; i < nodes.size(); ++i)
        if (i % 2 == 0 || i + 1 == nodes.size())
          {
            kept.push_back(i);
            positions.push_back(nodes[i]);
          }
      const auto          local = contact_law_detail::lagrange(positions, 0, positions.size(), x);
      std::vector<double> weights(nodes.size(), 0.);
      for (std::size_t i = 0; i < kept.size(); ++i)
        weights[kept[i]] = local[i];
      return weights;
    }

    /// Linear between the two neighbours.
    std::vector<double> linear_weights(const std::vector<double> &nodes, const double x)
    {
      std::vector<double> weights(nodes.size(), 0.);
      const auto          above = static_cast<std::size_t>(
        std::upper_bound(nodes.begin() + 1, nodes.end() - 1, x) - nodes.begin());
      const double t =
        std::clamp((x - nodes[above - 1]) / (nodes[above] - nodes[above - 1]), 0., 1.);
      weights[above - 1] = 1 - t;
      weights[above]     = t;
      return weights;
    }

    /// A curve through points by GSL; straight on beyond the ends.
    std::function<double(double)> curve_through(const std::vector<double> &x,
                                                const std::vector<double> &y,
                                                const gsl_interp_type     *type)
    {
      const std::shared_ptr<gsl_spline> spline(gsl_spline_alloc(type, x.size()), &gsl_spline_free);
      gsl_spline_init(spline.get(), x.data(), y.data(), x.size());
      return [spline, low = x.front(), high = x.back()](const double at) {
        const double inside = std::clamp(at, low, high);
        const double value  = gsl_spline_eval(spline.get(), inside, nullptr);
        return at == inside
                 ? value
                 : value + (at - inside) * gsl_spline_eval_deriv(spline.get(), inside, nullptr);
      };
    }
  } // namespace

  void check_range(const std::string &axis,
                   const double       value,
                   const double       low,
                   const double       high,
                   const Outside      outside)
  {
    if (outside == Outside::refuse && !(value >= low * (1 - 1e-9) && value <= high * (1 + 1e-9)))
      throw InputError(axis + " = " + number_text(value) + " lies outside the data, which have " +
                       axis + " from " + number_text(low) + " to " + number_text(high) +
                       "; --extrapolate goes there all the same, without a stated error");
  }

  UniversalFamily::UniversalFamily(const UniversalTable &table,
                                   const double          nu,
                                   const double          phi_deg,
                                   const Outside         outside)
    : levels(table.load_level())
  {
    if (table.nu().size() < 2 || table.phi_deg().size() < 2 || levels.size() < 4)
      throw InputError("universal table: interpolation needs two nu, two phi and four load levels");
    check_range("nu", nu, table.nu().front(), table.nu().back(), outside);
    check_range("phi", phi_deg, table.phi_deg().front(), table.phi_deg().back(), outside);
    // Of ν and φ each the weights that count, and those of a lower order to compare them with.
    const auto over_nu   = contact_law_detail::weights(table.nu(), nu);
    const auto over_phi  = contact_law_detail::weights(table.phi_deg(), phi_deg);
    const auto sparse_nu = sparse_weights(table.nu(), nu);
    const auto cubic_phi = cubic_weights(table.phi_deg(), phi_deg);
    const auto near_nu   = linear_weights(table.nu(), nu);
    const auto near_phi  = linear_weights(table.phi_deg(), phi_deg);

    std::vector<double>              x;
    std::vector<std::vector<double>> values(n_smooth), misfits(misfit_members.size());
    std::vector<Outcome>             outcomes, along_nu, along_phi, stated_by_nodes;
    for (std::size_t k = 0; k < levels.size(); ++k)
      {
        x.push_back(std::log(levels[k]));
        SmoothValues value{}, by_sparse_nu{}, by_cubic_phi{};
        for (auto &list : misfits)
          list.push_back(0);
        stated_by_nodes.push_back({});
        for (std::size_t i = 0; i < table.nu().size(); ++i)
          for (std::size_t j = 0; j < table.phi_deg().size(); ++j)
            {
              const UniversalNode &node          = table.node(i, j, k);
              const SmoothValues   smooth_values = smooth_of(node);
              for (std::size_t c = 0; c < n_smooth; ++c)
                {
                  value[c] += over_nu[i] * over_phi[j] * smooth_values[c];
                  by_sparse_nu[c] += sparse_nu[i] * over_phi[j] * smooth_values[c];
                  by_cubic_phi[c] += over_nu[i] * cubic_phi[j] * smooth_values[c];
                }
              const Outcome stated = numerical_of(node);
              const double  near   = near_nu[i] * near_phi[j];
              for (std::size_t c = 0; c < n_outcomes; ++c)
                stated_by_nodes.back()[c] += near * stated[c];
              for (std::size_t c = 0; c < misfit_members.size(); ++c)
                misfits[c].back() += near * node.*misfit_members[c];
            }
        for (std::size_t c = 0; c < n_smooth; ++c)
          values[c].push_back(value[c]);
        outcomes.push_back(outcome_of(value, levels[k]));
        along_nu.push_back(difference(outcome_of(by_sparse_nu, levels[k]), outcomes.back()));
        along_phi.push_back(difference(outcome_of(by_cubic_phi, levels[k]), outcomes.back()));
      }
    const auto along_level = roughness(x, outcomes);
    for (std::size_t c = 0; c < n_outcomes; ++c)
      {
        std::vector<double> added, left;
        for (std::size_t k = 0; k < levels.size(); ++k)
          {
            added.push_back(interpolation_error(c,
                                                largest_around(along_nu, k, c),
                                                largest_around(along_phi, k, c),
                                                largest_around(along_level, k, c)));
            left.push_back(numerical_error(c, stated_by_nodes[k][c], phi_deg, levels[k]));
          }
        interpolation.push_back(curve_through(x, added, gsl_interp_linear));
        numerical.push_back(curve_through(x, left, gsl_interp_linear));
      }
    Material material;
    material.youngs_modulus       = 1e11;
    material.poisson_ratio        = nu;
    material.friction_angle       = phi_deg * (M_PI / 180);
    material.compressive_strength = 1e2;
    const FirstYield yield        = dpcontact::first_yield(material, 0.1);
    onset_level                   = yield.onset_force() / yield.force;
    for (const auto &list : values)
      smooth.push_back(curve_through(x, list, gsl_interp_cspline));
    for (const auto &list : misfits)
      misfit.push_back(curve_through(x, list, gsl_interp_linear));
  }

  double UniversalFamily::approach(const double load_level, const Outside outside) const
  {
    if (!std::isfinite(load_level) || load_level < 0)
      throw InputError("load level " + number_text(load_level) + ": must be finite and at least 0");
    const double hertz = std::pow(load_level, 2. / 3);
    if (load_level <= onset_level)
      return hertz;
    check_range("load level F_max/F_y", load_level, 0, levels.back(), outside);
    return hertz * std::exp(smooth[ln_approach](std::log(load_level)));
  }

  UniversalValue UniversalFamily::at(const double load_level, const Outside outside) const
  {
    UniversalValue value{};
    value.approach = approach(load_level, outside);
    if (load_level <= onset_level || load_level < levels.front())
      {
        value.coefficients = {1, 1.5, 1, 1.5};
        return value;
      }
    const double x = std::log(load_level);
    const double recovered =
      std::min(std::pow(load_level, 2. / 3) * std::exp(smooth[ln_recovered](x)), value.approach);
    const double b = smooth[loading_exponent](x), n = smooth[unloading_exponent](x);
    const double a =
      load_level * std::exp(smooth[ln_loading_at_peak](x)) / std::pow(value.approach, b);
    const double m =
      load_level * std::exp(smooth[ln_unloading_at_peak](x)) / std::pow(recovered, n);
    value.coefficients      = {a, b, m, n};
    value.residual_approach = value.approach - recovered;
    value.residual_eq18     = value.approach - std::pow(load_level / m, 1 / n);

    const std::array<double, 4> unit{a, 1, m, 1}; // a and m have relative errors
    for (std::size_t c = 0; c < 4; ++c)
      {
        value.interpolation[c] = interpolation[c](x) * unit[c];
        value.numerical[c]     = numerical[c](x) * unit[c];
        value.misfit[c]        = misfit[c](x);
      }
    value.approach_error = interpolation[4](x) + numerical[4](x);
    value.residual_error = (interpolation[5](x) + numerical[5](x)) * value.approach;
    return value;
  }
} // namespace dpcontact
