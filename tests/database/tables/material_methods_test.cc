// Kriging, natural neighbours and regression on functions that are known.
#include "database/tables/material_table.h"
#include "meshing/errors.h"
#include "tests/support/records.h"

#include <cmath>
#include <functional>

using namespace dpcontact;
using namespace dpcontact::testing_database;

namespace
{
  using Function = std::function<double(const MaterialPoint &)>;

  /// The paper's grid; the same function of the point for a, b, m, n, times 1, 2, 3, 4.
  MaterialTable table_of(const Function &function, const std::vector<double> &E_GPa = {10, 20, 30})
  {
    MaterialTable table;
    table.radius    = 0.1;
    table.force_max = 100;
    for (const double E : E_GPa)
      for (const double nu : {0.1, 0.2, 0.3})
        for (const double phi : {20., 30., 40.})
          for (const double sigma : {5., 10., 20., 30., 40., 50.})
            {
              const MaterialPoint point{E * 1e9, nu, phi, sigma * 1e6};
              const double        value = function(point);
              table.rows.push_back({point, {value, 2 * value, 3 * value, 4 * value}});
            }
    return table;
  }

  double linear(const MaterialPoint &p)
  {
    return 1 + p.E_Pa / 1e11 + p.nu + p.phi_deg / 100 - p.sigma_c_Pa / 1e8;
  }

  /// Smooth and positive, linear in nothing.
  double smooth(const MaterialPoint &p)
  {
    return std::exp(0.3 * std::log(p.E_Pa / 1e10) + 2 * p.nu * p.nu + 0.01 * p.phi_deg -
                    0.4 * std::log(p.sigma_c_Pa / 1e7));
  }

  std::vector<MaterialPoint> points_inside(const std::uint64_t seed)
  {
    std::mt19937_64                        random(seed);
    std::uniform_real_distribution<double> uniform;
    std::vector<MaterialPoint>             points(40);
    for (MaterialPoint &point : points)
      point = {(10 + 20 * uniform(random)) * 1e9,
               0.1 + 0.2 * uniform(random),
               20 + 20 * uniform(random),
               (5 + 45 * uniform(random)) * 1e6};
    return points;
  }

  /// Ordinary least squares by the normal equations of scaled terms, of those that are taken.
  struct LeastSquares
  {
    std::array<double, 7> value{}, standard_error{};
    double                residual = 0;
  };

  LeastSquares least_squares(const MaterialTable            &table,
                             const std::size_t               c,
                             const std::vector<std::size_t> &taken)
  {
    const auto terms = [&](const MaterialPoint &p) {
      const double E = p.E_Pa / 1e9, sigma = p.sigma_c_Pa / 1e6;
      const double all[] = {1, E, p.nu, p.phi_deg * p.phi_deg, p.phi_deg, sigma * sigma, sigma};
      std::vector<long double> x;
      for (const std::size_t i : taken)
        x.push_back(all[i]);
      return x;
    };
    // [X'X | X'y | 1] by Gauss and Jordan, in long double.
    const std::size_t                     k = taken.size();
    std::vector<std::vector<long double>> a(k, std::vector<long double>(2 * k + 1));
    for (std::size_t i = 0; i < k; ++i)
      a[i][k + 1 + i] = 1;
    for (const auto &row : table.rows)
      {
        const auto x = terms(row.point);
        for (std::size_t i = 0; i < k; ++i)
          {
            for (std::size_t j = 0; j < k; ++j)
              a[i][j] += x[i] * x[j];
            a[i][k] += x[i] * static_cast<long double>(row.published[c]);
          }
      }
    for (std::size_t i = 0; i < k; ++i)
      {
        const long double pivot = a[i][i];
        for (long double &entry : a[i])
          entry /= pivot;
        for (std::size_t j = 0; j < k; ++j)
          if (j != i)
            {
              const long double factor = a[j][i];
              for (std::size_t l = 0; l <= 2 * k; ++l)
                a[j][l] -= factor * a[i][l];
            }
      }
    LeastSquares result;
    long double  sum = 0;
    for (const auto &row : table.rows)
      {
        const auto  x    = terms(row.point);
        long double left = static_cast<long double>(row.published[c]);
        for (std::size_t i = 0; i < k; ++i)
          left -= a[i][k] * x[i];
        sum += left * left;
      }
    result.residual =
      static_cast<double>(std::sqrt(sum / static_cast<long double>(table.rows.size() - k)));
    for (std::size_t i = 0; i < k; ++i)
      {
        result.value[taken[i]] = static_cast<double>(a[i][k]);
        result.standard_error[taken[i]] =
          result.residual * static_cast<double>(std::sqrt(a[i][k + 1 + i]));
      }
    return result;
  }

