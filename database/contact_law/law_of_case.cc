#include "database/contact_law/law_of_case.h"

#include "database/files/digest.h"
#include "database/tables/universal_checks.h"
#include "meshing/errors.h"
#include "solver/closed_form/first_yield.h"

#include <sstream>

namespace dpcontact
{
  namespace
  {
    /// The header knows no error class of ours.
    template <typename Make>
    ContactLaw checked(const Make &make)
    {
      try
        {
          return make();
        }
      catch (const std::runtime_error &error)
        {
          throw InputError(error.what());
        }
    }
  } // namespace

  ContactTable read_universal_table(const std::string &file)
  {
    const std::string text = read_with_digest(file);
    refuse_errors(check_universal(file, text), file);
    std::istringstream stream(text);
    try
      {
        return ContactTable::read(stream);
      }
    catch (const std::runtime_error &error)
      {
        throw CorruptData("'" + file + "': " + error.what());
      }
  }

  bool covers(const ContactTable &table, const Case &input)
  {
    const double nu  = input.material.poisson_ratio;
    const double phi = input.material.friction_angle.degrees();
    return is_tabulated_kind(input.material) && nu >= table.nu.front() && nu <= table.nu.back() &&
           phi >= table.phi.front() && phi <= table.phi.back();
  }

  ContactLaw contact_law(const Case &input, const ContactTable &table)
  {
    const Material &material = input.material;
    if (!is_tabulated_kind(material))
      throw InputError(std::string("the universal law is that of ") + tabulated_kind +
                       ": leave the other parameters out, or give a row of the material itself");
    return checked([&] {
      return ContactLaw::universal({material.youngs_modulus,
                                    material.poisson_ratio,
                                    material.friction_angle.degrees(),
                                    material.compressive_strength},
                                   table);
    });
  }

  ContactLaw contact_law(const Case &input, const std::vector<double> &row, const FirstYield &yield)
  {
    return checked([&] {
      return ContactLaw::from_row({row.at(0),
                                   row.at(1),
                                   row.at(2),
                                   row.at(3),
                                   yield.force,
                                   yield.approach,
                                   input.scene.radius / 2});
    });
  }
} // namespace dpcontact
