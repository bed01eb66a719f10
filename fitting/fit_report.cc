#include "fitting/fit_report.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dpcontact
{
  FitReport fit_report(const LeastSquaresSummary &summary,
                       const std::vector<double> &y,
                       const std::vector<double> &predictions)
  {
    const double n    = static_cast<double>(y.size());
    const double mean = std::accumulate(y.begin(), y.end(), 0.) / n;
    double       sse = 0, sst = 0;
    for (std::size_t i = 0; i < y.size(); ++i)
      {
        sse += (y[i] - predictions[i]) * (y[i] - predictions[i]);
        sst += (y[i] - mean) * (y[i] - mean);
      }
    FitReport report;
    report.n_points     = static_cast<unsigned int>(y.size());
    report.n_parameters = static_cast<unsigned int>(summary.parameters.size());
    report.rank         = summary.rank;
    report.r_squared    = 1 - sse / sst;
    report.rmse         = std::sqrt(sse / n) / *std::max_element(y.begin(), y.end());
    report.iterations   = summary.iterations;
    report.reason       = summary.reason;
    report.converged    = summary.converged;
    return report;
  }
} // namespace dpcontact
