#include "database/material_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <openturns/Basis.hxx>
#include <openturns/ConstantBasisFactory.hxx>
#include <openturns/KrigingAlgorithm.hxx>
#include <openturns/Log.hxx>
#include <openturns/MaternModel.hxx>

namespace dpcontact
{
  namespace
  {
    std::array<double, 4> position(const MaterialPoint &point)
    {
      return {std::log(point.E_Pa), point.nu, point.phi_deg, std::log(point.sigma_c_Pa)};
    }

    class Kriging : public MaterialMethod
    {
    public:
      explicit Kriging(const MaterialTable &table)
      {
        OT::Log::Show(OT::Log::NONE);
        low.fill(std::numeric_limits<double>::infinity());
        high.fill(-std::numeric_limits<double>::infinity());
        for (const auto &row : table.rows)
          {
            const auto x = position(row.point);
            for (std::size_t i = 0; i < 4; ++i)
              {
                low[i]  = std::min(low[i], x[i]);
                high[i] = std::max(high[i], x[i]);
              }
          }
        const std::size_t n = table.rows.size();
        OT::Sample        input(n, 4);
        for (std::size_t k = 0; k < n; ++k)
          {
            const OT::Point x = scaled(table.rows[k].point);
            for (std::size_t i = 0; i < 4; ++i)
              input(k, i) = x[i];
          }
        for (std::size_t c = 0; c < 4; ++c)
          {
            OT::Sample output(n, 1);
            for (std::size_t k = 0; k < n; ++k)
              output(k, 0) = table.rows[k].published[c];
            OT::KrigingAlgorithm algorithm(input,
                                           output,
                                           OT::MaternModel(OT::Point(4, 1.), OT::Point(1, 1.), 2.5),
                                           OT::ConstantBasisFactory(4).build());
            algorithm.setOptimizationBounds(OT::Interval(OT::Point(4, 0.05), OT::Point(4, 20.)));
            algorithm.run();
            results.push_back(algorithm.getResult());
          }
      }

      MaterialEstimate at(const MaterialPoint &point) const override
      {
        const OT::Point  x = scaled(point);
        MaterialEstimate estimate{};
        for (std::size_t c = 0; c < 4; ++c)
          {
            estimate.value[c] = results[c].getConditionalMean(x)[0];
            estimate.uncertainty[c] =
              std::sqrt(std::max(0., results[c].getConditionalMarginalVariance(x)));
          }
        return estimate;
      }

    private:
      OT::Point scaled(const MaterialPoint &point) const
      {
        const auto x = position(point);
        OT::Point  result(4);
        for (std::size_t i = 0; i < 4; ++i)
          result[i] = high[i] > low[i] ? (x[i] - low[i]) / (high[i] - low[i]) : 0.;
        return result;
      }

      std::array<double, 4>          low{}, high{};
      std::vector<OT::KrigingResult> results;
    };
  } // namespace

  std::unique_ptr<MaterialMethod> make_kriging(const MaterialTable &table)
  {
    return std::make_unique<Kriging>(table);
  }
} // namespace dpcontact
