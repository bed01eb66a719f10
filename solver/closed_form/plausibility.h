#ifndef DPCONTACT_SOLVER_CLOSED_FORM_PLAUSIBILITY_H
#define DPCONTACT_SOLVER_CLOSED_FORM_PLAUSIBILITY_H

#include "solver/problem/case.h"

#include <limits>
#include <string>
#include <vector>

namespace dpcontact
{
  /// The largest load level Λ = F_max/F_y that is computed: beyond it the steps of the load no
  /// longer resolve first yield.
  constexpr double largest_load_level = 1e9;

  /// What makes a case doubtful although every number of it is in range: a modulus, a ratio σc/E,
  /// an angle, a radius or a load level that no rock and no test has (a unit was forgotten, numbers
  /// were swapped), and contacts too large for small strain. Each is a sentence for people, with
  /// the value. The order of the two bodies does not matter to what is found.
  /// @param contact_radius at the peak, m, where it is known better than from Hertz's solution, which
  /// is its lower bound
  /// @throws InputError where the case is out of range.
  std::vector<std::string>
  doubts_about(const Case &input, double contact_radius = std::numeric_limits<double>::quiet_NaN());

  /// The same of a body alone. What is not a number is not doubted.
  /// @param radius of the sphere, m; infinite: a flat
  std::vector<std::string> doubts_about(const Material &material, double radius);

  /// Refuses what cannot be a contact of two spheres: one that is wider than the smaller sphere
  /// even by Hertz's solution; load levels above `largest_load_level`; and a tension cut-off so
  /// small that the surface opens far from the contact.
  /// @throws InputError with the numbers, and where the case is out of range.
  void check_possible(const Case &input);

  /// Several sentences in one text, as rows and documents keep them; empty where there are none.
  std::string joined(const std::vector<std::string> &sentences);
} // namespace dpcontact

#endif
