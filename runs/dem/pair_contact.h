#ifndef DPCONTACT_RUNS_DEM_PAIR_CONTACT_H
#define DPCONTACT_RUNS_DEM_PAIR_CONTACT_H

#include "database/contact_law/contact_law.h"
#include "runs/dem/contact_history.h"

#include <optional>
#include <pair.h>

namespace dpcontact::dem
{
  /// LAMMPS pair style `dpcontact`: the normal force of contact_law.h between spheres of one
  /// material and any radii. `atom_style sphere`, `newton off`, SI units.
  ///
  ///     pair_style dpcontact universal TABLE.csv
  ///     pair_coeff * * E nu phi sigma_c
  ///
  ///     pair_style dpcontact row
  ///     pair_coeff * * a b m n F_y delta_y R*      # the consistent convention
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
    std::optional<ContactTable> table; ///< unset where the law is that of a row
    std::optional<ContactLaw>   law;
    FixContactHistory          *history        = nullptr;
    double                      largest_radius = 0;
  };
} // namespace dpcontact::dem

#endif
