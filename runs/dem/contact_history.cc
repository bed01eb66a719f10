#include "runs/dem/contact_history.h"

#include <algorithm>
#include <atom.h>
#include <comm.h>
#include <domain.h>
#include <error.h>
#include <force.h>
#include <string>

using namespace LAMMPS_NS;

namespace dpcontact::dem
{
  FixContactHistory::FixContactHistory(LAMMPS_NS::LAMMPS *lammps, int count, char **words)
    : Fix(lammps, count, words)
    , next(1 + comm->me)
  {
    restart_global      = 1;
    restart_peratom     = 1;
    create_attribute    = 1;
    comm_border         = 1;
    maxexchange_dynamic = 1;
    maxexchange         = 2;
    grow_arrays(atom->nmax);
    atom->add_callback(Atom::GROW);
    atom->add_callback(Atom::RESTART);
    atom->add_callback(Atom::BORDER);
    for (int i = 0; i < atom->nlocal; ++i)
      set_arrays(i);
  }

  FixContactHistory::~FixContactHistory()
  {
    atom->delete_callback(id, Atom::GROW);
    atom->delete_callback(id, Atom::RESTART);
    atom->delete_callback(id, Atom::BORDER);
  }

  bool FixContactHistory::is_same_image(const Vector &one, const Vector &other) const
  {
    Vector moved{one[0] - other[0], one[1] - other[1], one[2] - other[2]};
    Vector shortest = moved;
    domain->minimum_image(shortest.data());
    return shortest == moved;
  }

  FixContactHistory::Contact &
  FixContactHistory::find(Grain &of, const Identity partner, const Vector &separation)
  {
    for (Contact &contact : of.contacts)
      if (contact.partner == partner && is_same_image(contact.separation, separation))
        return contact;
    if (partner == 0)
      error->one(FLERR, std::string("dpcontact/history: an atom was made that the fix never saw"));
    of.contacts.push_back({partner, separation, 0, now});
    return of.contacts.back();
  }

  double &FixContactHistory::peak(const int i, const int j, const Vector &separation)
  {
    Contact &contact   = find(grain(i), grain(j).identity, separation);
    contact.separation = separation;
    contact.seen       = now;
    return contact.peak;
  }

  void FixContactHistory::begin_forces()
  {
    ++now;
    if (force->newton_pair != 0)
      for (int j = atom->nlocal; j < atom->nlocal + atom->nghost; ++j)
        grain(j).contacts.clear();
  }

  void FixContactHistory::end_forces()
  {
    for (int i = 0; i < atom->nlocal; ++i)
      {
        auto &contacts = grain(i).contacts;
        contacts.erase(
          std::remove_if(contacts.begin(),
                         contacts.end(),
                         [this](const Contact &contact) { return contact.seen != now; }),
          contacts.end());
      }
    if (force->newton_pair != 0)
      comm->reverse_comm_fix_variable(this);

    std::size_t most = 0;
    for (int i = 0; i < atom->nlocal; ++i)
      most = std::max(most, grain(i).contacts.size());
    maxexchange = 2 + contact_size * static_cast<int>(most);
  }

  void FixContactHistory::post_run()
  {
    if (after_run)
      after_run();
  }

  void FixContactHistory::grow_arrays(const int count)
  {
    grains.resize(static_cast<std::size_t>(count));
  }

  void FixContactHistory::copy_arrays(const int from, const int to, int)
  {
    grain(to) = grain(from);
  }

  void FixContactHistory::set_arrays(const int i)
  {
    grain(i) = {next, {}};
    next += comm->nprocs; // no two processes give the same
  }

  int FixContactHistory::pack_border(const int count, int *const atoms, double *const buffer)
  {
    for (int k = 0; k < count; ++k)
      buffer[k] = ubuf(grain(atoms[k]).identity).d;
    return count;
  }

  int FixContactHistory::unpack_border(const int count, const int first, double *const buffer)
  {
    for (int k = 0; k < count; ++k)
      grain(first + k) = {ubuf(buffer[k]).i, {}};
    return count;
  }

