#include "database/tables/material_table.h"

#include <cmath>

namespace dpcontact
{
  const std::array<const char *, 7> regression_terms =
    {"1", "E", "nu", "phi^2", "phi", "sigma_c^2", "sigma_c"};

  namespace
  {
    class ByRegression : public MaterialMethod
    {
    public:
      explicit ByRegression(const Regression &fitted)
        : regression(fitted)
      {}
      MaterialEstimate at(const MaterialPoint &point) const override
      {
        MaterialEstimate estimate{regression.at(point), {}};
        for (std::size_t c = 0; c < 4; ++c)
          estimate.uncertainty[c] = regression.of[c].residual;
        return estimate;
      }

    private:
      Regression regression;
    };
  } // namespace

  std::array<double, 7> Regression::terms_at(const MaterialPoint &point)
  {
    const double strength = point.sigma_c_Pa / 1e6;
    return {1,
            point.E_Pa / 1e9,
            point.nu,
            point.phi_deg * point.phi_deg,
            point.phi_deg,
            strength * strength,
            strength};
  }

  std::array<double, 4> Regression::at(const MaterialPoint &point) const
  {
    const auto            terms = terms_at(point);
    std::array<double, 4> values{};
    for (std::size_t c = 0; c < 4; ++c)
      for (std::size_t i = 0; i < terms.size(); ++i)
        values[c] += of[c].value[i] * terms[i];
    return values;
  }

  const Regression &table_2()
  {
    static const Regression printed = [] {
      Regression r;
      r.of[0].value = {0.5398, 1.0279e-3, -4.7213e-2, 7.6500e-5, -6.1476e-3, 5.5848e-5, -4.4023e-3};
      r.of[1].value = {1.3087, -8.7130e-4, 4.4259e-2, -7.6019e-5, 6.4120e-3, -3.8951e-5, 3.3763e-3};
      r.of[2].value = {2.3104, 9.6205e-3, -2.8768e-1, 9.1244e-4, -7.1235e-2, 6.6345e-4, -4.8732e-2};
      r.of[3].value = {1.2377, -1.2352e-3, 3.6574e-2, -9.5000e-5, 8.0222e-3, -7.9491e-5, 6.2875e-3};
      const double r2[] = {0.7068, 0.7665, 0.5166, 0.7517};
      for (std::size_t c = 0; c < 4; ++c)
        {
          r.of[c].r_squared = r2[c];
          r.of[c].standard_error.fill(UniversalNode::unset); // not printed
          r.of[c].residual = UniversalNode::unset;
        }
      return r;
    }();
    return printed;
  }

  std::unique_ptr<MaterialMethod> make_regression(const Regression &regression)
  {
    return std::make_unique<ByRegression>(regression);
  }
} // namespace dpcontact
