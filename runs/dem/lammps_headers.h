#ifndef DPCONTACT_RUNS_DEM_LAMMPS_HEADERS_H
#define DPCONTACT_RUNS_DEM_LAMMPS_HEADERS_H

// Debian's LAMMPS (20220106) calls fmt 8's make_args_checked, which Debian's fmt 9 no longer has.
// Include this before any of its headers. Call Error::all and Error::one with a std::string: their
// overloads for literals need the library of fmt 8.
#include <fmt/format.h>

namespace fmt
{
  template <typename... Args, typename Format>
  auto make_args_checked(const Format &, const std::remove_reference_t<Args> &...args)
  {
    return fmt::make_format_args(args...);
  }
} // namespace fmt

#endif
