#ifndef DPCONTACT_SOLVER_RECOVERY_H
#define DPCONTACT_SOLVER_RECOVERY_H

#include "solver/contact_system.h"
#include "solver/solve.h"

#include <string>

namespace dpcontact
{
  /// Writes displacement, stress, pressure, Mises stress and accumulated plastic strain of the
  /// state last evaluated to VTU files (ParaView), linear within each cell, from its quadrature
  /// points: FILE.vtu; over several processes FILE.0.vtu, … and FILE.pvtu, which names them. Of two
  /// bodies the second is in FILE-2, as the mirror image that it is in the model.
  /// @param length, displacement, stress factors from the system's units to SI.
  /// @param file without extension.
  /// @throws FileError where the file cannot be written.
  template <int dim>
  void write_fields(const ContactSystem<dim> &system,
                    double                    length,
                    double                    displacement,
                    double                    stress,
                    const std::string        &file);

  /// Stresses of the first body on the axis r = 0 from the surface downwards, by the same linear
  /// recovery, each value at the end of a cell's edge and the mean of the cells that meet there. In
  /// the system's units.
  std::vector<AxisPoint> axis_profile(const ContactSystem<2> &system);

  /// The state at every quadrature point of the first body as last evaluated and committed, in SI
  /// units.
  /// @param length, displacement, stress factors from the system's units to SI.
  std::vector<PointState>
  point_states(const ContactSystem<2> &system, double length, double displacement, double stress);
} // namespace dpcontact

#endif
