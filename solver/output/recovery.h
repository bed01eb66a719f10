#ifndef DPCONTACT_SOLVER_OUTPUT_RECOVERY_H
#define DPCONTACT_SOLVER_OUTPUT_RECOVERY_H

#include "solver/output/field_sink.h"

#include <array>
#include <string>
#include <vector>

namespace dpcontact
{
  namespace laws
  {
    enum class Branch : unsigned char; // laws/point.h, which includes deal.II
  }
  template <int dim>
  class ContactSystem;
  struct UnitSystem;

  /// Stress on the axis of symmetry.
  struct AxisPoint
  {
    double depth;         ///< m
    double axial_stress;  ///< σ_z, Pa, tension positive
    double radial_stress; ///< σ_r = σ_θ, Pa
  };

  /// State of a material point, stresses tension positive.
  struct PointState
  {
    double                radius, depth; ///< m
    double                volume;        ///< share of one sphere's volume that it stands for, m³
    double                radial_stress, axial_stress, hoop_stress, shear_stress; ///< Pa
    std::array<double, 3> principal_stress; ///< σ₁ ≥ σ₂ ≥ σ₃, Pa
    double                mises_stress;     ///< Pa
    double                plastic_strain;   ///< accumulated, ∫ √(2/3) |dεᵖ|
    laws::Branch          branch;           ///< of the load step that led here
  };

  /// Gives out displacement, stress, pressure, Mises stress and accumulated plastic strain of the
  /// state last evaluated as VTU files (ParaView), in SI units and linear within each cell, from
  /// its quadrature points: STATE.vtu; over several processes STATE.0.vtu, STATE.1.vtu and so on,
  /// and STATE.pvtu, which names them. Of two bodies the second is in STATE-2, as the mirror image
  /// that it is in the model.
  /// @param units of the system.
  /// @param state what the files are called, without extension.
  /// @param sink is given every file. @throws what it throws.
  template <int dim>
  void write_fields(const ContactSystem<dim> &system,
                    const UnitSystem         &units,
                    const std::string        &state,
                    const FieldSink          &sink);

  /// Stresses of the first body on the axis r = 0 from the surface downwards, in SI units, by the
  /// same linear recovery, each value at the end of a cell's edge and the mean of the cells that
  /// meet there.
  std::vector<AxisPoint> axis_profile(const ContactSystem<2> &system, const UnitSystem &units);

  /// The state at every quadrature point of the first body as last evaluated and committed, in SI
  /// units.
  std::vector<PointState> point_states(const ContactSystem<2> &system, const UnitSystem &units);
} // namespace dpcontact

#endif
