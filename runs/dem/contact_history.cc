#include "runs/dem/contact_history.h"

#include <algorithm>
#include <atom.h>
#include <error.h>
#include <string>

using namespace LAMMPS_NS;

namespace dpcontact::dem
{
  namespace
  {
    constexpr int most_contacts = 128; // of one atom: LAMMPS' buffers are made for so many
  }

  FixContactHistory::FixContactHistory(LAMMPS_NS::LAMMPS *lammps, int count, char **words)
    : Fix(lammps, count, words)
  {
    restart_peratom  = 1;
    create_attribute = 1;
    maxexchange      = 1 + 2 * most_contacts;
    grow_arrays(atom->nmax);
    atom->add_callback(Atom::GROW);
    atom->add_callback(Atom::RESTART);
  }

  FixContactHistory::~FixContactHistory()
  {
    atom->delete_callback(id, Atom::GROW);
    atom->delete_callback(id, Atom::RESTART);
  }

  auto FixContactHistory::find(const int i, const tagint partner)
  {
    auto &of_atom = contacts[static_cast<std::size_t>(i)];
    return std::find_if(of_atom.begin(), of_atom.end(), [partner](const Contact &contact) {
      return contact.partner == partner;
    });
  }

  double FixContactHistory::peak(const int i, const tagint partner) const
  {
    for (const Contact &contact : contacts[static_cast<std::size_t>(i)])
      if (contact.partner == partner)
        return contact.peak;
    return 0;
  }

  void FixContactHistory::set_peak(const int i, const tagint partner, const double peak)
  {
    auto &of_atom = contacts[static_cast<std::size_t>(i)];
    if (const auto found = find(i, partner); found != of_atom.end())
      found->peak = peak;
    else if (of_atom.size() < most_contacts)
      of_atom.push_back({partner, peak});
    else
      error->one(FLERR,
                 std::string("dpcontact/history: an atom has more contacts than a buffer holds"));
  }

  void FixContactHistory::forget(const int i, const tagint partner)
  {
    auto &of_atom = contacts[static_cast<std::size_t>(i)];
    if (const auto found = find(i, partner); found != of_atom.end())
      of_atom.erase(found);
  }

  void FixContactHistory::grow_arrays(const int count)
  {
    contacts.resize(static_cast<std::size_t>(count));
  }

  void FixContactHistory::copy_arrays(const int from, const int to, int)
  {
    contacts[static_cast<std::size_t>(to)] = contacts[static_cast<std::size_t>(from)];
  }

  void FixContactHistory::set_arrays(const int i) { contacts[static_cast<std::size_t>(i)].clear(); }

  int FixContactHistory::pack(const int i, double *const buffer)
  {
    int size       = 0;
    buffer[size++] = static_cast<double>(contacts[static_cast<std::size_t>(i)].size());
    for (const Contact &contact : contacts[static_cast<std::size_t>(i)])
      {
        buffer[size++] = ubuf(contact.partner).d;
        buffer[size++] = contact.peak;
      }
    return size;
  }

  int FixContactHistory::unpack(const int i, const double *const buffer)
  {
    int   size    = 0;
    auto &of_atom = contacts[static_cast<std::size_t>(i)];
    of_atom.resize(static_cast<std::size_t>(buffer[size++]));
    for (Contact &contact : of_atom)
      {
        contact.partner = static_cast<tagint>(ubuf(buffer[size++]).i);
        contact.peak    = buffer[size++];
      }
    return size;
  }

  int FixContactHistory::pack_exchange(const int i, double *buffer) { return pack(i, buffer); }

  int FixContactHistory::unpack_exchange(const int i, double *buffer) { return unpack(i, buffer); }

  // In restart files every fix's share of an atom begins with its size.
  int FixContactHistory::pack_restart(const int i, double *buffer)
  {
    const int size = 1 + pack(i, buffer + 1);
    buffer[0]      = size;
    return size;
  }

  void FixContactHistory::unpack_restart(const int i, const int nth)
  {
    const double *share = atom->extra[i];
    for (int k = 0; k < nth; ++k)
      share += static_cast<int>(*share);
    unpack(i, share + 1);
  }

  int FixContactHistory::size_restart(const int i)
  {
    return 2 + 2 * static_cast<int>(contacts[static_cast<std::size_t>(i)].size());
  }

  int FixContactHistory::maxsize_restart() { return 2 + 2 * most_contacts; }

  double FixContactHistory::memory_usage()
  {
    double bytes = static_cast<double>(contacts.capacity() * sizeof(std::vector<Contact>));
    for (const auto &of_atom : contacts)
      bytes += static_cast<double>(of_atom.capacity() * sizeof(Contact));
    return bytes;
  }
} // namespace dpcontact::dem
