#include "solver/pilot.h"

#include "solver/hertz.h"

#include <cmath>
#include <sys/resource.h>

namespace dpcontact
{
  namespace
  {
    constexpr unsigned int pilot_resolution = 16;
    constexpr unsigned int pilot_steps      = 10;
    constexpr unsigned int most_pilots      = 5;
    constexpr double       pilot_accuracy   = 0.04; ///< of the contact radius, relative
  }                                                 // namespace

  std::uint64_t peak_memory()
  {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
  }

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
        const auto     peak = model.run_to_peak(pilot_steps, observer).back();
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
