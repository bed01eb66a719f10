#include "solver/path/solution.h"

#include "solver/closed_form/hertz.h"
#include "solver/closed_form/plausibility.h"
#include "solver/problem/quantity.h"

#include <sys/resource.h>

namespace dpcontact
{
  namespace
  {
    bool has_cutoff(const Case &input)
    {
      const auto &second = input.scene.second;
      return input.material.tension_cutoff ||
             (second && second->material && second->material->tension_cutoff);
    }
  } // namespace

  void add_warnings(const Case &input, Solution &solution)
  {
    for (std::string &doubt : doubts_about(input, solution.curve.loading.back().contact_radius))
      solution.warnings.push_back(std::move(doubt));
    const CurvePoint &peak  = solution.curve.loading.back();
    const double      hertz = hertz::approach(input.material, input.scene, peak.force);
    constexpr double  shown = 2e-3; // more than mesh and steps leave
    if (peak.approach < (1 - shown) * hertz && has_cutoff(input))
      solution.warnings.push_back(
        "the approach at the peak is " + format_quantity(peak.approach / hertz, Dimension::number) +
        " of Hertz's: material that has opened in tension beside the contact stays open when the "
        "contact grows over it, and carries it");
    const double strain = solution.curve.unloading.back().plastic_strain_max;
    if (strain > 0.1)
      solution.warnings.push_back("small strain is left behind: the largest plastic strain is " +
                                  format_quantity(strain, Dimension::number) + " (> 0.1)");
  }

  std::uint64_t peak_memory()
  {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
  }
} // namespace dpcontact
