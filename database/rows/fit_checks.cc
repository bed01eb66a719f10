#include "database/rows/row_checks.h"
#include "fitting/curve_fit.h"
#include "fitting/least_squares.h"
#include "meshing/number_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace dpcontact
{
  namespace
  {
    // A fit is stored with all digits; what follows from it in closed form has been formed in
    // another order: 7e-10 at most over the shipped rows.
    constexpr double closed_form = 1e-6;

    /// Misfits, over the peak force, that are rounding: nothing follows from them.
    constexpr double exact_fit = 1e-8;

    using Matrix = std::array<std::array<double, 3>, 3>;

    /// (JᵀJ)⁻¹ of the law's first `k` parameters at the points of a fit (curve_fit.h).
    /// @param low, high over δ_y: the points are equidistant from low, without it, to high.
    Matrix inverse_normal(const PowerLaw    &law,
                          const std::size_t  k,
                          const double       low,
                          const double       high,
                          const unsigned int n_points)
    {
      std::array<std::array<double, 6>, 3> rows{}; // JᵀJ, and the unit matrix beside it
      for (unsigned int i = 1; i <= n_points; ++i)
        {
          const double z = low + (high - low) * i / n_points - law.origin;
          if (!(z > 0))
            continue;
          const double                y = law.coefficient * std::pow(z, law.exponent);
          const std::array<double, 3> slope{
            y / law.coefficient, y * std::log(z), -law.exponent * y / z};
          for (std::size_t p = 0; p < k; ++p)
            for (std::size_t q = 0; q < k; ++q)
              rows[p][q] += slope[p] * slope[q];
        }
      for (std::size_t p = 0; p < k; ++p)
        rows[p][3 + p] = 1;
      for (std::size_t p = 0; p < k; ++p) // Gauss and Jordan; the matrix is positive definite
        {
          const double pivot = rows[p][p];
          for (double &entry : rows[p])
            entry /= pivot;
          for (std::size_t q = 0; q < k; ++q)
            if (const double share = rows[q][p]; q != p)
              for (std::size_t c = 0; c < 6; ++c)
                rows[q][c] -= share * rows[p][c];
        }
      Matrix result{};
      for (std::size_t p = 0; p < k; ++p)
        for (std::size_t q = 0; q < k; ++q)
          result[p][q] = rows[p][3 + q];
      return result;
    }

    /// What a row stores of the covariance of two parameters, or of one's standard error.
    struct Spread
    {
      std::string name;
      double      value; ///< over the parameters' units in the fit
      std::size_t p, q;
      bool        is_root; ///< of the variance
    };

    void check_spreads(const std::vector<Spread> &stored,
                       const Matrix              &inverse,
                       const double               variance,
                       const bool                 is_exact,
                       const std::string         &where,
                       Findings                  &findings)
    {
      for (const Spread &spread : stored)
        {
          const double product  = variance * inverse[spread.p][spread.q];
          const double expected = spread.is_root ? std::sqrt(product) : product;
          if (!is_exact)
            findings.require_close(spread.name, spread.value, expected, where, closed_form);
          else if (!(std::abs(spread.value) <= closed_form))
            findings.add(Grade::error, where, versus(spread.name, spread.value, 0));
        }
    }

    bool says_converged(const std::string &stop)
    {
      return stop == describe(StopReason::relative_offset) ||
             stop == describe(StopReason::residual_zero);
    }

    /// Standard errors and covariances.
    void check_spread(const Record &row, const std::string &where, Findings &findings)
    {
      const unsigned int n_points = FitOptions().n_points;
      const double       unit     = row.yield.approach;
      const double       low      = row.state.approach_residual / unit;
      const double       high     = row.state.approach_peak / unit;
      const auto         check    = [&](const PowerLaw            &law,
                             const double               from,
                             const double               rmse,
                             const std::size_t          k,
                             const std::vector<Spread> &stored) {
        const double sum = std::pow(rmse * row.load_level, 2) * n_points;
        check_spreads(stored,
                      inverse_normal(law, k, from, high, n_points),
                      sum / static_cast<double>(n_points - k),
                      rmse < exact_fit,
                      where,
                      findings);
      };
      const FitRow       &fit   = row.fit;
      const Coefficients &error = fit.standard_error;
      check({row.law.a, row.law.b, 0},
            0,
            fit.loading.power_law.rmse,
            2,
            {{"a_standard_error", error.a, 0, 0, true},
             {"b_standard_error", error.b, 1, 1, true},
             {"ab_covariance", fit.loading.covariance, 0, 1, false}});
      check({row.law.m, row.law.n, low},
            low,
            fit.unloading.power_law.rmse,
            2,
            {{"m_standard_error", error.m, 0, 0, true},
             {"n_standard_error", error.n, 1, 1, true},
             {"mn_covariance", fit.unloading.covariance, 0, 1, false}});
      const ThreeParameterRow &free = fit.three_parameter;
      if (!says_converged(free.stop))
        return;
      check({free.m, free.n, free.approach_residual / unit},
            low,
            free.quality.rmse,
            3,
            {{"m_three_parameter_standard_error", free.m_standard_error, 0, 0, true},
             {"n_three_parameter_standard_error", free.n_standard_error, 1, 1, true},
             {"approach_residual_three_parameter_standard_error_m over delta_y",
              free.approach_residual_standard_error / unit,
              2,
              2,
              true},
             {"mn_three_parameter_covariance", free.mn_covariance, 0, 1, false},
             {"m_residual_three_parameter_covariance_m over delta_y",
              free.m_residual_covariance / unit,
              0,
              2,
              false},
             {"n_residual_three_parameter_covariance_m over delta_y",
              free.n_residual_covariance / unit,
              1,
              2,
              false}});
    }

    /// 1 − R² = SSE/SST and rmse² = SSE/(n F²): their ratio is n F²/SST for every form of a branch,
    /// and near that of the power law, whose variance over its range is 1/(2p + 1) − 1/(p + 1)².
    void check_quality(const std::vector<std::pair<std::string, FitQuality>> &forms,
                       const double                                           exponent,
                       const std::string                                     &where,
                       Findings                                              &findings)
    {
      // The curve is no power law: 1.3 % at most over the shipped rows.
      constexpr double of_shape = 0.1;
      // R² is 1 − a small number, of which rounding takes 1e-16.
      constexpr double  of_rounding = 1e-12;
      const double      ideal       = 1 / (1 / (2 * exponent + 1) - 1 / std::pow(exponent + 1, 2));
      const FitQuality &worst = forms[1].second; // the exponential, the farthest from the curve
      const double      ratio = (1 - worst.r2) / (worst.rmse * worst.rmse);
      if (!is_close(ratio, ideal, of_shape))
        findings.add(
          Grade::error, where, versus(forms[1].first + ": (1 - R2)/rmse^2", ratio, ideal));
      for (const auto &[name, quality] : forms)
        {
          const double share = ratio * quality.rmse * quality.rmse;
          if (!(quality.rmse >= 0 && quality.rmse <= 1) ||
              !(std::abs(1 - quality.r2 - share) <= closed_form * share + of_rounding))
            findings.add(Grade::error,
                         where,
                         name + ": R2 = " + number_text(quality.r2) +
                           " and rmse = " + number_text(quality.rmse) + " are not of one fit");
        }
    }

    void check_stops(const Record &row, const std::string &where, Findings &findings)
    {
      const FitRow &fit = row.fit;
      for (const auto &[name, stop] :
           {std::pair{"stop_loading", fit.loading.stop}, {"stop_unloading", fit.unloading.stop}})
        if (!says_converged(stop))
          findings.add(
            Grade::error, where, std::string(name) + " is '" + stop + "', but the row converged");
      const auto reasons = {StopReason::relative_offset,
                            StopReason::residual_zero,
                            StopReason::no_progress,
                            StopReason::iteration_limit,
                            StopReason::failed};
      if (std::none_of(reasons.begin(), reasons.end(), [&fit](const StopReason reason) {
            return fit.three_parameter.stop == describe(reason);
          }))
        findings.add(
          Grade::error, where, "stop_three_parameter is '" + fit.three_parameter.stop + "'");
      if (!row.reason.empty())
        findings.add(Grade::error, where, "it converged, but has a reason: " + row.reason);
    }

    void check_error_of_fit(const Record &row, const std::string &where, Findings &findings)
    {
      for (std::size_t c = 0; c < coefficient_names.size(); ++c)
        findings.require_close(std::string(coefficient_names[c]) + "_error_fit",
                               row.error[c].parts.fit,
                               row.fit.standard_error[c] +
                                 std::abs(row.law[c] * row.fit.window_change[c]),
                               where,
                               closed_form);
    }
  } // namespace

  void check_fit(const Record &row, const std::string &where, Findings &findings)
  {
    const FitRow &fit = row.fit;
    check_stops(row, where, findings);
    check_error_of_fit(row, where, findings);
    check_spread(row, where, findings);
    const auto forms = [](const BranchFitRow &branch, const std::string &name) {
      return std::vector<std::pair<std::string, FitQuality>>{
        {"the power law of " + name, branch.power_law},
        {"the exponential form of " + name, branch.exponential},
        {"the polynomial of " + name, branch.polynomial},
        {"the parabola of " + name, branch.parabola}};
    };
    check_quality(forms(fit.loading, "loading"), row.law.b, where, findings);
    auto unloading = forms(fit.unloading, "unloading");
    unloading.emplace_back("the three-parameter law", fit.three_parameter.quality);
    check_quality(unloading, row.law.n, where, findings);
    const double law = fit.three_parameter.m *
                       std::pow((row.state.approach_peak - fit.three_parameter.approach_residual) /
                                  row.yield.approach,
                                fit.three_parameter.n);
    if (!is_close(law, row.load_level, 0.05)) // as of the others: 0.002 over the shipped rows
      findings.add(
        Grade::error, where, versus("the three-parameter law at the peak", law, row.load_level));
  }
} // namespace dpcontact
