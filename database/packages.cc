#include "database/packages.h"

#include "database/digest.h"
#include "database/files.h"
#include "database/row_json.h"
#include "database/schema.h"
#include "meshing/errors.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <map>
#include <type_traits>

namespace dpcontact
{
  namespace
  {
    using Json   = nlohmann::ordered_json;
    namespace fs = std::filesystem;

    constexpr double infinity = std::numeric_limits<double>::infinity();

    const char *const paper_doi = "10.1155/2018/6783791";

    std::string found(const Provenance &provenance, const std::string &name)
    {
      const auto entry = provenance.find(name);
      return entry == provenance.end() ? "unknown" : entry->second;
    }

    template <typename T>
    Json json_value(const T &value)
    {
      if constexpr (std::is_same_v<T, std::string>)
        return clean_text(value);
      else if constexpr (std::is_floating_point_v<T>)
        return std::isfinite(value) ? Json(value) : Json();
      else
        return value;
    }

    Json field(const std::string &name,
               const std::string &type,
               const std::string &unit,
               const std::string &description)
    {
      Json json = {{"name", name}, {"type", type}, {"description", description}};
      if (type == "string")
        {
          if (name == "status")
            json["constraints"] = {{"required", true}, {"enum", {"converged", "failed"}}};
          else if (name == "criterion")
            json["constraints"] = {{"required", true},
                                   {"enum", {"drucker-prager", "von-mises", "mohr-coulomb"}}};
          return json;
        }
      json["unit"]            = unit;
      const ColumnRange range = range_of(name);
      Json              constraints;
      if (std::isfinite(range.low))
        constraints["minimum"] = range.low;
      if (std::isfinite(range.high))
        constraints["maximum"] = range.high;
      if (!constraints.is_null())
        json["constraints"] = constraints;
      return json;
    }

    Json package(const fs::path    &csv,
                 const std::string &title,
                 const Provenance  &provenance,
                 const Json        &fields,
                 const Json        &primary_key)
    {
      return {
        {"profile", "tabular-data-package"},
        {"name", "dpcontact-" + csv.stem().string()},
        {"title", title},
        {"version", found(provenance, "version_dpcontact")},
        {"revision", found(provenance, "version_git_revision")},
        {"licenses",
         {{{"name", "BSD-3-Clause"},
           {"title", "BSD 3-Clause licence"},
           {"path", "https://opensource.org/licenses/BSD-3-Clause"}}}},
        {"sources",
         {{{"title",
            "Wang, Li, Yang, Huang, Zhou: A Simple Model for Elastic-Plastic Contact of Granular "
            "Geomaterials (2018)"},
           {"path", std::string("https://doi.org/") + paper_doi}}}},
        {"resources",
         {{{"name", csv.stem().string()},
           {"path", csv.filename().string()},
           {"profile", "tabular-data-resource"},
           {"format", "csv"},
           {"mediatype", "text/csv"},
           {"encoding", "utf-8"},
           {"hash", "sha256:" + sha256_of_file(csv)},
           {"bytes", fs::file_size(csv)},
           {"dialect", {{"commentChar", "#"}, {"delimiter", ","}, {"header", true}}},
           {"schema",
            {{"fields", fields},
             {"missingValues", {"", "nan", "inf", "-inf"}},
             {"primaryKey", primary_key}}}}}}};
    }
  } // namespace

  ColumnRange range_of(const std::string &column)
  {
    static const std::map<std::string, ColumnRange> ranges = {
      {"nu", {0, 0.5}},
      {"phi_deg", {0, 90}},
      {"dilation_deg", {0, 90}},
      {"flow_stress_ratio", {0.778, 1}},
      {"hardening_Pa", {0, infinity}},
      {"tension_cutoff_Pa", {0, infinity}},
      {"ab_covariance", {-infinity, infinity}},
      {"mn_covariance", {-infinity, infinity}},
      {"mn_three_parameter_covariance", {-infinity, infinity}},
      {"m_residual_three_parameter_covariance_m", {-infinity, infinity}},
      {"n_residual_three_parameter_covariance_m", {-infinity, infinity}},
      {"approach_residual_eq18_m", {-infinity, infinity}},
      {"approach_residual_m", {-infinity, infinity}}, // nought to rounding, see checks.cc
      {"approach_residual_three_parameter_m", {-infinity, infinity}},
      {"a_window_change", {-infinity, infinity}},
      {"b_window_change", {-infinity, infinity}},
      {"m_window_change", {-infinity, infinity}},
      {"n_window_change", {-infinity, infinity}},
      {"b", {0.9, 1.6}},
      {"n", {0.9, 1.7}},
      {"n_law", {0.9, 1.7}},
      {"residual_approach", {0, infinity}},
    };
    const auto entry = ranges.find(column);
    if (entry != ranges.end())
      return entry->second;
    if (column.rfind("r2_", 0) == 0)
      return {-infinity, 1};
    for (const char *const positive : {"E_Pa",
                                       "sigma_c_Pa",
                                       "radius_m",
                                       "force_max_N",
                                       "force_yield_N",
                                       "approach_yield_m",
                                       "pressure_yield_Pa",
                                       "contact_radius_yield_m",
                                       "yield_strength_Pa",
                                       "load_level",
                                       "a",
                                       "m",
                                       "m_law",
                                       "a_published",
                                       "m_published",
                                       "approach_peak_m",
                                       "approach",
                                       "pressure_yield",
                                       "ring_load_level"})
      if (column == positive)
        return {0, infinity, true};
    return {0, infinity};
  }

