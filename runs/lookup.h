#ifndef DPCONTACT_RUNS_LOOKUP_H
#define DPCONTACT_RUNS_LOOKUP_H

#include "database/material_table.h"
#include "database/universal_lookup.h"
#include "runs/documents.h"

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace dpcontact
{
  enum class LookupMethod
  {
    similarity, ///< the universal table: any R, E, σ_c and F_max
    kriging,    ///< the others: the paper's material space, one R and one F_max
    natural_neighbour,
    regression, ///< eq (19) regressed over the rows
    table_2     ///< eq (19) as the paper prints it
  };
  const char *to_string(LookupMethod method);
  /// @throws InputError where `name` is none of the names that to_string() gives.
  LookupMethod parse_lookup_method(const std::string &name);

  /// Where the tables of this project lie.
  std::filesystem::path default_database(LookupMethod method);

  /// What a table says about one scene.
  struct LookupResult
  {
    LookupMethod          method;
    FirstYield            yield;
    double                load_level;
    std::array<double, 4> coefficients; ///< a, b, m, n of the consistent pair
    std::array<double, 4> uncertainty;  ///< of each: interpolation, numerical, finite radius
    std::array<double, 4> published;    ///< a 2^−b, b, m 2^−n, n
    std::array<double, 4> published_uncertainty;
    double                peak_approach, peak_approach_uncertainty; ///< m
    double residual_approach, residual_approach_uncertainty; ///< m; of similarity as computed
    double residual_eq18;                                    ///< m
    /// Unloading as the contact law does, F_max ((δ − residual_of_law)/(δ_p − residual_of_law))^p:
    /// of similarity from m_law and n_law, otherwise eqs (17), (18).
    double residual_of_law, law_exponent; ///< m, 1
    /// Of similarity: interpolation, numerical, finite_radius, power_law_misfit.
    std::array<std::array<double, 4>, 4> parts;
    std::vector<CurvePoint>              loading; ///< of similarity the master curve
  };

  /// A table ready to be asked.
  class LookupTable
  {
  public:
    /// @throws FileError, CorruptData.
    LookupTable(LookupMethod method, const std::filesystem::path &database);
    ~LookupTable();
    LookupTable(LookupTable &&) noexcept;

    /// @throws InputError for what the table does not cover: another criterion, hardening, and the axis
    /// and its range where the scene lies outside and `outside` refuses. Otherwise no uncertainty
    /// is known there: NaN.
    LookupResult at(const Case &input, Outside outside = Outside::refuse) const;

  private:
    LookupResult estimate(const Case &input, Outside outside) const;

    struct Content;
    std::unique_ptr<Content> content;
  };

  /// The objects `material`, `scene`, `yield`, `fit`, `published_convention` of solve's document
  /// without what a table cannot know, `uncertainty` and others.
  Json        lookup_json(const Case &input, const LookupResult &result, unsigned int curve_points);
  std::string describe(const Case &input, const LookupResult &result);

  /// One line an answer: inputs, a, b, m, n in both conventions with their uncertainties, F_y, δ_y,
  /// peak and residual approach; lines that begin with `#` give units. What is not known is empty.
  std::string lookup_csv(const std::vector<std::pair<Case, LookupResult>> &answers);
} // namespace dpcontact

#endif
