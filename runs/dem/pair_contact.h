#ifndef DPCONTACT_RUNS_DEM_PAIR_CONTACT_H
#define DPCONTACT_RUNS_DEM_PAIR_CONTACT_H

#include "database/contact_law/contact_law.h"
#include "runs/dem/contact_history.h"
#include "runs/dem/law_limits.h"

#include <optional>
#include <pair.h>
#include <string>

namespace dpcontact::dem
{
  /// LAMMPS pair style `dpcontact`: the normal force of contact_law.h between spheres of one
  /// material and any radii. `atom_style sphere`, `newton` on or off, SI units.
  ///
  ///     pair_style dpcontact universal TABLE.csv        # TABLE.csv.sha256 lies beside it
  ///     pair_coeff * * E nu phi sigma_c
  ///
  ///     pair_style dpcontact row
  ///     pair_coeff * * a b m n F_y delta_y R*      # the consistent convention
  ///
  /// Neighbours are listed for the largest grain that is there when a run starts, or that `fix
  /// pour` and `fix deposit` bring. These end the run with a message: a larger grain that appears
  /// otherwise, because its contacts would be missed, and the centre of one grain within another.
  /// LawLimits warns of contacts beyond what the law is made for.
  class PairContact : public LAMMPS_NS::Pair
  {
  public:
    static constexpr const char *style_name = "dpcontact";

    explicit PairContact(LAMMPS_NS::LAMMPS *lammps);
    ~PairContact() override;

    void   settings(int count, char **words) override;
    void   coeff(int count, char **words) override;
    void   init_style() override;
    double init_one(int i, int j) override;
    void   compute(int eflag, int vflag) override;

  private:
    ContactTable read_table(const std::string &file) const;
    void         allocate();
    void         compute_neighbours(int i);
    /// The force of one contact over the distance of the centres. @param d is x_i − x_j.
    double force_per_distance(int i, int j, const FixContactHistory::Vector &d, double distance);

    std::optional<ContactTable> table; ///< unset where the law is that of a row
    std::optional<ContactLaw>   law;
    FixContactHistory          *history = nullptr;
    LawLimits                   limits;
    double                      largest_radius = 0; ///< that the neighbour list is made for
  };
} // namespace dpcontact::dem

#endif
