#ifndef DPCONTACT_RUNS_INTERFACE_RESULT_FILES_H
#define DPCONTACT_RUNS_INTERFACE_RESULT_FILES_H

#include "runs/interface/documents.h"
#include "solver/output/field_sink.h"
#include "solver/path/solution.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dpcontact
{
  /// Makes the directory, with its parents, unless it is there. @throws FileError.
  void make_result_directory(const std::filesystem::path &directory);

  /// What a solve always writes into a directory.
  std::vector<std::filesystem::path> result_files_of(const std::filesystem::path &directory);

  /// The paths, in the order of their names, of all that a directory holds under a name which a
  /// solve gives its files: those of write_result_files(), and the fields of write_fields()
  /// (peak.vtu, released-2.vtu, peak.0.vtu, peak.pvtu). @throws FileError.
  std::vector<std::filesystem::path> result_files_in(const std::filesystem::path &directory);

  /// What becomes of results that a directory holds already.
  enum class OldResults
  {
    refuse, ///< the directory must have none
    keep,   ///< those of a computation that was stopped and goes on; a converged one is refused
    remove  ///< what a solve writes, with its temporary files, and nothing else
  };

  /// @throws FileError for results that are refused, or that cannot be removed.
  void see_to_old_results(const std::filesystem::path &directory, OldResults old);

  /// Writes every file of fields into the directory, so that none is ever half one.
  FieldSink fields_into(const std::filesystem::path &directory);

  /// Writes what a solve has found into a directory, in SI units that the headers name, stresses
  /// tension positive:
  /// - result.json, the document as it is printed;
  /// - curve.csv, both branches of the force–displacement curve;
  /// - profile.csv, the contact pressure at the peak;
  /// - axis.csv, the stresses on the axis at the peak;
  /// - points.csv, every quadrature point at the peak: its place, volume, stresses, principal
  ///   stresses σ₁ ≥ σ₂ ≥ σ₃, plastic strain and branch of the yield surface;
  /// - mesh.txt, the quality of the mesh.
  /// @param document is given the entry `files`: the paths of these and of the fields.
  /// @throws FileError where a file cannot be written.
  void write_result_files(const std::filesystem::path &directory,
                          const Solution              &solution,
                          Json                        &document);

  /// Writes the result.json of a solve that has failed: "status": "failed", the reason, and the
  /// inputs. A file that cannot be written is passed over, as the failure itself is reported.
  void write_failed_result(const std::filesystem::path &directory,
                           const Json                  &inputs,
                           const std::string           &reason);
} // namespace dpcontact

#endif