  Database database_of(const MaterialTable &table)
  {
    Database database;
    for (const auto &row : table.rows)
      {
        Record record;
        record.input.material = {
          row.point.E_Pa, row.point.nu, Angle(row.point.phi_deg), row.point.sigma_c_Pa};
        record.input.scene     = {table.radius, table.force_max, {}};
        record.status          = "converged";
        record.fit.published.a = row.published[0];
        record.law.b           = row.published[1];
        record.fit.published.m = row.published[2];
        record.law.n           = row.published[3];
        database.records.push_back(record);
      }
    return database;
  }
} // namespace

TEST(NaturalNeighbour, IsExactAtTheRowsAndForLinearFunctions)
{
  const MaterialTable rough   = table_of([](const MaterialPoint &p) {
    return 1 + 0.5 * std::sin(1e-9 * p.E_Pa + 40 * p.nu + p.phi_deg + 1e-6 * p.sigma_c_Pa);
  });
  const auto          at_rows = make_natural_neighbour(rough);
  for (const auto &row : rough.rows)
    for (std::size_t c = 0; c < 4; ++c)
      EXPECT_NEAR(at_rows->at(row.point).value[c], row.published[c], 1e-12);

  // Sibson's coordinates have linear precision, and the slices of E are joined linearly.
  const auto of_linear = make_natural_neighbour(table_of(linear));
  for (const MaterialPoint &point : points_inside(1))
    for (std::size_t c = 0; c < 4; ++c)
      EXPECT_NEAR(
        of_linear->at(point).value[c], (static_cast<double>(c) + 1) * linear(point), 1e-11);
}

TEST(NaturalNeighbour, StaysBetweenItsNeighboursAndAnswersOnTheFaces)
{
  const auto method = make_natural_neighbour(table_of(smooth));
  double     low = 1e9, high = 0;
  for (const auto &row : table_of(smooth).rows)
    {
      low  = std::min(low, row.published[0]);
      high = std::max(high, row.published[0]);
    }
  for (const MaterialPoint &point : points_inside(2))
    {
      const MaterialEstimate estimate = method->at(point);
      EXPECT_GE(estimate.value[0], low);
      EXPECT_LE(estimate.value[0], high);
      // The spread of the neighbours, over four, is of the error's magnitude.
      EXPECT_LT(std::abs(estimate.value[0] - smooth(point)), 4 * estimate.uncertainty[0]);
    }
  // A face is approached to 1e-7 of the box.
  const auto of_linear = make_natural_neighbour(table_of(linear));
  for (const MaterialPoint &point : {MaterialPoint{1.4e10, 0.1, 25, 12e6},
                                     MaterialPoint{1.4e10, 0.17, 40, 12e6},
                                     MaterialPoint{1e10, 0.3, 20, 47e6}})
    EXPECT_NEAR(of_linear->at(point).value[0], linear(point), 1e-6);
  // Beyond the box its nearest point answers.
  EXPECT_NEAR(of_linear->at({4e10, 0.4, 30, 12e6}).value[0], linear({3e10, 0.3, 30, 12e6}), 1e-6);
}

TEST(NaturalNeighbour, NeedsRowsThatSpanTheSpace)
{
  for (double MaterialPoint::*const axis :
       {&MaterialPoint::nu, &MaterialPoint::phi_deg, &MaterialPoint::sigma_c_Pa})
    {
      MaterialTable flat = table_of(linear);
      for (auto &row : flat.rows)
        row.point.*axis = flat.rows[0].point.*axis;
      EXPECT_THROW(make_natural_neighbour(flat), InputError);
    }
}

TEST(Kriging, IsExactAtTheRowsAndCertainThere)
{
  const MaterialTable table   = table_of(smooth);
  const auto          method  = make_kriging(table);
  double              between = 0;
  for (const MaterialPoint &point : points_inside(3))
    between += method->at(point).uncertainty[0] / smooth(point) / 40;
  for (std::size_t i = 0; i < table.rows.size(); i += 7)
    {
      const MaterialEstimate estimate = method->at(table.rows[i].point);
      for (std::size_t c = 0; c < 4; ++c)
        {
          // The matrix is solved to its condition number.
          EXPECT_NEAR(estimate.value[c] / table.rows[i].published[c], 1, 1e-6);
          EXPECT_LT(estimate.uncertainty[c] / estimate.value[c], 0.2 * between);
        }
    }
}

