#include "solver/path/solution.h"

#include <sstream>
#include <sys/resource.h>

namespace dpcontact
{
  void add_warnings(const Scene &scene, Solution &solution)
  {
    const auto        &peak = solution.curve.loading.back();
    std::ostringstream text;
    if (peak.contact_radius > 0.1 * scene.radius)
      {
        text << "small strain is left behind: contact radius over sphere radius is "
             << peak.contact_radius / scene.radius << " (> 0.1)";
        solution.warnings.push_back(text.str());
      }
    const double strain = solution.curve.unloading.back().plastic_strain_max;
    if (strain > 0.1)
      {
        text.str("");
        text << "small strain is left behind: the largest plastic strain is " << strain
             << " (> 0.1)";
        solution.warnings.push_back(text.str());
      }
  }

  std::uint64_t peak_memory()
  {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
  }
} // namespace dpcontact
