#ifndef DPCONTACT_RUNS_DEM_CONTACT_HISTORY_H
#define DPCONTACT_RUNS_DEM_CONTACT_HISTORY_H

#include "runs/dem/lammps_headers.h"

#include <array>
#include <cstdint>
#include <fix.h>
#include <functional>
#include <vector>

namespace dpcontact::dem
{
  /// LAMMPS fix `dpcontact/history`: the largest overlap of every contact, kept with both of its
  /// grains. It moves with them between processes and is written to restart files. The pair style
  /// adds the fix; an input need not mention it.
  ///
  /// A contact is that of two grains at one image. The grains are told by identities of the fix's
  /// own, because LAMMPS renumbers the IDs of atoms (delete_atoms, reset_atom_ids), by which its
  /// own fix NEIGH_HISTORY finds a contact again. Images of one grain are told by where it was
  /// seen: they lie a box apart, whereas a contact moves little from one computation of forces to
  /// the next.
  class FixContactHistory : public LAMMPS_NS::Fix
  {
  public:
    static constexpr const char *style_name  = "dpcontact/history";
    static constexpr const char *instance_id = "dpcontact_contacts";

    using Vector = std::array<double, 3>;

    FixContactHistory(LAMMPS_NS::LAMMPS *lammps, int count, char **words);
    ~FixContactHistory() override;

    /// Brackets a computation of forces. What none of its calls of peak() asked for is forgotten:
    /// the bodies have parted, and should they meet again, it is at other places. With `newton on`,
    /// where one process alone computes a contact, the owners of the others' grains get its peaks.
    void begin_forces();
    void end_forces();

    /// The largest overlap so far of local atom i, or of ghost i with `newton on`, with atom j at
    /// x_i − x_j = separation; 0 for a new contact. The reference holds until the next call.
    double &peak(int i, int j, const Vector &separation);

    /// Called after each run.
    std::function<void()> after_run;

    int    setmask() override { return 0; }
    void   post_run() override;
    void   grow_arrays(int count) override;
    void   copy_arrays(int from, int to, int delete_flag) override;
    void   set_arrays(int i) override;
    int    pack_border(int count, int *atoms, double *buffer) override;
    int    unpack_border(int count, int first, double *buffer) override;
    int    pack_exchange(int i, double *buffer) override;
    int    unpack_exchange(int i, double *buffer) override;
    int    pack_reverse_comm_size(int count, int first) override;
    int    pack_reverse_comm(int count, int first, double *buffer) override;
    void   unpack_reverse_comm(int count, int *atoms, double *buffer) override;
    void   write_restart(FILE *file) override;
    void   restart(char *buffer) override;
    int    pack_restart(int i, double *buffer) override;
    void   unpack_restart(int i, int nth) override;
    int    size_restart(int i) override;
    int    maxsize_restart() override;
    double memory_usage() override;

  private:
    using Identity = std::int64_t; ///< of a grain as long as it lives; 0 is none

    struct Contact
    {
      Identity      partner;
      Vector        separation; ///< where the partner was seen last
      double        peak;
      std::uint64_t seen; ///< the number of the computation of forces that asked for it last
    };
    struct Grain
    {
      Identity             identity = 0;
      std::vector<Contact> contacts;
    };
    static constexpr int contact_size = 5; ///< doubles of one contact in a buffer

    Grain &grain(int i) { return grains[static_cast<std::size_t>(i)]; }
    /// The contact of this grain, begun with the peak 0 where there is none.
    Contact &find(Grain &of, Identity partner, const Vector &separation);
    bool     is_same_image(const Vector &one, const Vector &other) const;

    /// A grain's contacts in a buffer, their number first. Both give the number of doubles.
    static int pack(const Grain &from, double *buffer);
    int        unpack(Grain &to, const double *buffer);

    std::vector<Grain> grains;  ///< of local atoms and ghosts, by their index
    Identity           next;    ///< the next grain that this process is given has this identity
    std::uint64_t      now = 1; ///< the number of the present computation of forces
  };
} // namespace dpcontact::dem

#endif
