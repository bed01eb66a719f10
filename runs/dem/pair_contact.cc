#include "runs/dem/pair_contact.h"

#include "database/files/digest.h"

#include <algorithm>
#include <atom.h>
#include <cmath>
#include <comm.h>
#include <cstring>
#include <error.h>
#include <force.h>
#include <memory.h>
#include <modify.h>
#include <neigh_list.h>
#include <neighbor.h>
#include <sstream>
#include <utils.h>

using namespace LAMMPS_NS;

namespace dpcontact::dem
{
  namespace
  {
    /// The largest radius that fixes which insert grains state, 0 where none does.
    double largest_inserted_radius(const Modify &modify, const int types)
    {
      double largest = 0;
      for (int k = 0; k < modify.nfix; ++k)
        {
          Fix *const inserter = modify.fix[k];
          if (std::strncmp(inserter->style, "pour", 4) != 0 &&
              std::strncmp(inserter->style, "deposit", 7) != 0)
            continue;
          for (int type = 1; type <= types; ++type)
            {
              int asked = type; // the fix overwrites it
              if (const auto *radius =
                    static_cast<const double *>(inserter->extract("radius", asked)))
                largest = std::max(largest, *radius);
            }
        }
      return largest;
    }
  } // namespace

  PairContact::PairContact(LAMMPS_NS::LAMMPS *lammps)
    : Pair(lammps)
    , limits(lammps)
  {
    single_enable = 0;
    restartinfo   = 0; // the input says pair_style and pair_coeff again
    no_virial_fdotr_compute =
      1; // virial by pairs: with newton off ghosts are computed on both sides
  }

  PairContact::~PairContact()
  {
    if (copymode)
      return;
    if (modify->find_fix(FixContactHistory::instance_id) >= 0)
      modify->delete_fix(FixContactHistory::instance_id);
    if (allocated)
      {
        memory->destroy(setflag);
        memory->destroy(cutsq);
      }
  }

  // One process reads, so that all see one content or one error.
  ContactTable PairContact::read_table(const std::string &file) const
  {
    std::string text, problem;
    if (comm->me == 0)
      try
        {
          text = read_with_digest(file);
        }
      catch (const std::exception &failure)
        {
          problem = failure.what();
        }
    for (std::string *const each : {&text, &problem})
      {
        int size = static_cast<int>(each->size());
        MPI_Bcast(&size, 1, MPI_INT, 0, world);
        each->resize(static_cast<std::size_t>(size));
        MPI_Bcast(each->data(), size, MPI_CHAR, 0, world);
      }
    if (!problem.empty())
      error->all(FLERR, "pair_style dpcontact: " + problem);
    std::istringstream stream(text);
    try
      {
        return ContactTable::read(stream);
      }
    catch (const std::exception &failure)
      {
        error->all(FLERR, "pair_style dpcontact: " + file + ": " + failure.what());
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
    table = read_table(words[1]);
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
    allocate();

    // Here, so that fixes that the input defines afterwards come after it, and so that after
    // read_restart it finds what the file holds for it before atoms are added or deleted.
    if (history == nullptr)
      history = dynamic_cast<FixContactHistory *>(modify->add_fix(
        std::string(FixContactHistory::instance_id) + " all " + FixContactHistory::style_name));
    history->after_run = [this] { limits.end_run(); };
  }

  void PairContact::allocate()
  {
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
    if (atom->tag_enable == 0)
      error->all(FLERR, std::string("pair_style dpcontact needs atom IDs"));
    neighbor->request(this, instance_me);

    double largest = largest_inserted_radius(*modify, atom->ntypes);
    for (int i = 0; i < atom->nlocal; ++i)
      largest = std::max(largest, atom->radius[i]);
    MPI_Allreduce(&largest, &largest_radius, 1, MPI_DOUBLE, MPI_MAX, world);
  }

  double PairContact::init_one(int, int) { return 2 * largest_radius; }

  void PairContact::compute(const int eflag, const int vflag)
  {
    ev_init(eflag, vflag);
    history->begin_forces();
    for (int n = 0; n < list->inum; ++n)
      compute_neighbours(list->ilist[n]);
    history->end_forces();
  }

  void PairContact::compute_neighbours(const int i)
  {
    constexpr double rounding = 1e-9; // fix pour may draw a radius that exceeds its largest so much
    double *const *const x = atom->x, *const *const f = atom->f;
    const double *const radius = atom->radius;
    if (radius[i] > largest_radius * (1 + rounding))
      error->one(FLERR,
                 fmt::format("pair_style dpcontact: atom {} of radius {:g} is larger than the list "
                             "of neighbours is made for, radius {:g}, so that contacts would be "
                             "missed; begin a new run after such a grain is made",
                             atom->tag[i],
                             radius[i],
                             largest_radius));
    for (int k = 0; k < list->numneigh[i]; ++k)
      {
        const int                       j = list->firstneigh[i][k] & NEIGHMASK;
        const FixContactHistory::Vector d{x[i][0] - x[j][0], x[i][1] - x[j][1], x[i][2] - x[j][2]};
        const double                    squared = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
        const double                    reach   = radius[i] + radius[j];
        if (squared >= reach * reach)
          continue;
        const double per_distance = force_per_distance(i, j, d, std::sqrt(squared));
        const bool   both         = force->newton_pair != 0 || j < atom->nlocal;
        for (int c = 0; c < 3; ++c)
          {
            f[i][c] += per_distance * d[static_cast<std::size_t>(c)];
            if (both)
              f[j][c] -= per_distance * d[static_cast<std::size_t>(c)];
          }
        if (evflag)
          ev_tally(i, j, atom->nlocal, force->newton_pair, 0, 0, per_distance, d[0], d[1], d[2]);
      }
  }

  double PairContact::force_per_distance(const int                        i,
                                         const int                        j,
                                         const FixContactHistory::Vector &d,
                                         const double                     distance)
  {
    const double one = atom->radius[i], other = atom->radius[j];
    const double overlap = one + other - distance, relative = overlap / std::min(one, other);
    if (!(relative < 1)) // no number as well
      error->one(FLERR,
                 fmt::format("pair_style dpcontact: atoms {} and {} overlap by {:.3g} of the "
                             "smaller radius: the centre of one lies within the other",
                             atom->tag[i],
                             atom->tag[j],
                             relative));
    double      &peak = history->peak(i, j, d);
    ContactState state{peak};
    const auto [magnitude, flags] =
      law->evaluate(overlap, ContactLaw::effective_radius(one, other), state);
    peak = state.peak_overlap;
    if (force->newton_pair != 0 || j < atom->nlocal)
      history->peak(j, i, {-d[0], -d[1], -d[2]}) = state.peak_overlap;
    limits.note(flags, relative, i, j);
    return magnitude / distance;
  }
} // namespace dpcontact::dem
