#ifndef DPCONTACT_FITTING_RESAMPLE_H
#define DPCONTACT_FITTING_RESAMPLE_H

#include "meshing/enum_names.h"
#include "solver/problem/curve.h"

#include <functional>
#include <vector>

namespace dpcontact
{
  /// The branches of a curve.
  enum class Branch
  {
    loading,  ///< F over x = δ, from 0 to δ_max
    unloading ///< F over x = δ − δ_res, from 0 to δ_max − δ_res
  };

  template <>
  struct EnumNames<Branch>
  {
    static constexpr const char      *what     = "branch";
    static constexpr EnumName<Branch> values[] = {{Branch::loading, "loading"},
                                                  {Branch::unloading, "unloading"}};
  };

  /// One branch of a curve as a function F(x) that does not depend on how the solver chose its
  /// steps. F^(2/3), which is linear where the contact is elastic, is interpolated in x by a
  /// monotone cubic (PCHIP with the slopes of Fritsch & Butland, SIAM J. Sci. Stat. Comput. 5,
  /// 1984, and three-point slopes at the ends). SI units.
  class BranchInterpolant
  {
  public:
    /// @throws InputError, naming branch, point and values, where a branch has fewer than 5 points,
    /// holds a number that is not finite, does not increase (decrease) strictly, does not begin at
    /// (0, 0) (end at F = 0), or where both branches do not share their peak.
    BranchInterpolant(const Curve &curve, Branch branch);

    double x_max() const { return largest_x; }           ///< m
    double force_max() const { return largest_force; }   ///< N
    double origin() const { return approach_at_zero_x; } ///< δ where x = 0: 0 or δ_res, m

    /// F at x, N. @throws InputError outside [0, x_max].
    double force_at(double x) const;

    /// x at F, m, to 1e-15 of x_max. @throws InputError outside [0, force_max].
    double x_at(double force) const;

  private:
    std::function<double(double)> power_of_force; ///< (F/F_max)^(2/3) over x/x_max
    double                        largest_x          = 0;
    double                        largest_force      = 0;
    double                        approach_at_zero_x = 0;
  };

  /// A branch at x_i = i x_max/n, i = 1…n. SI units.
  struct ResampledBranch
  {
    std::vector<double> x;      ///< δ or δ − δ_res, m
    std::vector<double> force;  ///< N; its last is F_max
    double              origin; ///< 0 or δ_res, m
  };

  /// Resamples a branch by BranchInterpolant.
  /// @throws InputError as BranchInterpolant does, and where n_points < 4.
  ResampledBranch resample(const Curve &curve, Branch branch, unsigned int n_points = 200);
} // namespace dpcontact

#endif
