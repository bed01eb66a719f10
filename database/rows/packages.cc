#include "database/rows/packages.h"

#include "database/files/digest.h"
#include "database/files/files.h"
#include "database/rows/row_json.h"
#include "database/rows/schema.h"
#include "meshing/errors.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <type_traits>

namespace dpcontact
{
  namespace
  {
    using Json   = nlohmann::ordered_json;
    namespace fs = std::filesystem;

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

    Json json_of(const PackageField &field)
    {
      Json json = {{"name", field.name}, {"type", field.type}, {"description", field.description}};
      Json constraints;
      if (field.type == "string")
        {
          if (!field.choices.empty())
            constraints = {{"required", true}, {"enum", field.choices}};
        }
      else
        {
          json["unit"] = field.unit;
          if (std::isfinite(field.range.low))
            constraints["minimum"] = field.range.low;
          if (std::isfinite(field.range.high))
            constraints["maximum"] = field.range.high;
        }
      if (!constraints.is_null())
        json["constraints"] = constraints;
      return json;
    }

    Json package_json(const fs::path &csv, const PackageContent &content)
    {
      const Provenance &provenance = content.provenance;
      Json              fields     = Json::array();
      for (const PackageField &field : content.fields)
        fields.push_back(json_of(field));
      return {
        {"profile", "tabular-data-package"},
        {"name", "dpcontact-" + csv.stem().string()},
        {"title", content.title},
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
             {"primaryKey", content.key}}}}}}};
    }
  } // namespace

  void write_json(const fs::path &file, const Database &database)
  {
    Json document = {{"title", database_title},
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
          row[column.name] =
            std::visit([](const auto &value) { return json_value(value); }, column.get(record));
        document["rows"].push_back(std::move(row));
      }
    write_file(file, document.dump(1) + "\n");
  }

  PackageContent package_of(const Database &database)
  {
    PackageContent content{database_title, database.provenance, {}, {}};
    for (const auto &column : schema::columns())
      content.fields.push_back({column.name,
                                column.is_text()     ? "string"
                                : column.is_number() ? "number"
                                                     : "integer",
                                column.unit,
                                column.description,
                                column.range,
                                column.choices});
    for (const auto &column : schema::input_columns())
      content.key.push_back(column.name);
    return content;
  }

  void write_datapackage(const fs::path &file, const fs::path &csv, const PackageContent &content)
  {
    write_file(file, package_json(csv, content).dump(1) + "\n");
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