  void write_json(const fs::path &file, const Database &database)
  {
    Json document = {{"title", "dpcontact: coefficients of elastic-plastic contact"},
                     {"schema_version", schema::version},
                     {"provenance", Json::object()},
                     {"columns", Json::array()},
                     {"rows", Json::array()}};
    for (const auto &[name, text] : database.provenance)
      document["provenance"][name] = clean_text(text);
    for (const auto &column : schema::columns())
      document["columns"].push_back(
        {{"name", column.name}, {"unit", column.unit}, {"description", column.description}});
    for (const Record &record : database.records)
      {
        Json row;
        for (const auto &column : schema::columns())
          row[column.name] = std::visit(
            [&](const auto member) { return json_value(record.*member); }, column.member);
        document["rows"].push_back(std::move(row));
      }
    write_file(file, document.dump(1) + "\n");
  }

  void write_datapackage(const fs::path &file, const fs::path &csv, const Database &database)
  {
    Json fields = Json::array();
    for (const auto &column : schema::columns())
      fields.push_back(field(column.name,
                             std::holds_alternative<std::string Record::*>(column.member) ? "string"
                             : std::holds_alternative<std::uint64_t Record::*>(column.member)
                               ? "integer"
                               : "number",
                             column.unit,
                             column.description));
    const Json key = {"criterion",
                      "E_Pa",
                      "nu",
                      "phi_deg",
                      "sigma_c_Pa",
                      "flow_stress_ratio",
                      "dilation_deg",
                      "hardening_Pa",
                      "tension_cutoff_Pa",
                      "radius_m",
                      "force_max_N"};
    write_file(
      file,
      package(
        csv, "dpcontact: coefficients of elastic-plastic contact", database.provenance, fields, key)
          .dump(1) +
        "\n");
  }

  void write_datapackage(const fs::path &file, const fs::path &csv, const UniversalTable &table)
  {
    Json fields = Json::array();
    for (const auto &column : universal_columns())
      fields.push_back(field(column.name, "number", column.unit, column.description));
    write_file(file,
               package(csv,
                       "dpcontact: universal table of elastic-plastic contact",
                       table.made_from(),
                       fields,
                       {"nu", "phi_deg", "load_level"})
                   .dump(1) +
                 "\n");
  }

  void write_datacite(const fs::path &file, const std::string &title, const Provenance &provenance)
  {
    const Json document = {
      {"schemaVersion", "http://datacite.org/schema/kernel-4"},
      {"titles", {{{"title", title}}}},
      {"creators", {{{"name", "The dpcontact authors"}, {"nameType", "Organizational"}}}},
      {"publisher", "dpcontact"},
      {"publicationYear", "2026"},
      {"types", {{"resourceTypeGeneral", "Dataset"}, {"resourceType", "Computed contact laws"}}},
      {"version", found(provenance, "version_dpcontact")},
      {"language", "en"},
      {"rightsList",
       {{{"rights", "BSD 3-Clause licence"},
         {"rightsIdentifier", "BSD-3-Clause"},
         {"rightsIdentifierScheme", "SPDX"},
         {"rightsUri", "https://opensource.org/licenses/BSD-3-Clause"}}}},
      {"relatedIdentifiers",
       {{{"relatedIdentifier", paper_doi},
         {"relatedIdentifierType", "DOI"},
         {"relationType", "IsDerivedFrom"}}}},
      {"descriptions",
       {{{"descriptionType", "TechnicalInfo"},
         {"description",
          "Computed by dpcontact, revision " + found(provenance, "version_git_revision")}}}}};
    write_file(file, document.dump(1) + "\n");
  }
} // namespace dpcontact
