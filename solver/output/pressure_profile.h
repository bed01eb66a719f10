#ifndef DPCONTACT_SOLVER_OUTPUT_PRESSURE_PROFILE_H
#define DPCONTACT_SOLVER_OUTPUT_PRESSURE_PROFILE_H

#include <vector>

namespace dpcontact
{
  template <int dim>
  class ContactSystem;
  struct UnitSystem;

  /// Contact pressure at one radius.
  struct PressurePoint
  {
    double radius;   ///< m
    double pressure; ///< Pa, compression positive
  };

  /// Mean contact pressure of every face of the surface at the present state, from the axis
  /// outwards, where it is positive.
  /// @param units of the system.
  template <int dim>
  std::vector<PressurePoint> pressure_profile(const ContactSystem<dim> &system,
                                              const UnitSystem         &units);

  /// How far the present contact pressure is from axisymmetric: the root mean square, over the
  /// area, of what the faces' means differ by from a profile of r alone, over the largest of them;
  /// without dimension. The profile is p² linear in r², as in Hertz, over every ring of an
  /// element's width, or of several that hold four faces. Faces across the edge are left out.
  template <int dim>
  double axisymmetry_deviation(const ContactSystem<dim> &system);
} // namespace dpcontact

#endif
