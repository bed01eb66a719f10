#ifndef DPCONTACT_DATABASE_TABLES_MATERIAL_TABLE_H
#define DPCONTACT_DATABASE_TABLES_MATERIAL_TABLE_H

#include "database/tables/universal_lookup.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace dpcontact
{
  /// A place in the paper's material space: the coordinates of a material.
  struct MaterialPoint
  {
    double E_Pa, nu, phi_deg, sigma_c_Pa;

    static MaterialPoint of(const Material &material);
  };

  /// The four coefficients at a point of the material space, in the published convention: a 2^−b,
  /// b, m 2^−n, n.
  struct MaterialEstimate
  {
    std::array<double, 4> value;
    std::array<double, 4> uncertainty; ///< one standard deviation, or what the method says
  };

  /// Rows of equal R and F_max over (E, ν, φ, σ_c), like the 162 rows of the paper.
  struct MaterialTable
  {
    struct Row
    {
      MaterialPoint         point;
      std::array<double, 4> published; ///< as in MaterialEstimate
      std::array<double, 4> error{};   ///< the total that the row states, of each
      double peak_misfit{};            ///< approach of the law over that of the curve − 1, ≥ 0
      double residual_misfit{}; ///< of eq (18) against the curve, over the peak's approach, ≥ 0
    };
    std::vector<Row> rows; ///< in the order of E, ν, φ, σ_c, whatever that of the database was
    double           radius, force_max; ///< of all rows, m and N

    /// Takes the rows of a database.
    /// @throws InputError where a row failed, R or F_max differ, or a material is not associated,
    /// perfectly plastic Drucker–Prager.
    static MaterialTable from_rows(const Database &database);

    /// @throws InputError naming axis and range where the point lies outside.
    void check_inside(const MaterialPoint &point, Outside outside) const;

    /// What the rows around a point do not know themselves, which no method makes better: of each
    /// error and misfit the largest of the rows in the cell of the grid that holds the point.
    /// Beyond the grid its nearest cell counts.
    Row errors_around(const MaterialPoint &point) const;

    /// The table without one row, counted from 0, for leave-one-out validation.
    MaterialTable without(std::size_t row) const;
  };

  /// A method that estimates coefficients between the rows of a table.
  class MaterialMethod
  {
  public:
    virtual ~MaterialMethod()                                     = default;
    virtual MaterialEstimate at(const MaterialPoint &point) const = 0;
  };

  /// Kriging of the logarithm of each coefficient over (ln E, ν, φ, ln σ_c) scaled to the unit box,
  /// with a constant trend and a Matérn 5/2 covariance fitted by maximum likelihood (OpenTURNS).
  /// The uncertainty is the conditional standard deviation.
  std::unique_ptr<MaterialMethod> make_kriging(const MaterialTable &table);

  /// The covariance of each coefficient: four lengths in the unit box, and the amplitude.
  using KrigingCovariance = std::array<std::array<double, 5>, 4>;

  /// The covariance that make_kriging() finds for a table.
  KrigingCovariance fit_covariance(const MaterialTable &table);

  /// Kriging with a covariance that is known already, for leave-one-out validation.
  std::unique_ptr<MaterialMethod> make_kriging(const MaterialTable     &table,
                                               const KrigingCovariance &covariance);

  /// Sibson's natural neighbours (CGAL) in (ν, φ, σ_c) scaled to the unit box, linear between the
  /// slices of E, and exact at the rows. A point beyond the box has the value of the box's nearest
  /// point. The uncertainty is a quarter of the spread of the neighbours' values about the
  /// estimate, with the weights that the neighbours have in it.
  std::unique_ptr<MaterialMethod> make_natural_neighbour(const MaterialTable &table);

  /// Eq (19), f = C₀ + C₁E + C₂ν + C₃φ² + C₄φ + C₅σ_c² + C₆σ_c with E in GPa, φ in degrees, σ_c in
  /// MPa, of a, b, m, n in the published convention.
  struct Regression
  {
    struct Coefficient
    {
      std::array<double, 7> value{}; ///< C₀ to C₆, 0 where a term was not taken
      std::array<double, 7> standard_error{};
      double                r_squared = 0;
      double                residual  = 0; ///< standard deviation of the residuals
    };
    std::array<Coefficient, 4> of; ///< a, b, m, n

    /// a, b, m, n in the published convention.
    std::array<double, 4> at(const MaterialPoint &point) const;

    /// What C₀ to C₆ are multiplied by.
    static std::array<double, 7> terms_at(const MaterialPoint &point);
  };

  /// The names of the seven terms.
  extern const std::array<const char *, 7> regression_terms;

  /// Chooses the terms stepwise, in both directions, by Akaike's criterion (OpenTURNS).
  Regression regress(const MaterialTable &table);

  /// Table 2 of the paper as printed, with its R².
  const Regression &table_2();

  /// A regression as a method. Its uncertainty is the standard deviation of the residuals.
  std::unique_ptr<MaterialMethod> make_regression(const Regression &regression);
} // namespace dpcontact

#endif
