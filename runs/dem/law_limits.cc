#include "runs/dem/law_limits.h"

#include "database/contact_law/contact_law.h"

#include <atom.h>
#include <comm.h>
#include <error.h>
#include <update.h>

using namespace LAMMPS_NS;

namespace dpcontact::dem
{
  void
  LawLimits::note(const unsigned int flags, const double relative_overlap, const int i, const int j)
  {
    const unsigned int beyond = flags & (contact_strain_large | contact_extrapolated);
    if (beyond == 0)
      return;
    const bool         first = worst.flags == 0;
    const unsigned int all   = worst.flags | beyond;
    if (first || relative_overlap > worst.relative_overlap)
      worst = {relative_overlap, all, atom->tag[i], atom->tag[j], update->ntimestep};
    worst.flags = all;
    if (first)
      error->warning(FLERR, "pair_style dpcontact: a contact " + text(worst));
  }

  void LawLimits::end_run()
  {
    int flags = static_cast<int>(worst.flags), all = 0;
    const struct
    {
      double overlap;
      int    rank;
    } mine{worst.relative_overlap, comm->me};
    auto largest = mine;
    MPI_Allreduce(&flags, &all, 1, MPI_INT, MPI_BOR, world);
    MPI_Allreduce(&mine, &largest, 1, MPI_DOUBLE_INT, MPI_MAXLOC, world);
    if (all == 0)
      return;
    MPI_Bcast(&worst, sizeof worst, MPI_BYTE, largest.rank, world);
    worst.flags = static_cast<unsigned int>(all);
    if (comm->me == 0)
      error->warning(FLERR, "pair_style dpcontact: the deepest contact of this run " + text(worst));
    worst = {};
  }

  std::string LawLimits::text(const Contact &contact)
  {
    std::string limits;
    if ((contact.flags & contact_strain_large) != 0)
      limits = "small strain, which the law assumes (contact radius up to a tenth of the radius)";
    if ((contact.flags & contact_extrapolated) != 0)
      limits += std::string(limits.empty() ? "" : " and ") + "the universal table";
    return fmt::format("is beyond {}: atoms {} and {} overlap by {:.3g} of the smaller radius at "
                       "step {}",
                       limits,
                       contact.first,
                       contact.second,
                       contact.relative_overlap,
                       contact.step);
  }
} // namespace dpcontact::dem
