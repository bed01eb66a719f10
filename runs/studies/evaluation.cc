#include "runs/studies/evaluation.h"

#include "database/files/files.h"
#include "database/files/json_text.h"
#include "database/files/regular_file.h"
#include "database/rows/checks.h"
#include "database/rows/row.h"
#include "database/tables/estimators.h"
#include "database/tables/universal_checks.h"
#include "fitting/conventions.h"
#include "meshing/errors.h"
#include "solver/parallel/environment.h"
#include "solver/path/solution.h"
#include "solver/path/solve.h"

#include <chrono>
#include <cmath>
#include <sstream>

namespace dpcontact
{
  namespace
  {
    using Values = std::array<double, 4>;

    Values values_of(const Coefficients &c) { return {c.a, c.b, c.m, c.n}; }

    Json by_name(const Values &values) { return dpcontact::by_name(Coefficients::from(values)); }

    Json regression_json(const Regression &regression)
    {
      Json json;
      for (std::size_t c = 0; c < 4; ++c)
        {
          const auto &of = regression.of[c];
          for (std::size_t i = 0; i < regression_terms.size(); ++i)
            json[coefficient_names[c]]["terms"][regression_terms[i]] = {
              {"coefficient", of.value[i]}, {"standard_error", of.standard_error[i]}};
          json[coefficient_names[c]]["r2"] = of.r_squared;
        }
      return json;
    }

    Case paper_case(const double E, const double nu, const double phi, const double sigma_c)
    {
      Case input{};
      input.material.youngs_modulus       = E;
      input.material.poisson_ratio        = nu;
      input.material.friction_angle       = Angle(phi);
      input.material.compressive_strength = sigma_c;
      return input;
    }

    /// |estimate/value − 1| of each coefficient.
    Values relative(const Values &estimate, const Values &value)
    {
      Values result{};
      for (std::size_t c = 0; c < 4; ++c)
        result[c] = std::abs(estimate[c] / value[c] - 1);
      return result;
    }

    /// Root mean square and largest of many errors.
    class Errors
    {
    public:
      void add(const Values &values)
      {
        for (std::size_t c = 0; c < 4; ++c)
          {
            square[c] += values[c] * values[c];
            largest[c] = std::max(largest[c], values[c]);
          }
        ++count;
      }
      Json json() const
      {
        Values mean{};
        for (std::size_t c = 0; c < 4; ++c)
          mean[c] = std::sqrt(square[c] / static_cast<double>(count));
        return {{"rows", count}, {"rms", by_name(mean)}, {"largest", by_name(largest)}};
      }

    private:
      Values      square{}, largest{};
      std::size_t count = 0;
    };

