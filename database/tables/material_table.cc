#include "database/tables/material_table.h"

#include "fitting/conventions.h"
#include "meshing/errors.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dpcontact
{
  namespace
  {
    constexpr double MaterialPoint::*axes[] = {&MaterialPoint::E_Pa,
                                               &MaterialPoint::nu,
                                               &MaterialPoint::phi_deg,
                                               &MaterialPoint::sigma_c_Pa};

    std::array<double, 4> coordinates(const MaterialPoint &point)
    {
      return {point.E_Pa, point.nu, point.phi_deg, point.sigma_c_Pa};
    }

    MaterialTable::Row row_of(const Record &record)
    {
      const Coefficients &law       = record.law;
      const auto          published = record.fit.published;
      MaterialTable::Row  row{MaterialPoint::of(record.input.material),
                             {published.a, law.b, published.m, law.n}};
      const auto          total = [&](const std::size_t c) { return record.error[c].total; };
      row.error                 = {converted_uncertainty(published.a, total(0) / law.a, total(1)),
                                   total(1),
                                   converted_uncertainty(published.m, total(2) / law.m, total(3)),
                                   total(3)};
      const double by_law = std::pow(record.load_level / law.a, 1 / law.b) * record.yield.approach;
      row.peak_misfit     = std::abs(by_law / record.state.approach_peak - 1);
      row.residual_misfit =
        std::abs(record.state.approach_residual_eq18 - record.state.approach_residual) /
        record.state.approach_peak;
      return row;
    }

    /// NaN, which is unknown, where either is.
    double largest_known(const double p, const double q)
    {
      return std::isnan(p) || std::isnan(q) ? p + q : std::max(p, q);
    }

    /// The values of an axis next to one, below and above; equal where it is a value of the axis.
    std::pair<double, double> neighbours(const std::vector<MaterialTable::Row> &rows,
                                         double MaterialPoint::*const axis,
                                         const double                 value)
    {
      double lowest = rows.front().point.*axis, highest = lowest;
      for (const MaterialTable::Row &row : rows)
        {
          lowest  = std::min(lowest, row.point.*axis);
          highest = std::max(highest, row.point.*axis);
        }
      const double inside = std::clamp(value, lowest, highest);
      double       below = lowest, above = highest;
      for (const MaterialTable::Row &row : rows)
        {
          const double x = row.point.*axis;
          below          = x <= inside ? std::max(below, x) : below;
          above          = x >= inside ? std::min(above, x) : above;
        }
      return {below, above};
    }
  } // namespace

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
        table.rows.push_back(row_of(row));
      }
    std::sort(table.rows.begin(), table.rows.end(), [](const Row &p, const Row &q) {
      return coordinates(p.point) < coordinates(q.point);
    });
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

  MaterialTable::Row MaterialTable::errors_around(const MaterialPoint &point) const
  {
    std::array<std::pair<double, double>, 4> cell;
    for (std::size_t i = 0; i < cell.size(); ++i)
      cell[i] = neighbours(rows, axes[i], point.*axes[i]);
    Row largest{point, {}};
    for (const Row &row : rows)
      {
        bool inside = true;
        for (std::size_t i = 0; i < cell.size(); ++i)
          inside =
            inside && row.point.*axes[i] >= cell[i].first && row.point.*axes[i] <= cell[i].second;
        if (!inside)
          continue;
        for (std::size_t c = 0; c < 4; ++c)
          largest.error[c] = largest_known(largest.error[c], row.error[c]);
        largest.peak_misfit     = largest_known(largest.peak_misfit, row.peak_misfit);
        largest.residual_misfit = largest_known(largest.residual_misfit, row.residual_misfit);
      }
    return largest;
  }

  MaterialTable MaterialTable::without(const std::size_t row) const
  {
    MaterialTable table = *this;
    table.rows.erase(table.rows.begin() + static_cast<std::ptrdiff_t>(row));
    return table;
  }
} // namespace dpcontact
