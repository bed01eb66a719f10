#include "solver/laws/criterion.h"

#include "meshing/errors.h"

#include <algorithm>
#include <cmath>

namespace dpcontact
{
  // Each stands beside its law, in <law>_criterion.cc.
  CriterionDefinition drucker_prager_criterion();
  CriterionDefinition von_mises_criterion();
  CriterionDefinition mohr_coulomb_criterion();

  const std::vector<CriterionDefinition> &criteria()
  {
    static const std::vector<CriterionDefinition> all = {
      drucker_prager_criterion(), von_mises_criterion(), mohr_coulomb_criterion()};
    return all;
  }

  const CriterionDefinition &definition_of(const Criterion criterion)
  {
    return *std::find_if(
      criteria().begin(), criteria().end(), [criterion](const CriterionDefinition &definition) {
        return definition.criterion == criterion;
      });
  }

  double shear_strength(const Material &material)
  {
    return definition_of(material.criterion).shear_strength(material);
  }

  double inscribed_cone(const Material &material)
  {
    return definition_of(material.criterion).inscribed_cone(material);
  }

  MaterialParameter dilation_parameter()
  {
    MaterialParameter p;
    p.name         = "dilation";
    p.symbol       = "psi";
    p.title        = "dilation angle psi";
    p.help         = "dilation angle in degrees, 0 to phi";
    p.description  = "dilation angle; phi_deg where flow is associated";
    p.dimension    = Dimension::angle;
    p.range        = {0, 90, false, true};
    p.default_text = "phi: associated";
    p.get          = [](const Material &m) { return m.flow_angle().degrees(); };
    p.set          = [](Material &m, const double degrees) {
      m.dilation_angle.reset();
      if (std::isnan(degrees) || degrees == m.friction_angle.degrees())
        return;
      m.dilation_angle = Angle(degrees);
    };
    return p;
  }

  void check_dilation(const Material &material)
  {
    const double psi = material.flow_angle().degrees();
    if (!std::isfinite(psi) || psi < 0 || psi > material.friction_angle.degrees())
      refuse_value(
        "dilation angle psi", psi, Dimension::angle, "at least 0 and at most the friction angle");
  }

  MaterialParameter hardening_parameter()
  {
    MaterialParameter p;
    p.name          = "hardening";
    p.symbol        = "H";
    p.title         = "hardening modulus H";
    p.help          = "growth of the uniaxial strength with plastic strain";
    p.description   = "growth of the uniaxial strength with equivalent plastic strain";
    p.dimension     = Dimension::pressure;
    p.default_value = 0;
    p.get           = [](const Material &m) { return m.hardening; };
    p.set           = [](Material &m, const double value) { m.hardening = value; };
    return p;
  }
} // namespace dpcontact
