// LAMMPS, from its own library, with the pair style `dpcontact` beside its own styles. It takes the
// options of the program lmp, among them -in FILE, -var NAME VALUE, -log and -screen.
#include "runs/dem/pair_contact.h"

#include <force.h>
#include <input.h>
#include <lammps.h>
#include <modify.h>

using namespace LAMMPS_NS;

int main(int argc, char **argv)
{
  MPI_Init(&argc, &argv);
  {
    LAMMPS lammps(argc, argv, MPI_COMM_WORLD);
    (*lammps.force->pair_map)[dpcontact::dem::PairContact::style_name] = [](LAMMPS *l) -> Pair * {
      return new dpcontact::dem::PairContact(l);
    };
    (*lammps.modify->fix_map)[dpcontact::dem::FixContactHistory::style_name] =
      [](LAMMPS *l, int count, char **words) -> Fix * {
      return new dpcontact::dem::FixContactHistory(l, count, words);
    };
    lammps.input->file();
  }
  MPI_Finalize();
  return 0;
}
