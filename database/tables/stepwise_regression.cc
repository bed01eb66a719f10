#include "database/tables/material_table.h"

#include <cmath>
#include <openturns/LinearModelResult.hxx>
#include <openturns/LinearModelStepwiseAlgorithm.hxx>
#include <openturns/Log.hxx>
#include <openturns/SymbolicFunction.hxx>

namespace dpcontact
{
  Regression regress(const MaterialTable &table)
  {
    OT::Log::Show(OT::Log::NONE);
    const std::size_t n = table.rows.size();
    OT::Sample        input(n, 6);
    for (std::size_t i = 0; i < n; ++i)
      {
        const auto terms = Regression::terms_at(table.rows[i].point);
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
} // namespace dpcontact
