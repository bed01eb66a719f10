#ifndef DPCONTACT_DATABASE_TABLES_UNIVERSAL_UNCERTAINTY_H
#define DPCONTACT_DATABASE_TABLES_UNIVERSAL_UNCERTAINTY_H

#include "database/tables/universal_table.h"

#include <array>
#include <vector>

namespace dpcontact
{
  /// What a lookup states an uncertainty of: ln a, b, ln m, n, ln(δ/δ_y), δ_res/δ.
  constexpr std::size_t n_outcomes = 6;
  using Outcome                    = std::array<double, n_outcomes>;

  /// What the table itself tells about how wrong an interpolated value is.
  enum UncertaintyPart
  {
    rough_along_nu,    ///< along ν, how far nodes are from what their neighbours make of them
    rough_along_phi,   ///< the same along φ
    rough_along_level, ///< the same along ln Λ
    stated_by_nodes,   ///< the numerical error that the nodes around state
    n_parts
  };

  /// Adds factor · added to the sum.
  void add_scaled(Outcome &sum, double factor, const Outcome &added);

  /// At every node of an axis, how far it is from the cubic through the two nodes before it and the
  /// two behind it, with fewer than five nodes from the straight line through its neighbours. A
  /// node too close to an end has the value of the nearest node that has such neighbours. Two nodes
  /// have their difference.
  /// @param x the nodes' places, ascending, at least two
  /// @param y the outcomes there, as many
  std::vector<Outcome> roughness(const std::vector<double> &x, const std::vector<Outcome> &y);

  /// What a node states as the numerical error of each outcome.
  Outcome numerical_of(const UniversalNode &node);

  /// The error that interpolation adds to an outcome: shares of how rough the table is.
  /// @param c the outcome
  /// @param parts by UncertaintyPart
  double stated_interpolation_error(std::size_t c, const std::array<Outcome, n_parts> &parts);

  /// The error that the computation left in an outcome: a share of what the nodes state.
  /// @param c the outcome
  /// @param parts by UncertaintyPart
  double stated_numerical_error(std::size_t                         c,
                                const std::array<Outcome, n_parts> &parts,
                                double                              phi_deg,
                                double                              load_level);
} // namespace dpcontact

#endif
