#include "solver/path/pilot.h"

#include "solver/closed_form/hertz.h"
#include "solver/path/runs.h"

#include <cmath>

namespace dpcontact
{
  namespace
  {
    constexpr unsigned int pilot_resolution = 16;
    constexpr unsigned int pilot_steps      = 10;
    constexpr unsigned int most_pilots      = 5;
    constexpr double       pilot_accuracy   = 0.04; ///< of the contact radius, relative
  }                                                 // namespace

  Pilot run_pilots(const Material     &material,
                   const Scene        &scene,
                   const FirstYield   &yield,
                   Cost               &cost,
                   const StepObserver &observer)
  {
    const double elastic = hertz::approach(material, scene, scene.force_max);
    Pilot        pilot{hertz::contact_radius(scene, elastic), 1};
    if (scene.force_max <= yield.onset_force())
      return pilot;
    // Defaults but for the mesh: what is varied in a study must not move the mesh it is studied on.
    SolverOptions coarse;
    coarse.resolution = pilot_resolution;
    for (unsigned int k = 0; k < most_pilots; ++k)
      {
        HalfSpaceModel model(material, scene, coarse, pilot.contact_radius);
        const auto     peak = run_to_peak(model, pilot_steps, observer).back();
        add_cost(cost, model);
        const double change  = peak.contact_radius / pilot.contact_radius - 1;
        pilot.contact_radius = peak.contact_radius;
        pilot.approach       = peak.approach / elastic;
        if (std::abs(change) < pilot_accuracy)
          break;
      }
    return pilot;
  }
} // namespace dpcontact
