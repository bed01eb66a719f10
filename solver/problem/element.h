#ifndef DPCONTACT_SOLVER_PROBLEM_ELEMENT_H
#define DPCONTACT_SOLVER_PROBLEM_ELEMENT_H

#include "meshing/enum_names.h"

namespace dpcontact
{
  /// Element and quadrature, in the plane and in space.
  enum class Element
  {
    /// Quadratic with 8 nodes (20 in space) and 2 Gauss points a direction. It does not lock.
    serendipity_reduced,
    /// Quadratic with 9 nodes (27 in space) and 3 Gauss points a direction.
    quadratic_full,
    /// Linear with 4 nodes (8 in space) and 2 Gauss points a direction. It locks.
    linear_full,
    /// The same as linear_full, but with the mean dilatation of the element (B̄, Hughes, Int. J.
    /// Numer. Methods Eng. 15, 1980). It does not lock.
    linear_mean_dilatation
  };

  inline bool is_linear(const Element element)
  {
    return element == Element::linear_full || element == Element::linear_mean_dilatation;
  }

  template <>
  struct EnumNames<Element>
  {
    static constexpr const char       *what     = "element";
    static constexpr EnumName<Element> values[] = {{Element::serendipity_reduced, "serendipity"},
                                                   {Element::quadratic_full, "quadratic"},
                                                   {Element::linear_full, "linear"},
                                                   {Element::linear_mean_dilatation, "brick"}};
  };
} // namespace dpcontact

#endif
