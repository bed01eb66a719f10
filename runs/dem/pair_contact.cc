#include "runs/dem/pair_contact.h"

#include <algorithm>
#include <atom.h>
#include <cmath>
#include <comm.h>
#include <error.h>
#include <force.h>
#include <fstream>
#include <memory.h>
#include <modify.h>
#include <neigh_list.h>
#include <neighbor.h>
#include <string>
#include <utils.h>

using namespace LAMMPS_NS;

namespace dpcontact::dem
{
  PairContact::PairContact(LAMMPS_NS::LAMMPS *lammps)
    : Pair(lammps)
  {
    single_enable           = 0;
    restartinfo             = 0; // the input says pair_style and pair_coeff again
    no_virial_fdotr_compute = 1; // virial by pairs: ghosts are computed on both sides
  }

  PairContact::~PairContact()
  {
    if (allocated && !copymode)
      {
        memory->destroy(setflag);
        memory->destroy(cutsq);
      }
  }

  void PairContact::settings(const int count, char **words)
  {
    const std::string kind = count > 0 ? words[0] : "";
    law.reset();
    table.reset();
    if (kind == "row" && count == 1)
      return;
    if (kind != "universal" || count != 2)
      error->all(FLERR, std::string("pair_style dpcontact: say 'universal TABLE.csv' or 'row'"));
    std::ifstream file(words[1]);
    if (!file)
      error->all(FLERR, std::string("pair_style dpcontact: cannot read ") + words[1]);
    try
      {
        table = ContactTable::read(file);
      }
    catch (const std::exception &problem)
      {
        error->all(FLERR, std::string("pair_style dpcontact: ") + problem.what());
      }
  }

  void PairContact::coeff(const int count, char **words)
  {
    const int numbers = table ? 4 : 7;
    if (count != 2 + numbers || std::string(words[0]) != "*" || std::string(words[1]) != "*")
      error->all(FLERR,
                 table ? std::string("pair_coeff of dpcontact universal: * * E nu phi sigma_c")
                       : std::string("pair_coeff of dpcontact row: * * a b m n F_y delta_y R*"));
    std::vector<double> v;
    for (int k = 2; k < count; ++k)
      v.push_back(utils::numeric(FLERR, words[k], false, lmp));
    try
      {
        law = table ? ContactLaw::universal({v[0], v[1], v[2], v[3]}, *table)
                    : ContactLaw::from_row({v[0], v[1], v[2], v[3], v[4], v[5], v[6]});
      }
    catch (const std::exception &problem)
      {
        error->all(FLERR, std::string("pair_coeff of dpcontact: ") + problem.what());
      }
    const int n = atom->ntypes;
    if (!allocated)
      {
        allocated = 1;
        memory->create(setflag, n + 1, n + 1, "pair:setflag");
        memory->create(cutsq, n + 1, n + 1, "pair:cutsq");
      }
    for (int i = 1; i <= n; ++i)
      for (int j = 1; j <= n; ++j)
        setflag[i][j] = j >= i ? 1 : 0;
  }

  void PairContact::init_style()
  {
    if (atom->radius == nullptr)
      error->all(FLERR, std::string("pair_style dpcontact needs atom_style sphere"));
    if (force->newton_pair != 0)
      error->all(
        FLERR,
        std::string("pair_style dpcontact needs newton off: both sides of a contact keep it"));
    if (atom->tag_enable == 0)
      error->all(FLERR, std::string("pair_style dpcontact needs atom IDs"));
    neighbor->request(this, instance_me);

    // After read_restart the fix finds what the file holds for it.
    if (modify->find_fix(FixContactHistory::instance_id) < 0)
      modify->add_fix(std::string(FixContactHistory::instance_id) + " all " +
                      FixContactHistory::style_name);
    history = dynamic_cast<FixContactHistory *>(
      modify->fix[modify->find_fix(FixContactHistory::instance_id)]);

    double largest = 0;
    for (int i = 0; i < atom->nlocal; ++i)
      largest = std::max(largest, atom->radius[i]);
    MPI_Allreduce(&largest, &largest_radius, 1, MPI_DOUBLE, MPI_MAX, world);
  }

  double PairContact::init_one(int, int) { return 2 * largest_radius; }

  void PairContact::compute(const int eflag, const int vflag)
  {
    ev_init(eflag, vflag);
    double *const *const x      = atom->x;
    double *const *const f      = atom->f;
    const double *const  radius = atom->radius;
    const tagint *const  tag    = atom->tag;
    const int            local  = atom->nlocal;

    for (int n = 0; n < list->inum; ++n)
      {
        const int i = list->ilist[n];
        for (int k = 0; k < list->numneigh[i]; ++k)
          {
            const int    j = list->firstneigh[i][k] & NEIGHMASK;
            const double d[3]{x[i][0] - x[j][0], x[i][1] - x[j][1], x[i][2] - x[j][2]};
            const double squared = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
            const double reach   = radius[i] + radius[j];
            if (squared >= reach * reach)
              {
                history->forget(i, tag[j]);
                if (j < local)
                  history->forget(j, tag[i]);
                continue;
              }
            const double distance = std::sqrt(squared);
            ContactState state{history->peak(i, tag[j])};
            const double before = state.peak_overlap;
            const double magnitude =
              law
                ->evaluate(
                  reach - distance, ContactLaw::effective_radius(radius[i], radius[j]), state)
                .force;
            if (state.peak_overlap != before)
              {
                history->set_peak(i, tag[j], state.peak_overlap);
                if (j < local)
                  history->set_peak(j, tag[i], state.peak_overlap);
              }
            const double per_distance = magnitude / distance;
            for (int c = 0; c < 3; ++c)
              {
                f[i][c] += per_distance * d[c];
                if (j < local)
                  f[j][c] -= per_distance * d[c];
              }
            if (evflag)
              ev_tally(i, j, local, 0, 0, 0, per_distance, d[0], d[1], d[2]);
          }
      }
  }
} // namespace dpcontact::dem
