#include "database/rows/column_builder.h"

namespace dpcontact::schema
{
  namespace
  {
    /// A column for each of a, b, m, n; `place(row)` has them by number.
    template <class Place>
    Columns by_coefficient(const std::string                             &suffix,
                           const std::function<std::string(std::size_t)> &description,
                           const Place                                   &place,
                           const Range                                   &range = not_negative)
    {
      Columns list;
      for (std::size_t c = 0; c < coefficient_names.size(); ++c)
        list.push_back(column(
          coefficient_names[c] + suffix,
          "1",
          description(c),
          [ place, c ](auto &row) -> auto & { return place(row)[c]; }, range));
      return list;
    }

    /// A column for each branch; `place(fit)` is what the column holds of one.
    template <class Place>
    Columns by_branch(const std::string &prefix,
                      const std::string &unit,
                      const std::string &description,
                      const Place       &place,
                      const Range       &range   = not_negative,
                      const Absence      absence = Absence::noted)
    {
      return {column(
                prefix + "loading",
                unit,
                description + "loading",
                [place](auto &row) -> auto & { return place(row.fit.loading); },
                range,
                absence),
              column(
                prefix + "unloading",
                unit,
                description + "unloading",
                [place](auto &row) -> auto & { return place(row.fit.unloading); },
                range,
                absence)};
    }

    Columns power_law_columns()
    {
      const auto name_of = [](const std::size_t c) { return std::string(coefficient_names[c]); };
      Columns    list    = by_coefficient(
        "_standard_error",
        [&](const std::size_t c) {
          return "standard error of " + name_of(c) + ": misfit of the form";
        },
        [](auto &row) -> auto       &{ return row.fit.standard_error; });
      list.push_back(column(
        "ab_covariance",
        "1",
        "covariance of a and b",
        [](auto &r) -> auto & { return r.fit.loading.covariance; },
        any));
      list.push_back(column(
        "mn_covariance",
        "1",
        "covariance of m and n",
        [](auto &r) -> auto & { return r.fit.unloading.covariance; },
        any));
      append(list,
             by_branch(
               "r2_",
               "1",
               "1 - SSE/SST of ",
               [](auto &branch) -> auto & { return branch.power_law.r2; },
               at_most_one,
               Absence::allowed));
      Columns rmse = by_branch(
        "rmse_", "1", "root mean square misfit of ", [](auto &branch) -> auto & {
          return branch.power_law.rmse;
        });
      for (Column &entry : rmse)
        entry.description += " over the peak force";
      append(list, rmse);
      append(list,
             by_coefficient(
               "_window_change",
               [&](const std::size_t c) {
                 return "relative change of " + name_of(c) + " when fitted over [0.1, 1] of the " +
                        (c < 2 ? "approach" : "recovered approach");
               },
               [](auto &row) -> auto & { return row.fit.window_change; },
               any));
      append(list,
             by_branch(
               "stop_", "", "why the fit of ", [](auto &branch) -> auto & { return branch.stop; }));
      for (std::size_t i = list.size() - 2; i < list.size(); ++i)
        list[i].description += " stopped";
      return list;
    }

    Columns three_parameter_columns()
    {
      const auto of = [](const auto &place) {
        return [place](auto &row) -> auto & { return place(row.fit.three_parameter); };
      };
      return {
        column("m_three_parameter", "1", "m where delta_res is fitted too", of([
               ](auto &f) -> auto & { return f.m; })),
        column("n_three_parameter", "1", "n where delta_res is fitted too", of([
               ](auto &f) -> auto & { return f.n; })),
        column("approach_residual_three_parameter_m",
               "m",
               "fitted delta_res",
               of([](auto &f) -> auto & { return f.approach_residual; }),
               any),
        column("m_three_parameter_standard_error", "1", "its standard error", of([
               ](auto &f) -> auto & { return f.m_standard_error; })),
        column("n_three_parameter_standard_error", "1", "its standard error", of([
               ](auto &f) -> auto & { return f.n_standard_error; })),
        column("approach_residual_three_parameter_standard_error_m", "m", "its standard error", of([
               ](auto &f) -> auto & { return f.approach_residual_standard_error; })),
        column("mn_three_parameter_covariance",
               "1",
               "covariance of m and n, delta_res fitted too",
               of([](auto &f) -> auto & { return f.mn_covariance; }),
               any),
        column("m_residual_three_parameter_covariance_m",
               "m",
               "covariance of m and delta_res",
               of([](auto &f) -> auto & { return f.m_residual_covariance; }),
               any),
        column("n_residual_three_parameter_covariance_m",
               "m",
               "covariance of n and delta_res",
               of([](auto &f) -> auto & { return f.n_residual_covariance; }),
               any),
        column("r2_three_parameter",
               "1",
               "1 - SSE/SST, delta_res fitted too",
               of([](auto &f) -> auto & { return f.quality.r2; }),
               at_most_one,
               Absence::allowed),
        column("rmse_three_parameter",
               "1",
               "root mean square misfit over the peak force, likewise",
               of([](auto &f) -> auto & { return f.quality.rmse; })),
        column("stop_three_parameter", "", "why this fit stopped", of([](auto &f) -> auto & {
                 return f.stop;
               })),
      };
    }

    /// R² and RMSE of a rival form; `place(fit)` is its quality in one branch.
    template <class Place>
    void append_form(Columns           &list,
                     const std::string &name,
                     const std::string &form,
                     const bool         loading,
                     const Place       &place)
    {
      const auto of = [ place, loading ](auto &row) -> auto &
      {
        return place(loading ? row.fit.loading : row.fit.unloading);
      };
      const std::string branch = loading ? "loading" : "unloading";
      list.push_back(column(
        "r2_" + name + "_" + branch,
        "1",
        "1 - SSE/SST of " + form + ", " + branch,
        [of](auto &row) -> auto & { return of(row).r2; },
        at_most_one,
        Absence::allowed));
      list.push_back(column(
        "rmse_" + name + "_" + branch,
        "1",
        "its root mean square misfit over the peak force",
        [of](auto &row) -> auto & { return of(row).rmse; }));
    }

    Columns rival_form_columns()
    {
      Columns list;
      for (const bool loading : {true, false})
        {
          append_form(
            list, "exponential", "c0 exp(c1 x)", loading, [](auto &branch) -> auto & {
              return branch.exponential;
            });
          append_form(
            list, "polynomial", "the cubic polynomial", loading, [](auto &branch) -> auto & {
              return branch.polynomial;
            });
          append_form(
            list, "parabola", "c0 x^2", loading, [](auto &branch) -> auto & {
              return branch.parabola;
            });
        }
      return list;
    }
  } // namespace

  Columns fit_columns()
  {
    Columns list = power_law_columns();
    append(list, three_parameter_columns());
    append(list, rival_form_columns());
    return list;
  }
} // namespace dpcontact::schema