    double seconds_since(const std::chrono::steady_clock::time_point start)
    {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    Json table_4(const std::vector<LookupTable> &tables, const std::vector<LookupMethod> &methods)
    {
      struct Type
      {
        const char *name;
        Case        input;
        Values      interpolation, regression; ///< the paper's, per cent
      };
      const Type types[] = {
        {"type-1", paper_case(10e9, .15, 25, 15e6), {1.92, .5, 9.31, .75}, {4.05, .66, 34.3, 1.47}},
        {"type-2", paper_case(10e9, .25, 35, 25e6), {.09, .1, 1.2, .16}, {3.84, .49, 56.37, .9}}};
      const Environment environment;
      Json              result;
      for (const Type &type : types)
        {
          const Record row = row_of(
            type.input, solve_contact(type.input.material, type.input.scene, SolverOptions{}));
          const Values computed{row.fit.published.a, row.law.b, row.fit.published.m, row.law.n};
          Json        &here       = result[type.name];
          here["finite_elements"] = by_name(computed);
          const auto percent      = [](Values values) {
            for (double &value : values)
              value /= 100;
            return by_name(values);
          };
          here["paper_interpolation"] = percent(type.interpolation);
          here["paper_regression"]    = percent(type.regression);
          for (std::size_t k = 0; k < methods.size(); ++k)
            here[to_string(methods[k])] = by_name(relative(
              values_of(tables[k].at(type.input, Outside::refuse, Laws::any).published), computed));
        }
      return result;
    }

    /// Every row predicted from the others. Natural neighbours do not reach what was a corner.
    Json leave_one_out(const MaterialTable &table)
    {
      Json       result;
      const auto run = [&](const char *name, const auto &make) {
        Errors      errors;
        std::size_t unreachable = 0;
        for (std::size_t i = 0; i < table.rows.size(); ++i)
          try
            {
              const auto estimate = make(table.without(i))->at(table.rows[i].point);
              errors.add(relative(estimate.value, table.rows[i].published));
            }
          catch (const InputError &)
            {
              ++unreachable;
            }
        result[name]                = errors.json();
        result[name]["unreachable"] = unreachable;
      };
      const auto covariance = fit_covariance(table);
      run("kriging", [&](const MaterialTable &t) { return make_kriging(t, covariance); });
      run("natural-neighbour", [](const MaterialTable &t) { return make_natural_neighbour(t); });
      run("regression", [](const MaterialTable &t) { return make_regression(regress(t)); });
      return result;
    }

    /// The errors of every method over the paper's material space.
    Json held_out_of_paper(const std::vector<LookupTable>  &tables,
                           const std::vector<LookupMethod> &methods,
                           const Json                      &held_out)
    {
      Json result;
      try
        {
          for (std::size_t k = 0; k < methods.size(); ++k)
            {
              Errors errors;
              for (const Json &row : held_out.at("paper"))
                {
                  const Json        &material = row.at("material");
                  const double       b = row.at("b"), n = row.at("n");
                  const Values       computed{published_coefficient(row.at("a"), b),
                                        b,
                                        published_coefficient(row.at("m"), n),
                                        n};
                  const LookupResult found = tables[k].at(paper_case(material.at("E"),
                                                                     material.at("nu"),
                                                                     material.at("phi"),
                                                                     material.at("sigma-c")),
                                                          Outside::refuse,
                                                          Laws::any);
                  errors.add(relative(values_of(found.published), computed));
                }
              result[to_string(methods[k])] = errors.json();
            }
        }
      catch (const Json::exception &error)
        {
          throw CorruptData(
            std::string("the held-out curves are not as runs/studies/held_out writes them: ") +
            error.what());
        }
      return result;
    }
  } // namespace

  Json read_held_out(const std::filesystem::path &file)
  {
    constexpr std::uintmax_t largest = std::uintmax_t(1) << 28;
    require_regular_file(file, largest);
    return parse_json<Json>(read_file(file), file.string());
  }

  Json evaluate(const Evaluation &evaluation, const std::function<void(const std::string &)> &log)
  {
    const std::vector<LookupMethod> methods{LookupMethod::similarity,
                                            LookupMethod::kriging,
                                            LookupMethod::natural_neighbour,
                                            LookupMethod::regression,
                                            LookupMethod::table_2};
    const MaterialTable  rows = MaterialTable::from_rows(read_checked_database(evaluation.rows));
    const UniversalTable universal = read_checked_universal(evaluation.universal);
    const Json           held_out  = read_held_out(evaluation.held_out);

    Json document;
    log("regression");
    document["regression"] = {{"regressed", regression_json(regress(rows))},
                              {"table_2", regression_json(table_2())}};

    std::vector<LookupTable> tables;
    const Case               type_1 = paper_case(10e9, .15, 25, 15e6);
    for (const LookupMethod method : methods)
      {
        log(std::string("setting up ") + to_string(method));
        auto start = std::chrono::steady_clock::now();
        tables.emplace_back(method,
                            method == LookupMethod::similarity ? evaluation.universal
                                                               : evaluation.rows,
                            make_estimator);
        const double  set_up = seconds_since(start);
        constexpr int calls  = 20;
        start                = std::chrono::steady_clock::now();
        for (int i = 0; i < calls; ++i)
          tables.back().at(type_1);
        document["seconds"][to_string(method)] = {{"set_up", set_up},
                                                  {"lookup", seconds_since(start) / calls}};
      }

    log("table 4");
    document["table_4"] = table_4(tables, methods);

    log("leave one out");
    document["leave_one_out"] = leave_one_out(rows);
    {
      // which holds none of these rows
      Errors errors;
      for (const auto &row : rows.rows)
        {
          const MaterialPoint &p = row.point;
          const LookupResult   found =
            tables[0].at(paper_case(p.E_Pa, p.nu, p.phi_deg, p.sigma_c_Pa));
          errors.add(relative(values_of(found.published), row.published));
        }
      document["leave_one_out"]["similarity"] = errors.json();
    }

    log("held-out materials");
    document["held_out"]   = held_out_of_paper(tables, methods, held_out);
    document["similarity"] = compare_held_out(universal, held_out);
    return document;
  }

