#ifndef DPCONTACT_DATABASE_TABLES_LOOKUP_H
#define DPCONTACT_DATABASE_TABLES_LOOKUP_H

#include "database/tables/universal_lookup.h"
#include "fitting/coefficients.h"
#include "meshing/enum_names.h"
#include "solver/closed_form/first_yield.h"
#include "solver/problem/case.h"
#include "solver/problem/curve.h"

#include <filesystem>
#include <memory>
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

  template <>
  struct EnumNames<LookupMethod>
  {
    static constexpr const char            *what     = "method";
    static constexpr EnumName<LookupMethod> values[] = {
      {LookupMethod::similarity, "similarity"},
      {LookupMethod::kriging, "kriging"},
      {LookupMethod::natural_neighbour, "natural-neighbour"},
      {LookupMethod::regression, "regression"},
      {LookupMethod::table_2, "table-2"}};
  };

  /// A number and its stated uncertainty; NaN where none is known.
  struct Uncertain
  {
    double value       = Coefficients::unset;
    double uncertainty = Coefficients::unset;
  };

  /// The parts of the uncertainty of a, b, m, n, of similarity.
  struct LookupParts
  {
    Coefficients interpolation, numerical, finite_radius;
    Coefficients power_law_misfit; ///< stands apart: no part of the sum
  };

  /// What a table says about one case.
  struct LookupResult
  {
    LookupMethod method = LookupMethod::similarity;
    FirstYield   yield{};
    double       load_level = Coefficients::unset;
    Coefficients coefficients;          ///< of the consistent pair
    Coefficients uncertainty;           ///< of each: interpolation, numerical, finite radius
    Coefficients published;             ///< a 2^−b, b, m 2^−n, n
    Coefficients published_uncertainty; ///< of each
    Uncertain    peak_approach;         ///< m
    Uncertain    residual_approach;     ///< m; of similarity as computed
    double       residual_eq18 = Coefficients::unset; ///< m
    /// Unloading as the contact law does, F_max ((δ − residual_of_law)/(δ_p − residual_of_law))^p:
    /// of similarity from m_law and n_law, otherwise eqs (17), (18). m, 1.
    double                  residual_of_law = Coefficients::unset;
    double                  law_exponent    = Coefficients::unset;
    LookupParts             parts;
    std::vector<CurvePoint> loading; ///< of similarity the master curve
    /// Whether nothing yields, so that the law is Hertz's.
    bool elastic() const { return load_level * yield.force <= yield.elastic_force; }

    std::vector<std::string> warnings; ///< doubts_about() the case; that it lies outside the data
  };

  /// Whether an answer must be a law that a contact may have: 0 ≤ δ_res < δ_max but for the
  /// stated uncertainty of δ_res, n ≥ 1, all finite.
  enum class Laws
  {
    possible,
    any ///< for studies of how good a method is
  };

  class MaterialMethod;
  struct MaterialTable;

  /// Makes what estimates between the rows of a table: make_estimator() (estimators.h).
  using EstimatorMaker = std::unique_ptr<MaterialMethod> (*)(LookupMethod, const MaterialTable &);

  /// A table ready to be asked.
  class LookupTable
  {
  public:
    /// @throws FileError, and CorruptData where the table does not pass its checks.
    /// @param make needed for kriging, natural neighbours and the regression alone.
    LookupTable(LookupMethod                 method,
                const std::filesystem::path &database,
                EstimatorMaker               make = nullptr);
    ~LookupTable();
    LookupTable(LookupTable &&) noexcept;

    /// @throws InputError for a kind of material that the tables do not hold, and naming the axis and
    /// its range where the case lies outside and `outside` refuses. Otherwise no uncertainty is
    /// known there: NaN.
    /// @throws InputError also where a law that is not possible comes of it, unless `laws` are any.
    LookupResult
    at(const Case &input, Outside outside = Outside::refuse, Laws laws = Laws::possible) const;

  private:
    LookupResult estimate(const Case &input, Outside outside, Laws laws) const;

    struct Content;
    std::unique_ptr<Content> content;
  };
} // namespace dpcontact

#endif
