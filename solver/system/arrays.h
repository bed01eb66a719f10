#ifndef DPCONTACT_SOLVER_SYSTEM_ARRAYS_H
#define DPCONTACT_SOLVER_SYSTEM_ARRAYS_H

#include "meshing/errors.h"

#include <algorithm>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

namespace dpcontact
{
  /// Numbers by name: the state of a computation in a form that any file can hold.
  using Arrays = std::map<std::string, std::vector<double>>;

  /// The array of that name.
  /// @throws InputError where it is missing or its size is none of `sizes`.
  inline const std::vector<double> &
  array(const Arrays &arrays, const std::string &name, std::initializer_list<std::size_t> sizes)
  {
    const auto found = arrays.find(name);
    if (found == arrays.end())
      throw InputError("the saved state lacks '" + name +
                       "': it is not one of this computation; start anew without it");
    if (std::find(sizes.begin(), sizes.end(), found->second.size()) == sizes.end())
      throw InputError("the saved state has " + std::to_string(found->second.size()) +
                       " numbers of '" + name +
                       "': it is not one of this mesh; start anew without it");
    return found->second;
  }
} // namespace dpcontact

#endif
