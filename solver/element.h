#ifndef DPCONTACT_SOLVER_ELEMENT_H
#define DPCONTACT_SOLVER_ELEMENT_H

#include "meshing/errors.h"

#include <string>

namespace dpcontact
{
  /// Element and quadrature.
  enum class Element
  {
    serendipity_reduced, ///< 8-node (20-node) quadratic, 2 Gauss points a direction: does not lock
    quadratic_full,      ///< 9-node (27-node) quadratic, 3 Gauss points a direction
    linear_full,         ///< 4-node (8-node) linear, 2 Gauss points a direction: locks
    /// The same with the mean dilatation of the element (B̄, Hughes, Int. J. Numer. Methods Eng. 15,
    /// 1980): does not lock.
    linear_mean_dilatation
  };

  inline bool is_linear(const Element element)
  {
    return element == Element::linear_full || element == Element::linear_mean_dilatation;
  }

  /// The name by which an element is asked for.
  inline const char *to_string(const Element element)
  {
    return element == Element::serendipity_reduced ? "serendipity"
           : element == Element::quadratic_full    ? "quadratic"
           : element == Element::linear_full       ? "linear"
                                                   : "brick";
  }

  /// @throws InputError where `name` is none of the names that to_string() gives.
  inline Element parse_element(const std::string &name)
  {
    for (const Element element : {Element::serendipity_reduced,
                                  Element::quadratic_full,
                                  Element::linear_full,
                                  Element::linear_mean_dilatation})
      if (name == to_string(element))
        return element;
    throw InputError("element = '" + name +
                     "' is unknown; it must be serendipity, quadratic, linear or brick");
  }
} // namespace dpcontact

#endif
