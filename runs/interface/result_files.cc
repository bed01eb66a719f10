#include "runs/interface/result_files.h"

#include "database/files/csv.h"
#include "database/files/files.h"
#include "database/files/json_text.h"
#include "database/files/regular_file.h"
#include "database/rows/schema.h"
#include "meshing/errors.h"
#include "solver/laws/point.h"
#include "solver/path/solution.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <regex>
#include <sstream>
#include <system_error>
#include <unistd.h>

namespace dpcontact
{
  namespace
  {
    // The names of what a solve writes, and of the temporary files beside them.
    const std::string result_name =
      "result\\.json|(curve|profile|axis|points)\\.csv|mesh\\.txt|"
      "(peak|released)(-2)?(\\.[0-9]+)?\\.vtu|(peak|released)(-2)?\\.pvtu";
    const std::string temporary_name = "\\.(" + result_name + ")\\..*tmp";

    /// What a directory lists under names that match, sorted. Directories are not among it.
    std::vector<std::filesystem::path> entries_like(const std::regex            &name,
                                                    const std::filesystem::path &directory)
    {
      std::vector<std::filesystem::path> found;
      std::error_code                    error;
      for (const auto &entry : std::filesystem::directory_iterator(directory, error))
        if (std::regex_match(entry.path().filename().string(), name) &&
            !std::filesystem::is_directory(entry.symlink_status()))
          found.push_back(entry.path());
      if (error)
        throw FileError("cannot list " + directory.string() + ": " + error.message());
      std::sort(found.begin(), found.end());
      return found;
    }

    bool holds_converged_result(const std::filesystem::path &directory)
    {
      std::error_code ignored;
      const auto      file = directory / "result.json";
      if (!std::filesystem::exists(file, ignored))
        return false;
      require_regular_file(file);
      const Json document = parse_json<Json>(read_file(file), file.string());
      return !document.is_object() || document.value("status", Json()) != "failed";
    }

    template <typename Column>
    std::string heading(const Column &column)
    {
      const std::string unit = column.unit;
      return column.name + (unit == "1" ? "" : "_" + unit);
    }

    std::string curve_csv(const Curve &curve)
    {
      std::vector<std::string> names{"branch"};
      for (const auto &column : curve_quantities())
        names.push_back(heading(column));
      CsvWriter csv;
      csv.header(names);
      const auto add_branch = [&](const char *name, const std::vector<CurvePoint> &points) {
        for (const CurvePoint &point : points)
          {
            csv.add(name);
            for (const auto &column : curve_quantities())
              std::visit([&](const auto member) { csv.add(point.*member); }, column.member);
            csv.end_row();
          }
      };
      add_branch("loading", curve.loading);
      add_branch("unloading", curve.unloading);
      return csv.text();
    }

    std::string profile_csv(const std::vector<PressurePoint> &profile)
    {
      std::vector<std::string> names;
      for (const auto &column : schema::profile_columns())
        names.push_back(heading(column));
      CsvWriter csv;
      csv.header(names);
      for (const PressurePoint &point : profile)
        {
          for (const auto &column : schema::profile_columns())
            csv.add(point.*column.member);
          csv.end_row();
        }
      return csv.text();
    }

    std::string axis_csv(const std::vector<AxisPoint> &axis)
    {
      CsvWriter csv;
      csv.header({"depth_m", "axial_stress_Pa", "radial_stress_Pa"});
      for (const AxisPoint &point : axis)
        csv.row(point.depth, point.axial_stress, point.radial_stress);
      return csv.text();
    }

    std::string points_csv(const std::vector<PointState> &points)
    {
      CsvWriter csv;
      csv.header({"radius_m",
                  "depth_m",
                  "volume_m3",
                  "stress_rr_Pa",
                  "stress_zz_Pa",
                  "stress_tt_Pa",
                  "stress_rz_Pa",
                  "principal_1_Pa",
                  "principal_2_Pa",
                  "principal_3_Pa",
                  "mises_stress_Pa",
                  "plastic_strain",
                  "branch"});
      for (const PointState &p : points)
        csv.row(p.radius,
                p.depth,
                p.volume,
                p.radial_stress,
                p.axial_stress,
                p.hoop_stress,
                p.shear_stress,
                p.principal_stress[0],
                p.principal_stress[1],
                p.principal_stress[2],
                p.mises_stress,
                p.plastic_strain,
                to_string(p.branch));
      return csv.text();
    }
  } // namespace

  std::vector<std::filesystem::path> result_files_of(const std::filesystem::path &directory)
  {
    std::vector<std::filesystem::path> files;
    for (const char *const name : {"axis.csv",
                                   "curve.csv",
                                   "mesh.txt",
                                   "peak.vtu",
                                   "points.csv",
                                   "profile.csv",
                                   "released.vtu",
                                   "result.json"})
      files.push_back(directory / name);
    return files;
  }

  std::vector<std::filesystem::path> result_files_in(const std::filesystem::path &directory)
  {
    return entries_like(std::regex(result_name), directory);
  }

  void make_result_directory(const std::filesystem::path &directory)
  {
    std::error_code error, ignored;
    std::filesystem::create_directories(directory, error);
    if (!std::filesystem::is_directory(directory, ignored))
      throw FileError("cannot make the directory " + directory.string() + ": " +
                      (error ? error.message() : "its place is taken"));
    if (access(directory.c_str(), W_OK | X_OK) != 0)
      throw FileError("cannot write into " + directory.string() + ": " + std::strerror(errno));
  }

  void see_to_old_results(const std::filesystem::path &directory, const OldResults old)
  {
    if (old == OldResults::remove)
      {
        std::error_code error;
        for (const auto &file :
             entries_like(std::regex(result_name + "|" + temporary_name), directory))
          if (!std::filesystem::remove(file, error) && error)
            throw FileError("cannot remove " + file.string() + ": " + error.message());
        return;
      }
    const auto found = result_files_in(directory);
    if (old == OldResults::keep ? holds_converged_result(directory) : !found.empty())
      throw FileError(directory.string() + " holds results already (" +
                      found.front().filename().string() +
                      "): name another directory, or have them removed with --overwrite");
  }

  FieldSink fields_into(const std::filesystem::path &directory)
  {
    return [directory](const std::string &name, const std::string &content) {
      write_file(directory / name, content);
    };
  }

  void write_result_files(const std::filesystem::path &directory,
                          const Solution              &solution,
                          Json                        &document)
  {
    write_file(directory / "curve.csv", curve_csv(solution.curve));
    write_file(directory / "profile.csv", profile_csv(solution.peak_profile));
    write_file(directory / "axis.csv", axis_csv(solution.peak_axis));
    write_file(directory / "points.csv", points_csv(solution.peak_points));
    std::ostringstream mesh;
    print(solution.mesh_quality, mesh);
    write_file(directory / "mesh.txt", mesh.str());
    const std::filesystem::path result = directory / "result.json";
    document["files"]                  = Json::array();
    for (const auto &file : result_files_in(directory))
      if (file != result)
        document["files"].push_back(file.string());
    document["files"].push_back(result.string());
    write_file(result, document.dump(2) + '\n');
  }

  void write_failed_result(const std::filesystem::path &directory,
                           const Json                  &inputs,
                           const std::string           &reason)
  {
    Json document = inputs;
    document.update(Json{{"status", "failed"}, {"reason", reason}});
    try
      {
        write_file(directory / "result.json",
                   document.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
      }
    catch (const FileError &) // as documented: the caller reports why the solve failed
      {}
  }
} // namespace dpcontact