TEST(Kriging, PredictsASmoothFunctionWithinWhatItSays)
{
  const MaterialTable     table      = table_of(smooth);
  const KrigingCovariance covariance = fit_covariance(table);
  const auto              method = make_kriging(table), again = make_kriging(table, covariance);
  int                     covered = 0;
  for (const MaterialPoint &point : points_inside(4))
    {
      const MaterialEstimate estimate = method->at(point);
      EXPECT_NEAR(estimate.value[0] / smooth(point), 1, 0.01);
      covered += std::abs(estimate.value[0] - smooth(point)) < 2 * estimate.uncertainty[0];
      for (std::size_t c = 0; c < 4; ++c)
        {
          EXPECT_GT(estimate.uncertainty[c], 0);
          EXPECT_NEAR(again->at(point).value[c] / estimate.value[c], 1, 1e-9)
            << "a covariance that is known";
          EXPECT_NEAR(again->at(point).uncertainty[c] / estimate.uncertainty[c], 1, 1e-6);
        }
    }
  EXPECT_GE(covered, 36) << "of 40 within two standard deviations";
  // Further from the rows it knows less.
  EXPECT_GT(method->at({1.5e10, 0.15, 25, 45e6}).uncertainty[0],
            method->at({1.01e10, 0.101, 20.1, 49.9e6}).uncertainty[0]);
}

TEST(Kriging, OneModulusIsEnough)
{
  const MaterialTable table  = table_of(smooth, {10});
  const auto          method = make_kriging(table);
  for (std::size_t i = 0; i < table.rows.size(); i += 11)
    EXPECT_NEAR(method->at(table.rows[i].point).value[0] / table.rows[i].published[0], 1, 1e-6);
}

TEST(Regression, RecoversCoefficientsAndDropsWhatIsNoise)
{
  // Which terms there are: of a all, of b E and φ², of m ν and σc, of n none.
  const std::array<std::array<double, 7>, 4> truth{{{0.54, 1e-3, -0.2, 8e-5, -6e-3, 5e-5, -4e-3},
                                                    {1.3, 2e-3, 0, 9e-5, 0, 0, 0},
                                                    {2.3, 0, -0.3, 0, 0, 0, -5e-3},
                                                    {1.24, 0, 0, 0, 0, 0, 0}}};
  constexpr double                           sigma = 1e-3;
  std::mt19937_64                            random(20182);
  std::normal_distribution<double>           noise(0, sigma);
  MaterialTable                              table = table_of(linear);
  Regression                                 exact;
  for (std::size_t c = 0; c < 4; ++c)
    exact.of[c].value = truth[c];
  for (auto &row : table.rows)
    {
      row.published = exact.at(row.point);
      for (double &value : row.published)
        value += noise(random);
    }
  const Regression found = regress(table);
  int              kept  = 0;
  for (std::size_t c = 0; c < 4; ++c)
    {
      std::vector<std::size_t> taken;
      for (std::size_t i = 0; i < 7; ++i)
        if (found.of[c].value[i] != 0)
          taken.push_back(i);
      for (std::size_t i = 0; i < 7; ++i)
        {
          const double value = found.of[c].value[i], error = found.of[c].standard_error[i];
          if (truth[c][i] != 0)
            {
              EXPECT_NEAR(value, truth[c][i], 4 * error)
                << "abmn"[c] << ", " << regression_terms[i];
              EXPECT_GT(std::abs(value), 3 * error) << "abmn"[c] << ", " << regression_terms[i];
            }
          else if (value != 0)
            {
              ++kept;
              EXPECT_LT(std::abs(value), 3 * error) << "noise";
            }
        }
      // Values and errors are those of least squares with the terms that were taken.
      const LeastSquares by_hand = least_squares(table, c, taken);
      for (const std::size_t i : taken)
        {
          EXPECT_NEAR(found.of[c].value[i] / by_hand.value[i], 1, 1e-8);
          EXPECT_NEAR(found.of[c].standard_error[i] / by_hand.standard_error[i], 1, 1e-7);
        }
      EXPECT_NEAR(found.of[c].residual / by_hand.residual, 1, 1e-8);
      EXPECT_NEAR(found.of[c].residual / sigma, 1, 0.2) << "162 rows tell it to 6 %";
    }
  // Akaike's criterion keeps a term of pure noise in one case of six: χ² of one above 2.
  EXPECT_LE(kept, 6) << "of 14";
  EXPECT_GT(found.of[0].r_squared, 0.99);
  EXPECT_LT(found.of[3].r_squared, 0.1);
}

