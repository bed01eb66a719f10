#ifndef DPCONTACT_RUNS_DEM_LAW_LIMITS_H
#define DPCONTACT_RUNS_DEM_LAW_LIMITS_H

#include "runs/dem/lammps_headers.h"

#include <pointers.h>
#include <string>

namespace dpcontact::dem
{
  /// Says where contacts leave what the law is made for: small strain, and the universal table. A
  /// warning tells of the first in a run, and one at the run's end of the worst.
  class LawLimits : protected LAMMPS_NS::Pointers
  {
  public:
    using Pointers::Pointers;

    /// Notes the contact of atoms i and j if these bits of ContactFlag say that it is beyond.
    /// The overlap is relative to the smaller radius.
    void note(unsigned int flags, double relative_overlap, int i, int j);

    /// Called by all processes. What follows is another run.
    void end_run();

  private:
    struct Contact
    {
      double            relative_overlap = 0;
      unsigned int      flags            = 0; ///< of the whole run; 0 where nothing is beyond
      LAMMPS_NS::tagint first = 0, second = 0;
      LAMMPS_NS::bigint step = 0;
    };
    static std::string text(const Contact &contact);

    Contact worst;
  };
} // namespace dpcontact::dem

#endif
