#ifndef DPCONTACT_RUNS_RESULT_FILES_H
#define DPCONTACT_RUNS_RESULT_FILES_H

#include "runs/documents.h"

#include <filesystem>

namespace dpcontact
{
  /// Makes the directory, with its parents, unless it is there. @throws FileError.
  void make_result_directory(const std::filesystem::path &directory);

  /// Writes result.json, curve.csv (both branches), profile.csv (contact pressure at the peak),
  /// axis.csv (stresses on the axis at the peak) and points.csv (every quadrature point at the
  /// peak: place, volume, stresses, principal stresses σ₁ ≥ σ₂ ≥ σ₃, plastic strain, branch of the
  /// yield surface). Stresses are tension
  /// positive. SI units, named in the headers. @throws FileError.
  void write_result_files(const std::filesystem::path &directory,
                          const Solution              &solution,
                          const Json                  &document);
} // namespace dpcontact

#endif
