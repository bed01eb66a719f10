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
    linear_full          ///< 4-node (8-node) linear, 2 Gauss points a direction: locks
  };

  /// The name by which an element is asked for.
  inline const char *to_string(const Element element)
  {
    return element == Element::serendipity_reduced ? "serendipity"
           : element == Element::quadratic_full    ? "quadratic"
                                                   : "linear";
  }

  /// @throws InputError where `name` is none of the names that to_string() gives.
  inline Element parse_element(const std::string &name)
  {
    for (const Element element :
         {Element::serendipity_reduced, Element::quadratic_full, Element::linear_full})
      if (name == to_string(element))
        return element;
    throw InputError("element = '" + name +
                     "' is unknown; it must be serendipity, quadratic or linear");
  }
} // namespace dpcontact

#endif
