#include "database/tables/material_table.h"
#include "solver/parallel/blas_memory.h"

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
      Kriging(const MaterialTable &table, const KrigingCovariance *known)
      {
        require_blas_memory();
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
              output(k, 0) = std::log(table.rows[k].published[c]);
            OT::MaternModel model(OT::Point(4, 1.), OT::Point(1, 1.), 2.5);
            if (known != nullptr)
              {
                const auto &values = (*known)[c];
                model = OT::MaternModel(OT::Point({values[0], values[1], values[2], values[3]}),
                                        OT::Point(1, values[4]),
                                        2.5);
              }
            OT::KrigingAlgorithm algorithm(
              input, output, model, OT::ConstantBasisFactory(4).build());
            algorithm.setOptimizeParameters(known == nullptr);
            if (known == nullptr)
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
            estimate.value[c] = std::exp(results[c].getConditionalMean(x)[0]);
            estimate.uncertainty[c] =
              estimate.value[c] *
              std::sqrt(std::max(0., results[c].getConditionalMarginalVariance(x)));
          }
        return estimate;
      }

      KrigingCovariance covariance() const
      {
        KrigingCovariance values{};
        for (std::size_t c = 0; c < 4; ++c)
          {
            const auto model = results[c].getCovarianceModel();
            for (std::size_t i = 0; i < 4; ++i)
              values[c][i] = model.getScale()[i];
            values[c][4] = model.getAmplitude()[0];
          }
        return values;
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
    return std::make_unique<Kriging>(table, nullptr);
  }

  KrigingCovariance fit_covariance(const MaterialTable &table)
  {
    return Kriging(table, nullptr).covariance();
  }

  std::unique_ptr<MaterialMethod> make_kriging(const MaterialTable     &table,
                                               const KrigingCovariance &covariance)
  {
    return std::make_unique<Kriging>(table, &covariance);
  }
} // namespace dpcontact
