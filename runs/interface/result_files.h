#ifndef DPCONTACT_RUNS_INTERFACE_RESULT_FILES_H
#define DPCONTACT_RUNS_INTERFACE_RESULT_FILES_H

#include "runs/interface/documents.h"
#include "solver/path/solution.h"

#include <filesystem>

namespace dpcontact
{
  /// Makes the directory, with its parents, unless it is there. @throws FileError.
  void make_result_directory(const std::filesystem::path &directory);

  /// Writes what a solve has found into a directory, in SI units that the headers name, stresses
  /// tension positive:
  /// - result.json, the document as it is printed;
  /// - curve.csv, both branches of the force–displacement curve;
  /// - profile.csv, the contact pressure at the peak;
  /// - axis.csv, the stresses on the axis at the peak;
  /// - points.csv, every quadrature point at the peak: its place, volume, stresses, principal
  ///   stresses σ₁ ≥ σ₂ ≥ σ₃, plastic strain and branch of the yield surface;
  /// - mesh.txt, the quality of the mesh.
  /// @throws FileError where a file cannot be written.
  void write_result_files(const std::filesystem::path &directory,
                          const Solution              &solution,
                          const Json                  &document);
} // namespace dpcontact

#endif
