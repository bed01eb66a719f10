#ifndef DPCONTACT_RUNS_DEM_CONTACT_HISTORY_H
#define DPCONTACT_RUNS_DEM_CONTACT_HISTORY_H

#include "runs/dem/lammps_headers.h"

#include <fix.h>
#include <vector>

namespace dpcontact::dem
{
  /// LAMMPS fix `dpcontact/history`: the largest overlap of every contact, kept with both of its
  /// atoms. It moves with them between processes and is written to restart files. The pair style
  /// adds the fix; an input need not mention it.
  class FixContactHistory : public LAMMPS_NS::Fix
  {
  public:
    static constexpr const char *style_name  = "dpcontact/history";
    static constexpr const char *instance_id = "dpcontact_history";

    FixContactHistory(LAMMPS_NS::LAMMPS *lammps, int count, char **words);
    ~FixContactHistory() override;

    /// The largest overlap of local atom i and the atom of this tag; 0 for a new contact.
    double peak(int i, LAMMPS_NS::tagint partner) const;
    void   set_peak(int i, LAMMPS_NS::tagint partner, double peak);
    /// To be called when the bodies have parted: should they meet again, it is at other places.
    void forget(int i, LAMMPS_NS::tagint partner);

    int    setmask() override { return 0; }
    void   grow_arrays(int count) override;
    void   copy_arrays(int from, int to, int delete_flag) override;
    void   set_arrays(int i) override;
    int    pack_exchange(int i, double *buffer) override;
    int    unpack_exchange(int i, double *buffer) override;
    int    pack_restart(int i, double *buffer) override;
    void   unpack_restart(int i, int nth) override;
    int    size_restart(int i) override;
    int    maxsize_restart() override;
    double memory_usage() override;

  private:
    struct Contact
    {
      LAMMPS_NS::tagint partner;
      double            peak;
    };
    /// An atom's contacts in a buffer: their number, then partner and peak of each. Both give the
    /// number of doubles.
    int  pack(int i, double *buffer);
    int  unpack(int i, const double *buffer);
    auto find(int i, LAMMPS_NS::tagint partner);

    std::vector<std::vector<Contact>> contacts; ///< of local atoms, by their index
  };
} // namespace dpcontact::dem

#endif
