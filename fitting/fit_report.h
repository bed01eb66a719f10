#ifndef DPCONTACT_FITTING_FIT_REPORT_H
#define DPCONTACT_FITTING_FIT_REPORT_H

#include "fitting/least_squares.h"

#include <limits>
#include <vector>

namespace dpcontact
{
  /// How well a form describes the points it was fitted to, and how the fit went.
  struct FitReport
  {
    unsigned int n_points     = 0;
    unsigned int n_parameters = 0;
    unsigned int rank         = 0; ///< below n_parameters: the points do not determine them all
    double       r_squared  = std::numeric_limits<double>::quiet_NaN(); ///< 1 − SSE/SST, centred
    double       rmse       = std::numeric_limits<double>::quiet_NaN(); ///< √(SSE/n)/max y
    unsigned int iterations = 0;
    StopReason   reason     = StopReason::failed;
    bool         converged  = false;
  };

  /// Reports on a fit with R² = 1 − Σ(y − f)²/Σ(y − ȳ)² and RMSE = √(Σ(y − f)²/n)/max y. For a
  /// branch of a curve max y is the peak force. (Matlab's RMSE divides by n − p, and not by max y.)
  /// @param y the points' ordinates, which must not be empty
  /// @param predictions f, the form's values there, as many
  FitReport fit_report(const LeastSquaresSummary &summary,
                       const std::vector<double> &y,
                       const std::vector<double> &predictions);
} // namespace dpcontact

#endif
