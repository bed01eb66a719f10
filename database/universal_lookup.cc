#include "database/universal_lookup.h"

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

    std::array<double, n_smooth> smooth_of(const UniversalNode &node)
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

    constexpr std::array<double UniversalNode::*, 10> error_members{
      &UniversalNode::a_error,
      &UniversalNode::b_error,
      &UniversalNode::m_error,
      &UniversalNode::n_error,
      &UniversalNode::a_misfit,
      &UniversalNode::b_misfit,
      &UniversalNode::m_misfit,
      &UniversalNode::n_misfit,
      &UniversalNode::approach_error,
      &UniversalNode::residual_approach_error};

    /// Weights of the nodes at x: the polynomial through all of them.
    std::vector<double> barycentric_weights(const std::vector<double> &nodes, const double x)
    {
      std::vector<double> weights(nodes.size());
      double              sum = 0;
      for (std::size_t i = 0; i < nodes.size(); ++i)
        {
          if (x == nodes[i])
            {
              std::fill(weights.begin(), weights.end(), 0.);
              weights[i] = 1;
              return weights;
            }
          double product = 1;
          for (std::size_t k = 0; k < nodes.size(); ++k)
            if (k != i)
              product *= (nodes[i] - nodes[k]) / (nodes.back() - nodes.front()) * 4;
          sum += weights[i] = 1 / (product * (x - nodes[i]));
        }
      for (double &weight : weights)
        weight /= sum;
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
    check_range("nu", nu, table.nu().front(), table.nu().back(), outside);
    check_range("phi", phi_deg, table.phi_deg().front(), table.phi_deg().back(), outside);
    const auto over_nu  = barycentric_weights(table.nu(), nu);
    const auto over_phi = barycentric_weights(table.phi_deg(), phi_deg);
    const auto near_nu  = linear_weights(table.nu(), nu);
    const auto near_phi = linear_weights(table.phi_deg(), phi_deg);

    std::vector<double>              x;
    std::vector<std::vector<double>> values(n_smooth), bounds(error_members.size());
    for (std::size_t k = 0; k < levels.size(); ++k)
      {
        x.push_back(std::log(levels[k]));
        for (auto &list : values)
          list.push_back(0);
        for (auto &list : bounds)
          list.push_back(0);
        for (std::size_t i = 0; i < table.nu().size(); ++i)
          for (std::size_t j = 0; j < table.phi_deg().size(); ++j)
            {
              const UniversalNode &node          = table.node(i, j, k);
              const auto           smooth_values = smooth_of(node);
              for (std::size_t c = 0; c < n_smooth; ++c)
                values[c].back() += over_nu[i] * over_phi[j] * smooth_values[c];
              for (std::size_t c = 0; c < error_members.size(); ++c)
                bounds[c].back() += near_nu[i] * near_phi[j] * node.*error_members[c];
            }
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
    for (const auto &list : bounds)
      errors.push_back(curve_through(x, list, gsl_interp_linear));
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

    using I             = InterpolationError;
    value.interpolation = {I::a * a, I::b, I::m * m, I::n};
    for (std::size_t c = 0; c < 4; ++c)
      {
        value.numerical[c] = errors[c](x);
        value.misfit[c]    = errors[4 + c](x);
      }
    value.approach_error = errors[8](x) + I::approach;
    value.residual_error = errors[9](x) + I::approach * value.approach;
    return value;
  }
} // namespace dpcontact
