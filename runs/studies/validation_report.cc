#include "runs/studies/validation_report.h"

#include "database/files/csv.h"
#include "database/files/files.h"
#include "database/rows/schema.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace dpcontact
{
  namespace
  {
    /// The errors of a path as a whole, by the names that JSON and CSV give them.
    constexpr std::pair<const char *, double LawErrors::*> numbers[] = {
      {"loading_rms", &LawErrors::loading_rms},
      {"loading_max", &LawErrors::loading_max},
      {"unloading_rms", &LawErrors::unloading_rms},
      {"unloading_max", &LawErrors::unloading_max},
      {"residual_approach", &LawErrors::residual},
      {"energy_loss", &LawErrors::energy_loss},
      {"restitution", &LawErrors::restitution},
      {"law_restitution", &LawErrors::law_restitution}};

    double restitution_error(const LawErrors &errors)
    {
      return std::abs(errors.law_restitution - errors.restitution);
    }

    /// Unset where no entry is of this path and law.
    std::optional<ValidationSummary> summary_of(const std::vector<ValidationEntry> &entries,
                                                const ValidationPath                path,
                                                const LawKind                       law)
    {
      std::vector<LawErrors> chosen;
      for (const ValidationEntry &entry : entries)
        if (entry.path == path && entry.law == law)
          chosen.push_back(entry.errors);
      if (chosen.empty())
        return std::nullopt;
      const auto sorted = [&](const auto &number) {
        std::vector<double> values;
        for (const LawErrors &errors : chosen)
          values.push_back(number(errors));
        std::sort(values.begin(), values.end());
        return values;
      };
      const auto loading   = sorted([](const LawErrors &e) { return e.loading_rms; });
      const auto unloading = sorted([](const LawErrors &e) { return e.unloading_rms; });
      const auto bounce    = sorted(restitution_error);
      const auto most      = [&](const auto &number) { return sorted(number).back(); };
      return ValidationSummary{
        path,
        law,
        chosen.size(),
        loading.back(),
        unloading.back(),
        most([](const LawErrors &e) { return std::max(e.loading_max, e.unloading_max); }),
        most([](const LawErrors &e) { return e.residual; }),
        most([](const LawErrors &e) { return std::abs(e.energy_loss); }),
        bounce.back(),
        loading[loading.size() / 2],
        unloading[unloading.size() / 2],
        bounce[bounce.size() / 2]};
    }
  } // namespace

  Json json_of(const LawErrors &errors)
  {
    Json document;
    for (const auto &[name, number] : numbers)
      document[name] = errors.*number;
    for (const auto &[end, mean, rms] : errors.legs)
      document["legs"].push_back({{"end_force", end}, {"mean", mean}, {"rms", rms}});
    return document;
  }

  LawErrors law_errors_of(const Json &document)
  {
    LawErrors errors;
    for (const auto &[name, number] : numbers)
      errors.*number = document.at(name).get<double>();
    for (const Json &leg : document.at("legs"))
      errors.legs.push_back({leg.at("end_force").get<double>(),
                             leg.at("mean").get<double>(),
                             leg.at("rms").get<double>()});
    return errors;
  }

  Json json_of(const ValidationEntry &entry)
  {
    return {{"path", to_string(entry.path)},
            {"law", to_string(entry.law)},
            {"material", material_json(entry.input)},
            {"scene", scene_json(entry.input)},
            {"load_level", entry.load_level},
            {"errors", json_of(entry.errors)}};
  }

  std::vector<ValidationSummary> summaries_of(const std::vector<ValidationEntry> &entries)
  {
    std::vector<ValidationSummary> result;
    for (const ValidationPath path : {ValidationPath::row, ValidationPath::history})
      for (const LawKind law : {LawKind::row, LawKind::universal})
        if (const auto summary = summary_of(entries, path, law))
          result.push_back(*summary);
    return result;
  }

  Json json_of(const ValidationSummary &summary)
  {
    return {{"path", to_string(summary.path)},
            {"law", to_string(summary.law)},
            {"count", summary.count},
            {"largest",
             {{"loading_rms", summary.loading_rms},
              {"unloading_rms", summary.unloading_rms},
              {"force_max", summary.force_max},
              {"residual_approach", summary.residual},
              {"energy_loss", summary.energy_loss},
              {"restitution", summary.restitution}}},
            {"median",
             {{"loading_rms", summary.median_loading_rms},
              {"unloading_rms", summary.median_unloading_rms},
              {"restitution", summary.median_restitution}}}};
  }

  void write_validation_csv(const std::filesystem::path        &file,
                            const std::vector<ValidationEntry> &entries)
  {
    CsvWriter csv;
    csv.comment("Contact law against finite elements at equal overlaps. Forces over the largest "
                "force,\n"
                "residual_approach over the largest approach, energy_loss (law - computed) over "
                "the\n"
                "work put in, restitution the root of work given back over work put in.");
    std::vector<std::string> names = {"path", "law"};
    for (const schema::Column &column : schema::input_columns())
      names.push_back(column.name);
    names.emplace_back("load_level");
    for (const auto &[name, number] : numbers)
      names.emplace_back(name);
    csv.header(names);
    for (const ValidationEntry &entry : entries)
      {
        csv.add(std::string(to_string(entry.path)));
        csv.add(std::string(to_string(entry.law)));
        for (const auto &[name, cell] : schema::input_cells(entry.input))
          std::visit([&csv](const auto &value) { csv.add(value); }, cell);
        csv.add(entry.load_level);
        for (const auto &[name, number] : numbers)
          csv.add(entry.errors.*number);
        csv.end_row();
      }
    write_file(file, csv.text());
  }
} // namespace dpcontact