  namespace
  {
    std::string percent(const Json &value)
    {
      std::ostringstream text;
      text.precision(3);
      text << 100 * value.get<double>() << " %";
      return text.str();
    }

    std::string percents(const Json &values)
    {
      std::string text;
      for (const char *const name : coefficient_names)
        text += (text.empty() ? "" : ", ") + std::string(name) + " " + percent(values[name]);
      return text;
    }
  } // namespace

  std::string describe_evaluation(const Json &document)
  {
    std::ostringstream text;
    text.precision(5);
    text << "Eq (19) regressed over the rows, and table 2 as printed (published convention)\n";
    for (const char *const name : coefficient_names)
      {
        const Json &ours   = document["regression"]["regressed"][name];
        const Json &theirs = document["regression"]["table_2"][name];
        text << "  " << name << ": R2 " << ours["r2"].get<double>() << " (paper "
             << theirs["r2"].get<double>() << ")\n";
        for (const auto &[term, entry] : ours["terms"].items())
          text << "    " << term << ' ' << entry["coefficient"].get<double>() << " +- "
               << entry["standard_error"].get<double>() << " (paper "
               << theirs["terms"][term]["coefficient"].get<double>() << ")\n";
      }
    text << "Table 4: error against finite elements\n";
    for (const auto &[type, entries] : document["table_4"].items())
      for (const auto &[method, values] : entries.items())
        if (method != "finite_elements")
          text << "  " << type << ' ' << method << ": " << percents(values) << '\n';
    for (const char *const part : {"leave_one_out", "held_out"})
      {
        text << (part[0] == 'l' ? "Leave one out" : "Held-out materials in the paper's box")
             << ": root mean square error\n";
        for (const auto &[method, errors] : document[part].items())
          text << "  " << method << " (" << errors["rows"].get<std::size_t>()
               << " rows): " << percents(errors["rms"]) << "; largest "
               << percents(errors["largest"]) << '\n';
      }
    text << "Seconds\n";
    for (const auto &[method, seconds] : document["seconds"].items())
      text << "  " << method << ": set up " << seconds["set_up"].get<double>() << ", lookup "
           << seconds["lookup"].get<double>() << '\n';
    const Json &held = document["similarity"]["summary"];
    text << "Universal table on " << held["materials"].get<std::size_t>()
         << " held-out materials over its box\n";
    for (const char *const branch : {"loading", "unloading"})
      text << "  force, " << branch << ": rms " << percent(held[branch]["rms"]) << ", median "
           << percent(held[branch]["median"]) << ", largest " << percent(held[branch]["largest"])
           << " of the peak\n";
    for (const char *const name : {"a", "b", "m", "n", "residual_approach"})
      {
        const Json &entry = held[name];
        text << "  " << name << ": median error " << percent(entry["median"])
             << ", nine tenths below " << percent(entry["nine_tenths"])
             << ", stated uncertainty covers " << percent(entry["covered"]) << ", median ratio "
             << entry["median_ratio"].get<double>();
        if (entry.contains("misfit_median"))
          text << "; power law's own misfit " << percent(entry["misfit_median"]);
        text << '\n';
      }
    return text.str();
  }
} // namespace dpcontact