  int FixContactHistory::pack(const Grain &from, double *const buffer)
  {
    int size       = 0;
    buffer[size++] = static_cast<double>(from.contacts.size());
    for (const Contact &contact : from.contacts)
      {
        buffer[size++] = ubuf(contact.partner).d;
        for (const double component : contact.separation)
          buffer[size++] = component;
        buffer[size++] = contact.peak;
      }
    return size;
  }

  int FixContactHistory::unpack(Grain &to, const double *const buffer)
  {
    int       size  = 0;
    const int count = static_cast<int>(buffer[size++]);
    for (int k = 0; k < count; ++k)
      {
        const Identity partner = ubuf(buffer[size++]).i;
        Vector         separation;
        for (double &component : separation)
          component = buffer[size++];
        Contact &contact   = find(to, partner, separation);
        contact.separation = separation;
        contact.peak       = buffer[size++];
      }
    return size;
  }

  int FixContactHistory::pack_exchange(const int i, double *const buffer)
  {
    buffer[0] = ubuf(grain(i).identity).d;
    return 1 + pack(grain(i), buffer + 1);
  }

  int FixContactHistory::unpack_exchange(const int i, double *const buffer)
  {
    grain(i) = {ubuf(buffer[0]).i, {}};
    return 1 + unpack(grain(i), buffer + 1);
  }

  int FixContactHistory::pack_reverse_comm_size(const int count, const int first)
  {
    int size = 0;
    for (int i = first; i < first + count; ++i)
      size += 1 + contact_size * static_cast<int>(grain(i).contacts.size());
    return size;
  }

  int FixContactHistory::pack_reverse_comm(const int count, const int first, double *const buffer)
  {
    int size = 0;
    for (int i = first; i < first + count; ++i)
      size += pack(grain(i), buffer + size);
    return size;
  }

  void
  FixContactHistory::unpack_reverse_comm(const int count, int *const atoms, double *const buffer)
  {
    int size = 0;
    for (int k = 0; k < count; ++k)
      size += unpack(grain(atoms[k]), buffer + size);
  }

  // Grains that are made after a restart get identities that none before it had.
  void FixContactHistory::write_restart(FILE *const file)
  {
    Identity first = 0;
    MPI_Allreduce(&next, &first, 1, MPI_INT64_T, MPI_MAX, world);
    if (comm->me != 0)
      return;
    const int size = sizeof first;
    if (std::fwrite(&size, sizeof size, 1, file) != 1 ||
        std::fwrite(&first, sizeof first, 1, file) != 1)
      error->one(FLERR, std::string("dpcontact/history: cannot write the restart file"));
  }

  void FixContactHistory::restart(char *const buffer)
  {
    std::copy_n(buffer, sizeof next, reinterpret_cast<char *>(&next));
    next += comm->me;
  }

  // In restart files every fix's share of an atom begins with its size.
  int FixContactHistory::pack_restart(const int i, double *const buffer)
  {
    const int size = 1 + pack_exchange(i, buffer + 1);
    buffer[0]      = size;
    return size;
  }

  void FixContactHistory::unpack_restart(const int i, const int nth)
  {
    const double *share = atom->extra[i];
    for (int k = 0; k < nth; ++k)
      share += static_cast<int>(*share);
    grain(i)    = {ubuf(share[1]).i, {}};
    maxexchange = std::max(maxexchange, 1 + unpack(grain(i), share + 2));
  }

  int FixContactHistory::size_restart(const int i)
  {
    return 3 + contact_size * static_cast<int>(grain(i).contacts.size());
  }

  int FixContactHistory::maxsize_restart()
  {
    int size = 0, largest = 0;
    for (int i = 0; i < atom->nlocal; ++i)
      size = std::max(size, size_restart(i));
    MPI_Allreduce(&size, &largest, 1, MPI_INT, MPI_MAX, world);
    return largest;
  }

  double FixContactHistory::memory_usage()
  {
    double bytes = static_cast<double>(grains.capacity() * sizeof(Grain));
    for (const Grain &each : grains)
      bytes += static_cast<double>(each.contacts.capacity() * sizeof(Contact));
    return bytes;
  }
} // namespace dpcontact::dem
