#include "database/contact_law/contact_law.h"
#include "meshing/errors.h"
#include "runs/studies/evaluation.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace dpcontact
{
  namespace
  {
    using Points = std::vector<std::pair<double, double>>; ///< δ/δ_y, F/F_y

    Points points_of(const Json &branch)
    {
      Points points;
      for (const Json &point : branch)
        points.emplace_back(point.at(0).get<double>(), point.at(1).get<double>());
      if (points.size() < 2)
        throw CorruptData("a held-out curve has a branch of " + std::to_string(points.size()) +
                          " points: runs/studies/held_out writes at least two");
      return points;
    }

    /// The load level at which the master curve has an approach.
    double level_at(const UniversalFamily &family, const double approach)
    {
      double low = -60, high = std::log(2 * family.highest());
      for (int i = 0; i < 60; ++i)
        {
          const double middle = (low + high) / 2;
          (family.approach(std::exp(middle), Outside::extrapolate) < approach ? low : high) =
            middle;
        }
      return std::exp((low + high) / 2);
    }

    /// Root mean square of (law − F) over the approach, by the trapezoidal rule, over the peak
    /// force.
    double
    mean_error(const Points &points, const std::function<double(double)> &law, const double peak)
    {
      double sum = 0, length = 0;
      for (std::size_t i = 1; i < points.size(); ++i)
        {
          const auto &[x0, f0] = points[i - 1];
          const auto &[x1, f1] = points[i];
          const double e0 = law(x0) - f0, e1 = law(x1) - f1, h = std::abs(x1 - x0);
          sum += h * (e0 * e0 + e1 * e1) / 2;
          length += h;
        }
      return std::sqrt(sum / length) / peak;
    }

    double quantile(std::vector<double> values, const double share)
    {
      if (values.empty())
        return std::numeric_limits<double>::quiet_NaN();
      std::sort(values.begin(), values.end());
      return values[static_cast<std::size_t>(std::min(share * static_cast<double>(values.size()),
                                                      static_cast<double>(values.size() - 1)))];
    }

    /// @param goal what the errors are meant to be within; `within` is the share that is.
    Json summary(const std::vector<double> &values, const double goal)
    {
      double square = 0, within = 0;
      for (const double value : values)
        {
          square += value * value;
          within += value <= goal;
        }
      const auto count = static_cast<double>(values.size());
      return {{"rms", std::sqrt(square / count)},
              {"median", quantile(values, .5)},
              {"nine_tenths", quantile(values, .9)},
              {"largest", quantile(values, 1)},
              {"goal", goal},
              {"within", within / count}};
    }

    Json compare_one(const UniversalTable &table, const ContactTable &of_law, const Json &row)
    {
      const Json           &material = row.at("material");
      const double          level    = material.at("load-level");
      const UniversalFamily family(table, material.at("nu"), material.at("phi"));
      const UniversalValue  value   = family.at(level);
      const Points          loading = points_of(row.at("loading")),
                   unloading        = points_of(row.at("unloading"));

      // The law does not know the peak force: it follows the overlap, and unloads from where it is.
      const ContactPair law =
        ContactLaw::universal({1., material.at("nu"), material.at("phi"), 1e-3}, of_law).pair(1.);
      ContactState state;
      const auto   follow = [&](const double x) {
        return law.evaluate(x * law.approach_yield(), state).force / law.force_yield();
      };
      follow(loading.back().first);
      Json result        = {{"nu", material.at("nu")},
                            {"phi_deg", material.at("phi")},
                            {"load_level", level},
                            {"yields", level > family.onset()},
                            {"loading",
                             mean_error(
                        loading, [&](const double x) { return level_at(family, x); }, level)},
                            {"unloading", mean_error(unloading, follow, level)},
                            {"misfit", row.at("rmse")},
                            {"resolution", row.at("resolution")},
                            {"step_error", row.at("step_error")}};
      result["approach"] = {{"error", value.approach / loading.back().first - 1},
                            {"stated", value.approach_error}};
      for (const Outcome &part : value.parts)
        result["parts"].push_back(part);
      const double found          = row.at("residual_approach");
      const double by_law         = law.coefficients(state.peak_overlap).residual;
      result["law_residual"]      = (by_law / law.approach_yield() - found) / loading.back().first;
      result["residual_approach"] = {
        {"error", (value.residual_approach - found) / loading.back().first},
        {"stated", value.residual_error / loading.back().first}};
      for (std::size_t c = 0; c < 4; ++c)
        {
          const double computed        = row.at(coefficient_names[c]);
          result[coefficient_names[c]] = {
            {"computed", computed},
            {"error", value.coefficients[c] / computed - 1},
            {"stated", (value.numerical[c] + value.interpolation[c]) / std::abs(computed)},
            {"misfit",
             row.at("error").at(coefficient_names[c]).at("fit").get<double>() /
               std::abs(computed)}};
        }
      return result;
    }
  } // namespace

  Json compare_held_out(const UniversalTable &table, const Json &held_out)
  {
    try
      {
        Json                rows = Json::array(), total;
        std::vector<double> loading, unloading, residuals;
        std::size_t         failed = 0;
        std::stringstream   text;
        table.write(text);
        const ContactTable of_law = ContactTable::read(text);
        for (const Json &row : held_out.at("box"))
          if (row.contains("failed"))
            ++failed;
          else
            {
              rows.push_back(compare_one(table, of_law, row));
              loading.push_back(rows.back()["loading"]);
              unloading.push_back(rows.back()["unloading"]);
              residuals.push_back(std::abs(rows.back()["law_residual"].get<double>()));
            }
        total["materials"]    = rows.size();
        total["failed"]       = failed;
        total["loading"]      = summary(loading, .003);
        total["unloading"]    = summary(unloading, .005);
        total["law_residual"] = summary(residuals, .005);
        for (const char *const name : {"a", "b", "m", "n", "approach", "residual_approach"})
          {
            std::vector<double> errors, ratios, misfits;
            double              covered = 0;
            for (const Json &row : rows)
              {
                const double error  = std::abs(row[name]["error"].get<double>());
                const double stated = row[name]["stated"];
                errors.push_back(error);
                if (row["yields"]) // otherwise the lookup is Hertz's closed form, the error the
                                   // curve's
                  {
                    ratios.push_back(stated / error);
                    covered += error <= stated;
                  }
                if (row[name].contains("misfit"))
                  misfits.push_back(row[name]["misfit"]);
              }
            total[name]                 = summary(errors, .003);
            total[name]["compared"]     = ratios.size();
            total[name]["covered"]      = covered / static_cast<double>(ratios.size());
            total[name]["median_ratio"] = quantile(ratios, .5);
            if (!misfits.empty())
              total[name]["misfit_median"] = quantile(misfits, .5);
          }
        return {{"summary", total}, {"rows", rows}};
      }
    catch (const Json::exception &error)
      {
        throw CorruptData(
          std::string("the held-out curves are not as runs/studies/held_out writes them: ") +
          error.what());
      }
    catch (const Error &)
      {
        throw;
      }
    catch (const std::runtime_error &error) // of ContactTable and ContactLaw
      {
        throw CorruptData(std::string("the universal table makes no contact law: ") + error.what());
      }
  }
} // namespace dpcontact
