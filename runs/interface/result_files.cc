#include "runs/interface/result_files.h"

#include "database/files/csv.h"
#include "database/files/files.h"
#include "database/rows/schema.h"
#include "meshing/errors.h"
#include "solver/laws/point.h"
#include "solver/path/solution.h"

#include <cerrno>
#include <cstring>
#include <sstream>
#include <unistd.h>

namespace dpcontact
{
  namespace
  {
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

  void make_result_directory(const std::filesystem::path &directory)
  {
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (!std::filesystem::is_directory(directory))
      throw FileError("cannot make the directory " + directory.string() + ": " +
                      (error ? error.message() : "its place is taken"));
    if (access(directory.c_str(), W_OK | X_OK) != 0)
      throw FileError("cannot write into " + directory.string() + ": " + std::strerror(errno));
  }

  void write_result_files(const std::filesystem::path &directory,
                          const Solution              &solution,
                          const Json                  &document)
  {
    write_file(directory / "curve.csv", curve_csv(solution.curve));
    write_file(directory / "profile.csv", profile_csv(solution.peak_profile));
    write_file(directory / "axis.csv", axis_csv(solution.peak_axis));
    write_file(directory / "points.csv", points_csv(solution.peak_points));
    std::ostringstream mesh;
    print(solution.mesh_quality, mesh);
    write_file(directory / "mesh.txt", mesh.str());
    write_file(directory / "result.json", document.dump(2) + '\n');
  }
} // namespace dpcontact
