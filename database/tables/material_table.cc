#include "database/tables/material_table.h"

#include "meshing/errors.h"

#include <algorithm>

namespace dpcontact
{
  MaterialPoint MaterialPoint::of(const Material &material)
  {
    return {material.youngs_modulus,
            material.poisson_ratio,
            material.friction_angle.degrees(),
            material.compressive_strength};
  }

  MaterialTable MaterialTable::from_rows(const Database &database)
  {
    if (database.records.empty())
      throw InputError("material table: the database has no rows");
    MaterialTable table;
    table.radius    = database.records.front().input.scene.radius;
    table.force_max = database.records.front().input.scene.force_max;
    for (const Record &row : database.records)
      {
        if (!row.converged())
          throw InputError("material table: a row failed: " + row.reason);
        if (row.input.scene.radius != table.radius || row.input.scene.force_max != table.force_max)
          throw InputError("material table: the rows differ in radius or force-max");
        if (!is_tabulated_kind(row.input.material))
          throw InputError(std::string("material table: only ") + tabulated_kind +
                           " can be looked up");
        table.rows.push_back({MaterialPoint::of(row.input.material),
                              {row.fit.published.a, row.law.b, row.fit.published.m, row.law.n}});
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