TEST(Regression, Table2AsPrinted)
{
  // Table 2 of the paper, row by row, at type 1 of its table 3.
  const MaterialPoint         type_1{10e9, 0.15, 25, 15e6};
  const std::array<double, 4> expected{
    0.5398 + 1.0279E-03 * 10 - 4.7213E-02 * 0.15 + 7.6500E-05 * 625 - 6.1476E-03 * 25 +
      5.5848E-05 * 225 - 4.4023E-03 * 15,
    1.3087 - 8.7130E-04 * 10 + 4.4259E-02 * 0.15 - 7.6019E-05 * 625 + 6.4120E-03 * 25 -
      3.8951E-05 * 225 + 3.3763E-03 * 15,
    2.3104 + 9.6205E-03 * 10 - 2.8768E-01 * 0.15 + 9.1244E-04 * 625 - 7.1235E-02 * 25 +
      6.6345E-04 * 225 - 4.8732E-02 * 15,
    1.2377 - 1.2352E-03 * 10 + 3.6574E-02 * 0.15 - 9.5000E-05 * 625 + 8.0222E-03 * 25 -
      7.9491E-05 * 225 + 6.2875E-03 * 15};
  const double           r_squared[] = {0.7068, 0.7665, 0.5166, 0.7517};
  const MaterialEstimate estimate    = make_regression(table_2())->at(type_1);
  for (std::size_t c = 0; c < 4; ++c)
    {
      EXPECT_NEAR(estimate.value[c], expected[c], 1e-13);
      EXPECT_EQ(table_2().of[c].r_squared, r_squared[c]);
      EXPECT_TRUE(std::isnan(estimate.uncertainty[c])) << "the paper prints none";
    }
}

TEST(MaterialTable, NamesTheAxisAndTheRangeThatAPointIsOutsideOf)
{
  const MaterialTable table = table_of(linear);
  EXPECT_NO_THROW(table.check_inside({1e10, 0.3, 20, 50e6}, Outside::refuse));
  for (const auto &[point, parts] : {std::pair<MaterialPoint, std::vector<std::string>>{
                                       {9e9, 0.2, 30, 10e6}, {"E", "1e+10", "3e+10"}},
                                     {{1e10, 0.31, 30, 10e6}, {"nu", "0.1", "0.3"}},
                                     {{1e10, 0.2, 19, 10e6}, {"phi", "20", "40"}},
                                     {{1e10, 0.2, 30, 51e6}, {"sigma-c", "5e+06", "5e+07"}}})
    {
      const MaterialPoint &outside = point;
      const std::string    message =
        message_of<InputError>([&] { table.check_inside(outside, Outside::refuse); });
      for (const std::string &part : parts)
        EXPECT_NE(message.find(part), std::string::npos) << message;
      EXPECT_NO_THROW(table.check_inside(point, Outside::extrapolate));
    }
}

TEST(MaterialTable, TakesOnlyRowsOfOneKind)
{
  const Database good  = database_of(table_of(linear));
  const auto     table = MaterialTable::from_rows(good);
  ASSERT_EQ(table.rows.size(), good.records.size());
  EXPECT_EQ(table.rows[5].published[2], good.records[5].fit.published.m);
  EXPECT_EQ(table.without(5).rows.size(), good.records.size() - 1);
  EXPECT_EQ(table.without(5).rows[5].point.sigma_c_Pa, table.rows[6].point.sigma_c_Pa);

  const auto refused = [&](const auto &change, const std::string &part) {
    Database copy = good;
    change(copy.records[3]);
    const std::string message = message_of<InputError>([&] { MaterialTable::from_rows(copy); });
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  refused([](Record &row) { row.status = "failed", row.reason = "a reason"; }, "a reason");
  refused([](Record &row) { row.input.scene.radius *= 2; }, "radius");
  refused([](Record &row) { row.input.scene.force_max *= 2; }, "force-max");
  refused([](Record &row) { row.input.material.criterion = Criterion::von_mises; },
          "drucker-prager");
  refused([](Record &row) { row.input.material.dilation_angle = Angle(0); }, "associated");
  refused([](Record &row) { row.input.material.hardening = 1e6; }, "perfectly plastic");
  EXPECT_THROW(MaterialTable::from_rows(Database{}), InputError);
}
