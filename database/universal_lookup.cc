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
      ln_recovered_by_law,
      law_exponent,
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
              std::log(node.m * std::pow(recovered, node.n) / level),
              std::log(level / node.m_law) / node.n_law - std::log(hertz),
              node.n_law};
    }

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

    std::vector<Outcome> outcomes_of(const std::vector<SmoothValues> &values, const double level)
    {
      std::vector<Outcome> result;
      for (const SmoothValues &value : values)
        result.push_back(outcome_of(value, level));
      return result;
    }

    /// sum += factor · added
    void add(Outcome &sum, const double factor, const Outcome &added)
    {
      for (std::size_t c = 0; c < n_outcomes; ++c)
        sum[c] += factor * added[c];
    }

    /// At every node of an axis, how far it is from the cubic through the two before and the two
    /// behind, with less than five nodes the straight line through its neighbours; next to the ends
    /// that of the nearest with such neighbours. Two nodes tell their difference only.
    std::vector<Outcome> roughness(const std::vector<double> &x, const std::vector<Outcome> &y)
    {
      const std::size_t n = x.size();
      if (n < 3)
        {
          Outcome apart = y.back();
          add(apart, -1, y.front());
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
          add(apart, -1, y[at]);
          for (std::size_t i = 0; i < places.size(); ++i)
            add(apart, weights[i], y[places[i]]);
          for (double &value : apart)
            value = std::abs(value);
          result.push_back(apart);
        }
      return result;
    }

    /// The largest of the nodes that a weight is not zero of.
    Outcome largest_of(const std::vector<Outcome> &list, const std::vector<double> &weights)
    {
      Outcome result{};
      for (std::size_t i = 0; i < list.size(); ++i)
        for (std::size_t c = 0; c < n_outcomes && weights[i] != 0; ++c)
          result[c] = std::max(result[c], list[i][c]);
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

    // The stated uncertainty of each outcome, by runs/calibrate. It adds
    // - shares of the roughness. Along Λ it is scatter of the rows, which the loading curve, one
    //   through many of them, smooths: of a next to nothing counts;
    constexpr Outcome rough_share{.3, .38, .31, .28, .12, .13}; // along ν and along φ
    constexpr Outcome rough_level_share{9.1e-4, .064, .21, .17, .046, .33};
    // - a share of what the nodes state, times powers of φ/30° up to 1 and of Λ from 1 to 200. They
    //   state the errors of loading by the plastic excess of the approach, which low friction makes
    //   large without making the loading curve less accurate;
    constexpr Outcome numerical_share{.084, .56, .0064, 9.1e-4, .72, .1};
    constexpr Outcome numerical_phi_exponent{1.4, 1.8, .096, 2, .41, .26};
    constexpr Outcome numerical_level_exponent{.3, -.095, -.13, -.3, -.016, .25};
    constexpr double  lowest_weighted_level = 1, highest_weighted_level = 200;
    // - a floor, of some falling with Λ: just past first yield next to nothing is left of the
    //   approach.
    constexpr Outcome floor_error{1e-4, 6.1e-6, 1.2e-4, 2.3e-4, 2.9e-5, 6.1e-6};
    constexpr Outcome floor_exponent{.6, 0, 0, .066, 0, .6};

    double interpolation_error(const std::size_t c, const std::array<Outcome, n_parts> &parts)
    {
      return rough_share[c] * (parts[rough_along_nu][c] + parts[rough_along_phi][c]) +
             rough_level_share[c] * parts[rough_along_level][c];
    }

    double numerical_error(const std::size_t                   c,
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

    constexpr std::array<double UniversalNode::*, 4> misfit_members{&UniversalNode::a_misfit,
                                                                    &UniversalNode::b_misfit,
                                                                    &UniversalNode::m_misfit,
                                                                    &UniversalNode::n_misfit};

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
                                   const double          phi_deg_,
                                   const Outside         outside)
    : levels(table.load_level())
    , phi_deg(phi_deg_)
  {
    if (table.nu().size() < 2 || table.phi_deg().size() < 2 || levels.size() < 4)
      throw InputError("universal table: interpolation needs two nu, two phi and four load levels");
    check_range("nu", nu, table.nu().front(), table.nu().back(), outside);
    check_range("phi", phi_deg, table.phi_deg().front(), table.phi_deg().back(), outside);
    // Of ν and φ each the weights that count, and the neighbours'.
    const auto        over_nu  = contact_law_detail::weights(table.nu(), nu);
    const auto        over_phi = contact_law_detail::weights(table.phi_deg(), phi_deg);
    const auto        near_nu  = linear_weights(table.nu(), nu);
    const auto        near_phi = linear_weights(table.phi_deg(), phi_deg);
    const std::size_t n_nu = near_nu.size(), n_phi = near_phi.size(), n_levels = levels.size();

    std::vector<double> x;
    for (const double level : levels)
      x.push_back(std::log(level));
    std::vector<std::vector<double>>          values(n_smooth), misfits(misfit_members.size());
    std::array<std::vector<Outcome>, n_parts> found;
    found.fill(std::vector<Outcome>(n_levels, Outcome{}));
    for (auto &list : misfits)
      list.assign(n_levels, 0.);
    for (std::size_t k = 0; k < n_levels; ++k)
      {
        // Interpolated along one axis at every node of the other, and along both.
        std::vector<SmoothValues> at_nu(n_nu, SmoothValues{}), at_phi(n_phi, SmoothValues{});
        SmoothValues              value{};
        for (std::size_t i = 0; i < n_nu; ++i)
          for (std::size_t j = 0; j < n_phi; ++j)
            {
              const UniversalNode &node          = table.node(i, j, k);
              const SmoothValues   smooth_values = smooth_of(node);
              for (std::size_t c = 0; c < n_smooth; ++c)
                {
                  at_nu[i][c] += over_phi[j] * smooth_values[c];
                  at_phi[j][c] += over_nu[i] * smooth_values[c];
                  value[c] += over_nu[i] * over_phi[j] * smooth_values[c];
                }
              const double near = near_nu[i] * near_phi[j];
              add(found[stated_by_nodes][k], near, numerical_of(node));
              for (std::size_t c = 0; c < misfit_members.size(); ++c)
                misfits[c][k] += near * node.*misfit_members[c];
            }
        for (std::size_t c = 0; c < n_smooth; ++c)
          values[c].push_back(value[c]);
        found[rough_along_nu][k] =
          largest_of(roughness(table.nu(), outcomes_of(at_nu, levels[k])), near_nu);
        found[rough_along_phi][k] =
          largest_of(roughness(table.phi_deg(), outcomes_of(at_phi, levels[k])), near_phi);
      }
    for (std::size_t i = 0; i < n_nu; ++i)
      for (std::size_t j = 0; j < n_phi; ++j)
        if (const double near = near_nu[i] * near_phi[j]; near != 0)
          {
            std::vector<Outcome> outcomes;
            for (std::size_t k = 0; k < n_levels; ++k)
              outcomes.push_back(outcome_of(smooth_of(table.node(i, j, k)), levels[k]));
            const auto rough = roughness(x, outcomes);
            for (std::size_t k = 0; k < n_levels; ++k)
              add(found[rough_along_level][k], near, rough[k]);
          }
    for (std::size_t part = 0; part < n_parts; ++part)
      for (std::size_t c = 0; c < n_outcomes; ++c)
        {
          std::vector<double> list;
          for (std::size_t k = 0; k < n_levels; ++k)
            list.push_back(part == stated_by_nodes ? found[part][k][c]
                                                   : largest_around(found[part], k, c));
          parts[part][c] = curve_through(x, list, gsl_interp_linear);
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
        value.law_exponent = 1.5;
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
    value.residual_of_law   = std::max(
      value.approach - std::pow(load_level, 2. / 3) * std::exp(smooth[ln_recovered_by_law](x)), 0.);
    value.law_exponent = smooth[law_exponent](x);

    const Outcome unit{a, 1, m, 1, 1, value.approach}; // a, m, approach have relative errors
    Outcome       interpolation{}, numerical{};
    for (std::size_t c = 0; c < n_outcomes; ++c)
      {
        for (std::size_t part = 0; part < n_parts; ++part)
          value.parts[part][c] = parts[part][c](x);
        interpolation[c] = unit[c] * interpolation_error(c, value.parts);
        numerical[c]     = unit[c] * numerical_error(c, value.parts, phi_deg, load_level);
      }
    for (std::size_t c = 0; c < 4; ++c)
      {
        value.interpolation[c] = interpolation[c];
        value.numerical[c]     = numerical[c];
        value.misfit[c]        = misfit[c](x);
      }
    value.approach_error = interpolation[4] + numerical[4];
    value.residual_error = interpolation[5] + numerical[5];
    return value;
  }
} // namespace dpcontact
