#include "runs/result_files.h"

#include "database/files.h"
#include "database/schema.h"
#include "meshing/errors.h"
#include "solver/laws/point.h"

#include <cerrno>
#include <charconv>
#include <cstring>
#include <sstream>
#include <unistd.h>

namespace dpcontact
{
  namespace
  {
    /// The fewest digits that give the same number back.
    template <typename Number>
    std::string text(const Number value)
    {
      char       buffer[32];
      const auto result = std::to_chars(buffer, buffer + sizeof(buffer), value);
      return std::string(buffer, result.ptr);
    }

    template <typename Column>
    std::string heading(const Column &column)
    {
      const std::string unit = column.unit;
      return column.name + (unit == "1" ? "" : "_" + unit);
    }

    std::string curve_csv(const Curve &curve)
    {
      std::string csv = "branch";
      for (const auto &column : schema::curve_columns())
        csv += "," + heading(column);
      csv += '\n';
      const auto add_branch = [&](const char *name, const std::vector<CurvePoint> &points) {
        for (const CurvePoint &point : points)
          {
            csv += name;
            for (const auto &column : schema::curve_columns())
              csv += "," + std::visit([&](const auto member) { return text(point.*member); },
                                      column.member);
            csv += '\n';
          }
      };
      add_branch("loading", curve.loading);
      add_branch("unloading", curve.unloading);
      return csv;
    }

    std::string profile_csv(const std::vector<PressurePoint> &profile)
    {
      std::string csv;
      for (const auto &column : schema::profile_columns())
        csv += (csv.empty() ? "" : ",") + heading(column);
      csv += '\n';
      for (const PressurePoint &point : profile)
        {
          std::string line;
          for (const auto &column : schema::profile_columns())
            line += (line.empty() ? "" : ",") + text(point.*column.member);
          csv += line + '\n';
        }
      return csv;
    }

    std::string axis_csv(const std::vector<AxisPoint> &axis)
    {
      std::string csv = "depth_m,axial_stress_Pa,radial_stress_Pa\n";
      for (const AxisPoint &point : axis)
        csv += text(point.depth) + "," + text(point.axial_stress) + "," +
               text(point.radial_stress) + "\n";
      return csv;
    }

    std::string points_csv(const std::vector<PointState> &points)
    {
      std::string csv =
        "radius_m,depth_m,volume_m3,stress_rr_Pa,stress_zz_Pa,stress_tt_Pa,stress_rz_Pa,"
        "principal_1_Pa,principal_2_Pa,principal_3_Pa,mises_stress_Pa,plastic_strain,branch\n";
      for (const PointState &p : points)
        {
          for (const double value : {p.radius,
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
                                     p.plastic_strain})
            csv += text(value) + ",";
          csv += std::string(laws::to_string(p.branch)) + "\n";
        }
      return csv;
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
