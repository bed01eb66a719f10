#include "database/tables/material_table.h"
#include "meshing/errors.h"

#include <cmath>
#include <openturns/LinearModelResult.hxx>
#include <openturns/LinearModelStepwiseAlgorithm.hxx>
#include <openturns/Log.hxx>
#include <openturns/SymbolicFunction.hxx>

namespace dpcontact
{
  const std::array<const char *, 7> regression_terms =
    {"1", "E", "nu", "phi^2", "phi", "sigma_c^2", "sigma_c"};

  namespace
  {
    /// E in GPa, ν, φ in degrees, σ_c in MPa.
    std::array<double, 7> terms_at(const MaterialPoint &point)
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

  std::array<double, 4> Regression::at(const MaterialPoint &point) const
  {
    const auto            terms = terms_at(point);
    std::array<double, 4> values{};
    for (std::size_t c = 0; c < 4; ++c)
      for (std::size_t i = 0; i < terms.size(); ++i)
        values[c] += of[c].value[i] * terms[i];
    return values;
  }

  Regression regress(const MaterialTable &table)
  {
    OT::Log::Show(OT::Log::NONE);
    const std::size_t n = table.rows.size();
    OT::Sample        input(n, 6);
    for (std::size_t i = 0; i < n; ++i)
      {
        const auto terms = terms_at(table.rows[i].point);
        for (std::size_t k = 1; k < terms.size(); ++k)
          input(i, k - 1) = terms[k];
      }
    const OT::Description variables = {"E", "nu", "phi2", "phi", "sigma2", "sigma"};
    OT::Basis             basis;
    basis.add(OT::SymbolicFunction(variables, {"1"}));
    for (const auto &name : variables)
      basis.add(OT::SymbolicFunction(variables, {name}));

    Regression regression;
    for (std::size_t c = 0; c < 4; ++c)
      {
        OT::Sample output(n, 1);
        for (std::size_t i = 0; i < n; ++i)
          output(i, 0) = table.rows[i].published[c];
        OT::LinearModelStepwiseAlgorithm algorithm(input,
                                                   basis,
                                                   output,
                                                   OT::Indices(1, 0),
                                                   OT::LinearModelStepwiseAlgorithm::BOTH,
                                                   OT::Indices(1, 0));
        algorithm.run();
        const OT::LinearModelResult result = algorithm.getResult();
        const OT::Point             values = result.getCoefficients();
        const OT::Point             spread = result.getDiagonalGramInverse();
        const OT::Basis             taken  = result.getBasis();
        Regression::Coefficient    &of     = regression.of[c];
        for (OT::UnsignedInteger k = 0; k < taken.getSize(); ++k)
          for (std::size_t i = 0; i < 7; ++i)
            if (taken[k].__str__() == basis[i].__str__())
              {
                of.value[i]          = values[k];
                of.standard_error[i] = std::sqrt(spread[k]); // times the residual, below
              }
        of.r_squared = result.getRSquared();
        double sum   = 0;
        for (const auto &row : table.rows)
          sum += std::pow(regression.at(row.point)[c] - row.published[c], 2);
        of.residual = std::sqrt(sum / static_cast<double>(n - values.getSize()));
        for (double &error : of.standard_error)
          error *= of.residual; // OpenTURNS' own divides the sum by n
      }
    return regression;
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
