#include "database/material_table.h"

#include "meshing/errors.h"

#include <algorithm>

namespace dpcontact
{
  MaterialTable MaterialTable::from_rows(const Database &database)
  {
    if (database.records.empty())
      throw InputError("material table: the database has no rows");
    MaterialTable table;
    table.radius    = database.records.front().radius_m;
    table.force_max = database.records.front().force_max_N;
    for (const Record &row : database.records)
      {
        if (row.status != "converged")
          throw InputError("material table: a row failed: " + row.reason);
        if (row.radius_m != table.radius || row.force_max_N != table.force_max)
          throw InputError("material table: the rows differ in radius or force-max");
        if (row.criterion != "drucker-prager" || row.flow_stress_ratio != 1 ||
            row.dilation_deg != row.phi_deg || row.hardening_Pa != 0)
          throw InputError(
            "material table: only associated, perfectly plastic drucker-prager with K = 1 "
            "can be looked up");
        table.rows.push_back({{row.E_Pa, row.nu, row.phi_deg, row.sigma_c_Pa},
                              {row.a_published, row.b, row.m_published, row.n}});
      }
    return table;
  }

  void MaterialTable::check_inside(const MaterialPoint &point, const Outside outside) const
  {
    const auto check = [&](const char *name, double MaterialPoint::*member) {
      const auto [low, high] =
        std::minmax_element(rows.begin(), rows.end(), [&](const Row &p, const Row &q) {
          return p.point.*member < q.point.*member;
        });
      check_range(name, point.*member, low->point.*member, high->point.*member, outside);
    };
    check("E", &MaterialPoint::E_Pa);
    check("nu", &MaterialPoint::nu);
    check("phi", &MaterialPoint::phi_deg);
    check("sigma-c", &MaterialPoint::sigma_c_Pa);
  }

  MaterialTable MaterialTable::without(const std::size_t row) const
  {
    MaterialTable table = *this;
    table.rows.erase(table.rows.begin() + static_cast<std::ptrdiff_t>(row));
    return table;
  }
} // namespace dpcontact
