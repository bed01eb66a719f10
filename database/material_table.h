#ifndef DPCONTACT_DATABASE_MATERIAL_TABLE_H
#define DPCONTACT_DATABASE_MATERIAL_TABLE_H

#include "database/universal_lookup.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace dpcontact
{
  /// The paper's material space.
  struct MaterialPoint
  {
    double E_Pa, nu, phi_deg, sigma_c_Pa;
  };

  /// The four coefficients at a point of the material space, in the published convention: a 2^−b,
  /// b, m 2^−n, n.
  struct MaterialEstimate
  {
    std::array<double, 4> value;
    std::array<double, 4> uncertainty; ///< one standard deviation, or as the method says
  };

  /// Rows of equal R and F_max over (E, ν, φ, σ_c), as the paper's 162.
  struct MaterialTable
  {
    struct Row
    {
      MaterialPoint         point;
      std::array<double, 4> published;
    };
    std::vector<Row> rows;
    double           radius, force_max; ///< m, N

    /// @throws InputError where a row failed, R or F_max differ, or a material is not associated,
    /// perfectly plastic Drucker–Prager.
    static MaterialTable from_rows(const Database &database);

    /// @throws InputError naming axis and range where the point lies outside.
    void check_inside(const MaterialPoint &point, Outside outside) const;

    /// Without one row: leave-one-out.
    MaterialTable without(std::size_t row) const;
  };

  /// A way from a table to coefficients between its rows.
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

  /// Covariance of each coefficient: four lengths in the unit box, and the amplitude.
  using KrigingCovariance = std::array<std::array<double, 5>, 4>;
  KrigingCovariance fit_covariance(const MaterialTable &table);

  /// The same with a covariance that is known: for leave-one-out.
  std::unique_ptr<MaterialMethod> make_kriging(const MaterialTable     &table,
                                               const KrigingCovariance &covariance);

  /// Sibson's natural neighbours (CGAL) in (ν, φ, σ_c) scaled to the unit box, linear between the
  /// slices of E; exact at the rows. Beyond the box the nearest point of it answers. The
  /// uncertainty is the spread of the neighbours' values about the estimate, weighted as they are,
  /// over four.
  std::unique_ptr<MaterialMethod> make_natural_neighbour(const MaterialTable &table);

  /// Eq (19), f = C₀ + C₁E + C₂ν + C₃φ² + C₄φ + C₅σ_c² + C₆σ_c with E in GPa, φ in degrees, σ_c in
  /// MPa, of a, b, m, n in the published convention.
  struct Regression
  {
    struct Coefficient
    {
      std::array<double, 7> value{}; ///< nought where a term was not taken
      std::array<double, 7> standard_error{};
      double                r_squared = 0;
      double                residual  = 0; ///< standard deviation
    };
    std::array<Coefficient, 4> of; ///< a, b, m, n

    std::array<double, 4> at(const MaterialPoint &point) const;
  };
  extern const std::array<const char *, 7> regression_terms;

  /// Stepwise in both directions by Akaike's criterion (OpenTURNS).
  Regression regress(const MaterialTable &table);

  /// Table 2 of the paper as printed, with its R².
  const Regression &table_2();

  std::unique_ptr<MaterialMethod> make_regression(const Regression &regression);
} // namespace dpcontact

#endif
