#include "database/tables/universal_lookup.h"

#include "database/contact_law/contact_law.h"
#include "meshing/errors.h"
#include "meshing/number_text.h"
#include "solver/closed_form/first_yield.h"

#include <gsl/gsl_interp.h>
#include <gsl/gsl_spline.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
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

    /// The weights of the nodes of ν and of φ.
    struct Weights
    {
      std::vector<double> over_nu, over_phi; ///< of the interpolation
      std::vector<double> near_nu, near_phi; ///< of the neighbours
    };

    /// What the table says at one ν and φ, by load levels.
    struct Reading
    {
      explicit Reading(const std::size_t n_levels)
        : values(n_smooth)
        , misfits(misfit_members.size(), std::vector<double>(n_levels, 0.))
      {
        found.fill(std::vector<Outcome>(n_levels, Outcome{}));
      }

      std::vector<std::vector<double>>          values;  ///< of Smooth
      std::vector<std::vector<double>>          misfits; ///< of the power laws' coefficients
      std::array<std::vector<Outcome>, n_parts> found;   ///< parts of the uncertainty
    };

    /// Appends the values of the k-th load level, and enters its parts of the uncertainty but that
    /// along Λ.
    void
    read_level(const UniversalTable &table, const Weights &w, const std::size_t k, Reading &reading)
    {
      // Interpolated along one axis at every node of the other, and along both.
      const std::size_t         n_nu = w.near_nu.size(), n_phi = w.near_phi.size();
      std::vector<SmoothValues> at_nu(n_nu, SmoothValues{}), at_phi(n_phi, SmoothValues{});
      SmoothValues              value{};
      for (std::size_t i = 0; i < n_nu; ++i)
        for (std::size_t j = 0; j < n_phi; ++j)
          {
            const UniversalNode &node          = table.node(i, j, k);
            const SmoothValues   smooth_values = smooth_of(node);
            for (std::size_t c = 0; c < n_smooth; ++c)
              {
                at_nu[i][c] += w.over_phi[j] * smooth_values[c];
                at_phi[j][c] += w.over_nu[i] * smooth_values[c];
                value[c] += w.over_nu[i] * w.over_phi[j] * smooth_values[c];
              }
            const double near = w.near_nu[i] * w.near_phi[j];
            add_scaled(reading.found[stated_by_nodes][k], near, numerical_of(node));
            for (std::size_t c = 0; c < misfit_members.size(); ++c)
              reading.misfits[c][k] += near * node.*misfit_members[c];
          }
      for (std::size_t c = 0; c < n_smooth; ++c)
        reading.values[c].push_back(value[c]);
      const double level = table.load_level()[k];
      reading.found[rough_along_nu][k] =
        largest_of(roughness(table.nu(), outcomes_of(at_nu, level)), w.near_nu);
      reading.found[rough_along_phi][k] =
        largest_of(roughness(table.phi_deg(), outcomes_of(at_phi, level)), w.near_phi);
    }

    /// Enters the uncertainty's part along Λ.
    /// @param x ln Λ
    void add_roughness_along_level(const UniversalTable      &table,
                                   const Weights             &w,
                                   const std::vector<double> &x,
                                   std::vector<Outcome>      &found)
    {
      for (std::size_t i = 0; i < w.near_nu.size(); ++i)
        for (std::size_t j = 0; j < w.near_phi.size(); ++j)
          if (const double near = w.near_nu[i] * w.near_phi[j]; near != 0)
            {
              std::vector<Outcome> outcomes;
              for (std::size_t k = 0; k < x.size(); ++k)
                outcomes.push_back(
                  outcome_of(smooth_of(table.node(i, j, k)), table.load_level()[k]));
              const auto rough = roughness(x, outcomes);
              for (std::size_t k = 0; k < x.size(); ++k)
                add_scaled(found[k], near, rough[k]);
            }
    }

    /// Load level at which a material yields first, on the axis or on the ring. It depends on ν and
    /// φ only.
    double onset_level_of(const double nu, const double phi_deg)
    {
      Material material;
      material.youngs_modulus       = 1e11;
      material.poisson_ratio        = nu;
      material.friction_angle       = Angle(phi_deg);
      material.compressive_strength = 1e2;
      const FirstYield yield        = first_yield(material, 0.1);
      return yield.onset_force() / yield.force;
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
    const Weights       weights{contact_law_detail::weights(table.nu(), nu),
                          contact_law_detail::weights(table.phi_deg(), phi_deg),
                          linear_weights(table.nu(), nu),
                          linear_weights(table.phi_deg(), phi_deg)};
    std::vector<double> x;
    for (const double level : levels)
      x.push_back(std::log(level));
    Reading reading(levels.size());
    for (std::size_t k = 0; k < levels.size(); ++k)
      read_level(table, weights, k, reading);
    add_roughness_along_level(table, weights, x, reading.found[rough_along_level]);

    for (std::size_t part = 0; part < n_parts; ++part)
      for (std::size_t c = 0; c < n_outcomes; ++c)
        {
          const std::vector<Outcome> &found = reading.found[part];
          std::vector<double>         list;
          for (std::size_t k = 0; k < levels.size(); ++k)
            list.push_back(part == stated_by_nodes ? found[k][c] : largest_around(found, k, c));
          parts[part][c] = curve_through(x, list, gsl_interp_linear);
        }
    onset_level = onset_level_of(nu, phi_deg);
    for (const auto &list : reading.values)
      smooth.push_back(curve_through(x, list, gsl_interp_cspline));
    for (const auto &list : reading.misfits)
      misfit.push_back(curve_through(x, list, gsl_interp_linear));
    find_crests(x);
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

  double UniversalFamily::residual_of_splines(const double x) const
  {
    return std::exp(2. / 3 * x) *
           (std::exp(smooth[ln_approach](x)) - std::exp(smooth[ln_recovered](x)));
  }

  void UniversalFamily::find_crests(const std::vector<double> &x)
  {
    constexpr unsigned int places = 16; // of an interval: every crest among them is refined
    constexpr int          bits   = std::numeric_limits<double>::digits / 2;
    for (std::size_t k = 0; k + 1 < x.size(); ++k)
      {
        const double                   width = (x[k + 1] - x[k]) / places;
        std::array<double, places + 1> height{};
        for (unsigned int i = 0; i <= places; ++i)
          height[i] = residual_of_splines(x[k] + i * width);
        crests.emplace_back(x[k], height[0]);
        for (unsigned int i = 1; i < places; ++i)
          if (height[i] >= height[i - 1] && height[i] >= height[i + 1])
            {
              const auto lowest = boost::math::tools::brent_find_minima(
                [this](const double place) { return -residual_of_splines(place); },
                x[k] + (i - 1) * width,
                x[k] + (i + 1) * width,
                bits);
              crests.emplace_back(lowest.first, -lowest.second);
            }
      }
    crests.emplace_back(x.back(), residual_of_splines(x.back()));
  }

  double UniversalFamily::residual_up_to(const double x) const
  {
    double largest = std::max(0., residual_of_splines(x));
    for (const auto &[place, height] : crests)
      if (place <= x)
        largest = std::max(largest, height);
    return std::min(largest, std::exp(2. / 3 * x + smooth[ln_approach](x)));
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
    const double x         = std::log(load_level);
    const double recovered = value.approach - residual_up_to(x);
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
        interpolation[c] = unit[c] * stated_interpolation_error(c, value.parts);
        numerical[c]     = unit[c] * stated_numerical_error(c, value.parts, phi_deg, load_level);
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
