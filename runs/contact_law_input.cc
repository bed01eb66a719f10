#include "runs/contact_law_input.h"

#include "database/text.h"
#include "meshing/errors.h"

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
    std::istringstream stream(read_with_digest(file));
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
    const Material &material = input.material;
    return material.criterion == Criterion::drucker_prager && material.hardening == 0 &&
           material.flow_stress_ratio == 1 && !material.dilation_angle &&
           material.poisson_ratio >= table.nu.front() &&
           material.poisson_ratio <= table.nu.back() &&
           input.friction_angle_degrees >= table.phi.front() &&
           input.friction_angle_degrees <= table.phi.back();
  }

  ContactLaw contact_law(const Case &input, const ContactTable &table)
  {
    const Material &material = input.material;
    if (material.criterion != Criterion::drucker_prager || material.hardening != 0 ||
        material.flow_stress_ratio != 1 || material.dilation_angle)
      throw InputError("the universal law is that of perfectly plastic drucker-prager with "
                       "associated flow: leave hardening, flow-stress-ratio and dilation out");
    return checked([&] {
      return ContactLaw::universal({material.youngs_modulus,
                                    material.poisson_ratio,
                                    input.friction_angle_degrees,
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
